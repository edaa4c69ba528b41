//! Files: texts in, results out, and what went wrong in plain words.
//!
//! Every output of the program goes through here. [`check()`] holds all that a command reads and writes against each
//! other; an [`Output`] stands under its name only once it is whole, a [`Lasting`] one is written in place.

mod aside;
mod check;
mod lasting;
mod output;
mod place;
mod read;
mod scratch;
mod spool;
mod stream;

pub use aside::abandon;
pub use check::check;
pub use lasting::Lasting;
pub use output::{Out, Output, copy, seen_from, write_bytes};
pub use place::is_standard_output;
pub use read::{Text, below, read, read_bytes};
pub use scratch::{Scratch, ScratchReader};
pub use spool::seekable;
pub use stream::{Stream, is_waiting, print};

use std::io;
use std::path::Path;

use crate::base::{Diagnostic, Report};

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
        io::ErrorKind::StorageFull => "the device is full".to_owned(),
        _ => error.to_string(),
    }
}

/// The diagnostic for an output that could not be written: `C003`, or `C033` when its reader has gone away.
#[must_use]
pub fn unwritable(path: &Path, error: &io::Error) -> Diagnostic {
    let name = if path == Path::new("-") { "standard output".to_owned() } else { path.display().to_string() };
    let code = if error.kind() == io::ErrorKind::BrokenPipe { "C033" } else { "C003" };
    Diagnostic::new(code, format!("cannot write {name}: {}", reason(error)))
}

/// Whether all that went wrong is that the reader of an output has gone away, as in `... | head`.
#[must_use]
pub fn is_left_by_reader(report: &Report) -> bool {
    report.diagnostics.iter().all(|diagnostic| diagnostic.code == "C033")
}

/// `C031`.
fn busy(path: &Path) -> Diagnostic {
    let diagnostic = Diagnostic::new("C031", format!("another program is writing {}", path.display()));
    diagnostic.help("wait for it, or write into another file")
}
