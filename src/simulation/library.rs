//! Where the files that a circuit uses are found: modules and memory images.

use std::cell::RefCell;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::shipped::Shelf;
use crate::base::Report;
use crate::files::{self, Text};
use crate::netlist::Library;

/// Files for a circuit: in the folder that was named, beside it, anywhere in its `circuits` folder, or shipped.
#[derive(Debug)]
pub(super) struct Modules {
    folders: Vec<PathBuf>,
    root: Option<PathBuf>,
    /// Path of the circuit below `circuits/`.
    near: String,
    /// What has been read from disk.
    pub read: RefCell<Vec<PathBuf>>,
}

impl Modules {
    /// The library for a circuit file.
    pub fn of(circuit: &Text, named: Option<&Path>) -> Self {
        let beside = circuit.path.as_deref().map(|path| path.parent().unwrap_or(Path::new(".")));
        let near = circuit.name.strip_prefix("circuits/").unwrap_or(&circuit.name).to_owned();
        let root = beside.and_then(circuits_root);
        let folders = named.into_iter().chain(beside).map(Path::to_owned).collect();
        let read = RefCell::new(circuit.path.iter().cloned().collect());
        Self { folders, root, near, read }
    }

    fn on_disk(&self, file: &str) -> Option<PathBuf> {
        let near = self.folders.iter().map(|folder| folder.join(file)).find(|path| path.is_file());
        let is_it = |path: &PathBuf| path.file_name().is_some_and(|name| name == file);
        let (_, ending) = file.rsplit_once('.')?;
        near.or_else(|| files::below(self.root.as_deref()?, ending).into_iter().find(is_it))
    }
}

impl Library for Modules {
    fn find(&self, file: &str) -> Option<Result<(String, Arc<str>), Report>> {
        match self.on_disk(file) {
            Some(path) => {
                let read = files::read(&path).map(|text| (text.name, text.text));
                self.read.borrow_mut().push(path);
                Some(read)
            }
            None => Shelf { near: &self.near }.find(file),
        }
    }
}

/// The nearest folder called `circuits` that holds `folder` or is it.
pub(super) fn circuits_root(folder: &Path) -> Option<PathBuf> {
    let above = |folder: &Path| {
        folder.ancestors().find(|path| path.file_name().is_some_and(|name| name == "circuits")).map(Path::to_owned)
    };
    // By the path as it was given, so that messages name files as people do; else by the whole path.
    above(folder).or_else(|| above(&std::path::absolute(folder).ok()?))
}
