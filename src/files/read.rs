//! Files read: whole, of a bounded length, as bytes or as text.

use std::collections::{BTreeSet, HashSet};
use std::fs;
use std::io::{self, Read};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::{reason, unreadable};
use crate::base::Report;

/// The longest text that is read; no circuit or scenario comes near it.
const LONGEST_TEXT: u64 = 64 << 20;

/// A text and where it came from.
#[derive(Clone, Debug)]
pub struct Text {
    /// What messages call it: a path, for a shipped file `circuits/...`.
    pub name: String,
    /// Its place on disk; `None` for a shipped file.
    pub path: Option<PathBuf>,
    /// The text.
    pub text: Arc<str>,
}

/// All files below `folder` with one of the endings, in order of path. A folder that links lead to again is visited
/// once, by its own name if it has one here.
#[must_use]
pub fn below(folder: &Path, ending: &str) -> Vec<PathBuf> {
    let (mut found, mut seen) = (Vec::new(), HashSet::new());
    let (mut folders, mut links) = (vec![folder.to_owned()], BTreeSet::new());
    while let Some(folder) = folders.pop().or_else(|| links.pop_first()) {
        if !folder.canonicalize().is_ok_and(|whole| seen.insert(whole)) {
            continue;
        }
        let entries = fs::read_dir(folder).into_iter().flatten().flatten();
        for path in entries.map(|entry| entry.path()) {
            if path.is_dir() {
                if path.is_symlink() {
                    links.insert(path);
                } else {
                    folders.push(path);
                }
            } else if path.extension().is_some_and(|known| known == ending) {
                found.push(path);
            }
        }
    }
    found.sort();
    found
}

/// Reads a text file.
///
/// # Errors
/// `C002`: it is missing, a directory, not text, or too long.
pub fn read(path: &Path) -> Result<Text, Report> {
    let bytes = read_bytes(path)?;
    let name = path.display().to_string();
    let text = String::from_utf8(bytes).map_err(|error| {
        let line = error.as_bytes()[..error.utf8_error().valid_up_to()].iter().filter(|&&b| b == b'\n').count() + 1;
        unreadable(path, &format!("it is not text (line {line} is not UTF-8)"))
    })?;
    Ok(Text { name, path: Some(path.to_owned()), text: text.into() })
}

/// Reads a file.
///
/// # Errors
/// `C002`.
pub fn read_bytes(path: &Path) -> Result<Vec<u8>, Report> {
    let wrong = |error: io::Error| unreadable(path, &reason(&error));
    let file = fs::File::open(path).map_err(wrong)?;
    let about = file.metadata().map_err(wrong)?;
    if about.is_dir() {
        return Err(unreadable(path, "it is a directory; name a file in it").into());
    }
    let mut bytes = Vec::new();
    file.take(LONGEST_TEXT + 1).read_to_end(&mut bytes).map_err(wrong)?;
    if bytes.len() as u64 > LONGEST_TEXT {
        return Err(unreadable(path, &format!("it is longer than {} MiB", LONGEST_TEXT >> 20)).into());
    }
    Ok(bytes)
}
