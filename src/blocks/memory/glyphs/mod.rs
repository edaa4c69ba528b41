//! Glyph files: the characters of FIG. 17 as text, and the words of memory 502 and pointer table 500 that they become.
//!
//! ```text
//! // The letter D and the letter of the same shape.    Comments run from // to the end of the line.
//! glyph 44 D             its code in hexadecimal and its character; further pairs share the drawing
//!   move 0 0             the pen goes there unmarked; the origin is at the left end of the base line
//!   line 0 1000          straight on to that point
//!   line 250 1000
//!   smooth arc 600 1000  600 500      a quarter of an ellipse: towards the first point, on to the second
//!   smooth arc 600 0  250 0
//!   smooth line 0 0
//!   advance 800          the next character's origin is there: the last statement of every glyph
//! ```
//!
//! An arc from P to R towards Q leaves P in the direction of Q and comes to R from the direction of Q. It is the stroke
//! J = Qx - Rx, K = Qx - Px, L = Qy - Ry, M = Qy - Py; a line by (A, B) is J = 0, K = A, L = 0, M = B. `smooth` says
//! that the pen does not turn where this stroke begins; a turn of 2 degrees or more there is a mistake.
//!
//! # Codes
//!
//! | code | what is wrong |
//! |------|---------------|
//! | G001 | something else was expected here |
//! | G002 | a number: digits or range |
//! | G003 | a code: digits, or given twice |
//! | G004 | a statement out of its order |
//! | G005 | a stroke of no length, or a joint that is not smooth |
//! | G006 | more words than the memory holds |

mod line;
mod pen;
mod read;

use self::read::read;
use crate::base::{Diagnostic, MemoryImage, SourceId};
use crate::blocks::ImageFormat;

const PARAMETER: &str = "IMAGE";
const ENDING: &str = "glyphs";
const SUMMARY: &str = "characters as strokes, see `docs/characters.md`";

/// A glyph file as the words of memory 502, 16 bits each.
pub(super) static INSTRUCTIONS: ImageFormat =
    ImageFormat { parameter: PARAMETER, ending: ENDING, summary: SUMMARY, read: instructions };

/// A glyph file as pointer table 500: for each code the address of its set, above it a bit that says there is one.
pub(super) static POINTERS: ImageFormat =
    ImageFormat { parameter: PARAMETER, ending: ENDING, summary: SUMMARY, read: pointers };

/// Bits of an address of memory 502 and of its words.
pub(super) const WORD: u32 = 16;

/// The first word of an instruction. No word that is 0 is one: a memory is not left in silence.
pub(super) mod control {
    /// A stroke: J, K, L, M follow.
    pub const CURVE: u64 = 1;
    /// A positioning move: X, Y follow.
    pub const POSITION: u64 = 2;
    /// The end of the set.
    pub const EXIT: u64 = 3;
}

/// The instruction sets of a file, one after another, and where the set of each code begins.
struct Glyphs {
    words: Vec<u16>,
    pointers: [Option<u16>; 256],
}

fn instructions(source: SourceId, text: &str) -> Result<MemoryImage, Vec<Diagnostic>> {
    let words = read(source, text)?.words;
    Ok(MemoryImage::from_words(WORD, words.into_iter().map(u64::from)))
}

fn pointers(source: SourceId, text: &str) -> Result<MemoryImage, Vec<Diagnostic>> {
    let entry = |pointer: Option<u16>| pointer.map_or(0, |address| 1 << WORD | u64::from(address));
    Ok(MemoryImage::from_words(WORD + 1, read(source, text)?.pointers.map(entry)))
}

#[cfg(test)]
mod tests;
