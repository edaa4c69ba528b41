//! Formats of waveform files. Adding one is its file and its line in [`FORMATS`].

use std::io;
use std::path::Path;

use super::{Change, Plan, fst, vcd};
use crate::base::Diagnostic;
use crate::files::Out;

/// Every format, the first being the one of a file that says nothing.
pub static FORMATS: &[&Format] = &[&vcd::FORMAT, &fst::FORMAT];

/// A format of waveform files.
#[derive(Debug)]
pub struct Format {
    /// The ending of its files, without the dot.
    pub ending: &'static str,
    /// Begins a file: writes the header for the plan's signals, so that a change before its declaration cannot be said.
    pub begin: Begin,
}

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

/// Begins a file of a format.
pub type Begin = for<'o> fn(Box<dyn Out + 'o>, &Plan) -> io::Result<Box<dyn WaveWriter<'o> + 'o>>;

/// Writes the changes of a trace, tick by tick.
pub trait WaveWriter<'o> {
    /// Writes what changed at `tick`; the first call is the initial values. Ticks must increase.
    ///
    /// # Errors
    /// Those of the output.
    fn tick(&mut self, tick: u64, changes: &[Change]) -> io::Result<()>;

    /// Closes the file after the last tick written, and gives the output back.
    ///
    /// # Errors
    /// Those of the output.
    fn finish(self: Box<Self>) -> io::Result<Box<dyn Out + 'o>>;
}
