//! Files: texts in, results out, and what went wrong in plain words.

mod output;
mod read;

pub use output::{Out, Output, seen_from, write_bytes};
pub use read::{Text, below, read, read_bytes};

use std::io;
use std::path::Path;

use crate::base::Diagnostic;

/// The diagnostic for a file that cannot be read, `C002`.
#[must_use]
pub fn unreadable(path: &Path, why: &str) -> Diagnostic {
    Diagnostic::new("C002", format!("cannot read {}: {why}", path.display()))
}

/// An I/O error in plain words.
#[must_use]
pub fn reason(error: &io::Error) -> String {
    match error.kind() {
        io::ErrorKind::NotFound => "there is no such file".to_owned(),
        io::ErrorKind::PermissionDenied => "permission denied".to_owned(),
        _ => error.to_string(),
    }
}

/// The diagnostic for a file that could not be written.
#[must_use]
pub fn unwritable(path: &Path, error: &io::Error) -> Diagnostic {
    Diagnostic::new("C003", format!("cannot write {}: {}", path.display(), reason(error)))
        .help("the folder must exist and be writable")
}
