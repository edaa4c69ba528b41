//! The formats of waveform files. Adding one is its file and its line in [`FORMATS`].

use std::path::Path;

use super::{Format, fst, vcd};
use crate::base::Diagnostic;

/// Every format, the first being the one of a file that says nothing.
pub static FORMATS: &[&Format] = &[&vcd::FORMAT, &fst::FORMAT];

impl Format {
    /// The format that a file's name asks for by its ending; `-` is VCD.
    ///
    /// # Errors
    /// `W005` an ending that no format has.
    pub fn of(path: &Path) -> Result<&'static Format, Diagnostic> {
        let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or("");
        let known = FORMATS.iter().copied().find(|format| format.ending.eq_ignore_ascii_case(ending));
        known.or_else(|| (path == Path::new("-")).then_some(FORMATS[0])).ok_or_else(|| {
            let endings: Vec<_> = FORMATS.iter().map(|format| format!(".{}", format.ending)).collect();
            Diagnostic::new("W005", format!("the name {} does not tell a waveform format", path.display()))
                .help(format!("let it end in {}", endings.join(" or ")))
        })
    }
}
