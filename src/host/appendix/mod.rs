//! The FORTRAN of Appendix A, as far as it can be recovered: strokes become words of a display's buffer.
//!
//! [`Listing`] tells which of two programs: the one that the patent prints, or the same with its mistakes mended. Damage
//! that the scan of the patent has done to characters is undone in both. docs/host.md lists, routine by routine, what the
//! listing says, what was mended, and what stands for lines that are lost. The numbers in comments are line numbers.
//!
//! The buffer is another way to a display than the registers of FIG. 18: its words are of 8 bits, a flag and a number of
//! eighths of a unit from -8 to 7 7/8. Numbers are `f64` here, 32 bits in the FORTRAN of a PDP-11.
//!
//! ```
//! use stepwright::host::appendix::{Listing, Program, xtract};
//!
//! let mut program = Program::new(Listing::Corrected, Box::new(|_| {}));
//! program.init(1);
//! let circle = program.circle([0.0, 0.0], 2.0)?;
//! assert_eq!((circle.from, circle.jklm, circle.quarters), ([-2.0, 0.0], [-2.0, 0.0, 0.0, 2.0], 4));
//! assert_eq!(program.words()[18..], [0o360, 0, 0o200, 0o220]);
//! assert_eq!([0o360, 0, 0o200, 0o220].map(xtract), circle.jklm);
//! # Ok::<(), stepwright::host::appendix::Message>(())
//! ```

use std::fmt;

use super::Point;

mod buffer;
mod circles;
mod curves;

pub use buffer::{Type, xtract};

/// Words of `NBUFF`.
const SIZE: usize = 1000;

/// Which program.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Listing {
    /// With the mistakes of the patent's listing.
    AsPrinted,
    /// With these mended.
    Corrected,
}

/// Why a routine has drawn nothing: what it prints, or what stops it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Message {
    /// CRV22, line 220.
    EqualSlopes,
    /// CRV3B, line 560.
    InflectionAtBegin,
    /// CRV3, line 910.
    RoutineCrv3,
    /// CRV3E, line 1260.
    InflectionAtEnd,
    /// None of the listing's: a division by 0 has stopped the program.
    DivisionByZero,
    /// None of the listing's: SHTFMT is corrected to refuse what it cannot hold.
    Range,
}

impl fmt::Display for Message {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::EqualSlopes => "ERROR: SBEG=SEND",
            Self::InflectionAtBegin => "ERROR: PT OF INFLECTION BTWN BEG--INTER PT",
            Self::RoutineCrv3 => "ERROR: ROUTINE CRV3",
            Self::InflectionAtEnd => "ERROR: PT. OF INFLECTION BTWN INTER AND END PT.",
            Self::DivisionByZero => "division by zero",
            Self::Range => "a parameter is not from -8 to 7.875",
        })
    }
}

impl std::error::Error for Message {}

/// Where the words of a full buffer go.
pub type Output<'o> = Box<dyn FnMut(&[u16]) + 'o>;

/// The program with its COMMON: XBEG, YBEG, JPTR, NBFSIZ and NBUFF.
pub struct Program<'o> {
    listing: Listing,
    beg: Point,
    /// Where the next word goes, from 1 on, as FORTRAN counts.
    jptr: usize,
    nbuff: [u16; SIZE],
    output: Output<'o>,
}

impl<'o> Program<'o> {
    /// The program before INIT, with an empty buffer. `output` gets the words of each full one.
    #[must_use]
    pub fn new(listing: Listing, output: Output<'o>) -> Self {
        Self { listing, beg: [0.0, 0.0], jptr: 1, nbuff: [0; SIZE], output }
    }

    /// XBEG and YBEG: where the next stroke begins, in units.
    #[must_use]
    pub fn beg(&self) -> Point {
        self.beg
    }

    /// The words in the buffer, NBUFF(1) to NBUFF(JPTR-1).
    #[must_use]
    pub fn words(&self) -> &[u16] {
        &self.nbuff[..self.jptr - 1]
    }
}
