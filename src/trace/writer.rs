//! What a format of waveform files has to offer.

use std::io;

use super::{Change, Plan};
use crate::files::Out;

/// A format of waveform files.
#[derive(Debug)]
pub struct Format {
    /// The ending of its files, without the dot.
    pub ending: &'static str,
    /// Begins a file: writes the header for the plan's signals, so that a change before its declaration cannot be said.
    pub begin: Begin,
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
