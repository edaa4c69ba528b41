//! All that a command reads and writes, held against each other before anything runs.

use std::path::{Path, PathBuf};

use super::aside;
use super::place::{Identity, Place};
use super::unwritable;
use crate::base::{Diagnostic, Report, Sources};

/// Checks the outputs of a command: none is one of its inputs, by whatever name, no two are one file, and all may be
/// written. Nothing may go into an input by standard output either. Returns the unfinished files of outputs that a
/// program which was killed has left; they are removed.
///
/// # Errors
/// `C003` an output that cannot be written, `C030` an output that is an input or another output, `C031` one that
/// another program is writing; all of them at once.
pub fn check<'p>(
    reads: impl IntoIterator<Item = &'p Path>,
    writes: impl IntoIterator<Item = &'p Path>,
) -> Result<Vec<PathBuf>, Report> {
    let reads: Vec<_> = reads.into_iter().filter(|path| path.is_file()).collect();
    let mut wrong = Vec::new();
    let mut outputs: Vec<(&Path, Place)> = Vec::new();
    for path in writes {
        match Place::of(path) {
            Ok(place) => outputs.push((path, place)),
            Err(error) => wrong.push(unwritable(path, &error)),
        }
    }
    if !outputs.iter().any(|(_, place)| *place == Place::Standard) {
        outputs.push((Path::new("-"), Place::Standard));
    }
    for (i, (path, place)) in outputs.iter().enumerate() {
        let Some(identity) = place.identity() else { continue };
        if let Some(read) = reads.iter().find(|read| Identity::of(read).as_ref() == Some(&identity)) {
            wrong.push(is_input(path, read));
        }
        if let Some((other, _)) = outputs[..i].iter().find(|(_, other)| other.identity().as_ref() == Some(&identity)) {
            let message = format!("two outputs go into one file: {} and {}", shown(other), shown(path));
            wrong.push(Diagnostic::new("C030", message).help("give each a file of its own"));
        }
    }
    if !wrong.is_empty() {
        return Err(Report::new(Sources::default(), wrong));
    }
    let files = outputs.iter().filter_map(|(_, place)| match place {
        Place::File(target) => aside::clear(target).transpose(),
        Place::Standard | Place::Stream(_) => None,
    });
    files.collect()
}

fn is_input(path: &Path, read: &Path) -> Diagnostic {
    let message = match path == read {
        true => format!("{} is read and would be overwritten", path.display()),
        false => format!("{} is the same file as {}, which is read", shown(path), read.display()),
    };
    Diagnostic::new("C030", message).help("write into another file")
}

fn shown(path: &Path) -> String {
    if path == Path::new("-") { "standard output".to_owned() } else { path.display().to_string() }
}
