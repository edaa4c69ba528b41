//! A circuit: its text, and where the modules that it uses are found.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::library::Modules;
use super::shipped;
use crate::base::Report;
use crate::files::{self, Text};
use crate::netlist::{self, Netlist};

/// A circuit that has been found, but neither read as Verilog nor checked.
#[derive(Clone, Debug)]
pub struct Circuit {
    pub(super) text: Text,
    library: Option<PathBuf>,
}

impl Circuit {
    /// The circuit in a file. Its modules are looked for beside it, anywhere in the folder `circuits` that it stands
    /// in, and among the shipped ones.
    ///
    /// # Errors
    /// `C002` a file that cannot be read.
    pub fn open(path: impl AsRef<Path>) -> Result<Self, Report> {
        Ok(Self::from(files::read(path.as_ref())?))
    }

    /// A shipped circuit by its name, such as `su1522157/interpolator`.
    ///
    /// # Errors
    /// `C001` there is none of that name.
    pub fn shipped(name: &str) -> Result<Self, Report> {
        let text = shipped::file(name, "v").ok_or_else(|| shipped::unknown(name))?;
        Ok(Self::from(text))
    }

    /// A circuit that is at hand as text; `name` is what messages call it.
    #[must_use]
    pub fn text(name: &str, text: impl Into<Arc<str>>) -> Self {
        Self::from(Text { name: name.to_owned(), path: None, text: text.into() })
    }

    /// The same circuit, whose modules are looked for in `folder` first.
    #[must_use]
    pub fn with_library(self, folder: impl Into<PathBuf>) -> Self {
        Self { library: Some(folder.into()), ..self }
    }

    /// Its name: that of its file without the ending and without the folder `circuits`.
    #[must_use]
    pub fn name(&self) -> &str {
        name_of(&self.text)
    }

    /// The text of its file.
    #[must_use]
    pub fn source(&self) -> &str {
        &self.text.text
    }

    /// The checked netlist for some parameters of the top module.
    ///
    /// # Errors
    /// All that is wrong with the circuit, at once.
    pub fn elaborate(&self, parameters: &[(String, i64)]) -> Result<Netlist, Report> {
        self.elaborate_from_files(parameters).map(|(netlist, _)| netlist)
    }

    /// The same, and the files on disk that it was read from.
    pub(super) fn elaborate_from_files(&self, parameters: &[(String, i64)]) -> Result<(Netlist, Vec<PathBuf>), Report> {
        let modules = Modules::of(&self.text, self.library.as_deref());
        let netlist = netlist::load(&self.text.name, &self.text.text, None, &modules, parameters)?;
        Ok((netlist, modules.read.take()))
    }
}

/// The name of a circuit or scenario by its file: without the ending and without the folder `circuits`.
pub(super) fn name_of(file: &Text) -> &str {
    let name = &file.name;
    let stem = name.rsplit_once('.').map_or(name.as_str(), |(stem, _)| stem);
    stem.strip_prefix("circuits/").unwrap_or(stem)
}

impl From<Text> for Circuit {
    fn from(text: Text) -> Self {
        Self { text, library: None }
    }
}
