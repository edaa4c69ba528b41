//! Reading a waveform as a whole.

use std::io::BufRead;

use super::{Waveform, input};
use crate::base::{Diagnostic, Report};

/// Reads a VCD or FST file; `name` is what messages call it. Of texts and events only the names are kept.
///
/// # Errors
/// `W010` not a VCD file, `W011` it ends too early, `W012` a command that cannot be understood or has no place there,
/// `W013` time goes back, `W014` a value for an identifier that was not declared, `W015` a vector wider than declared
/// or than 65,536 bits, or a value of another kind, `W016` two signals of one name, `W017` the input cannot be read,
/// `W019` it takes too much memory: signals of 67,108,864 bits in all, names of 64 MiB, values of 256 MiB, an FST
/// file of 64 MiB, `W020` a broken FST file. All about VCD name the line.
pub fn read(name: &str, input: impl BufRead) -> Result<Waveform, Report> {
    Waveform::gather(name, input::open(name, input)?.as_mut(), &(0..u64::MAX))
}

/// Reads a golden trace: as [`read`], but the file must be whole.
///
/// # Errors
/// Those of [`read`], and `W018` when it does not end with the time that closes every waveform of ours.
pub fn read_golden(name: &str, input: impl BufRead) -> Result<Waveform, Report> {
    let wave = read(name, input)?;
    if wave.is_closed() { Ok(wave) } else { Err(cut(name).into()) }
}

/// What is said of a golden trace without a closing time.
pub(super) fn cut(name: &str) -> Diagnostic {
    Diagnostic::new("W018", format!("{name}: the file does not end with a closing time, so it was cut off"))
        .help("take it back from the history, or write it anew with --bless")
}

#[cfg(test)]
#[path = "read_tests.rs"]
mod tests;
