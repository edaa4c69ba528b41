//! Routines around the buffer: INIT, TYPCRV, SHTFMT, RNDOFF, XTRACT; and OUTPUT, which is lost.

use super::{Listing, Message, Program, SIZE};
use crate::host::Curve;

/// INIT, lines 5030 and 5040: commands to the display, whose meaning is lost.
const HEAD: [u16; 18] =
    [0o202, 0o233, 0o300, 0o300, 0o301, 0o230, 0o301, 0o266, 0, 0, 0o300, 0o234, 0, 0, 0, 0, 0o300, 0o236];

/// Bit 7 of a word.
const FLAG: u16 = 128;

/// ITYPE: how much of its ellipse a stroke is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Type {
    /// 1.
    Quarter = 1,
    /// 2.
    Half,
    /// 3.
    ThreeQuarters,
    /// 4.
    Whole,
}

impl Program<'_> {
    /// INIT (ISCALE), lines 5000 to 5120: an empty buffer but for its head, and the begin at (0, 0).
    pub fn init(&mut self, iscale: u16) {
        self.nbuff[..HEAD.len()].copy_from_slice(&HEAD); // 5050, 5060
        self.nbuff[9] = iscale.wrapping_mul(8); // 5070
        self.jptr = HEAD.len() + 1; // 5080
        self.beg = [0.0, 0.0]; // 5090, 5100
    }

    /// TYPCRV (AJ, AK, AL, AM, ITYPE), lines 10400 to 10740: the four words of a stroke, and where it ends. The flag on
    /// the word of J marks the begin of a stroke, those on L and M are ITYPE - 1. What it gives back is the stroke as
    /// it came, before any rounding.
    ///
    /// # Errors
    /// [`Message::DivisionByZero`]: a parameter is no number; [`Message::Range`], corrected.
    pub fn typcrv(&mut self, jklm: [f64; 4], itype: Type) -> Result<Curve, Message> {
        if jklm.iter().any(|value| !value.is_finite()) {
            return Err(Message::DivisionByZero);
        }
        // A stroke that does not fit leaves no half of itself.
        jklm.iter().try_for_each(|value| self.shortened(*value).map(drop))?;
        if SIZE - self.jptr < 4 {
            self.output(); // 10420
        }
        let code = itype as u16 - 1; // 10460 to 10580
        for (value, flag) in jklm.into_iter().zip([1, 0, code >> 1, code & 1]) {
            self.shtfmt(value, flag == 1)?;
        }
        let curve = Curve { from: self.beg, jklm, quarters: itype as u8 };
        let mut drawn = curve;
        let ([mut j, mut k, mut l, mut m], n) = (jklm, 8.0);
        rndoff(&mut j, &mut k, n); // 10620
        rndoff(&mut l, &mut m, n); // 10630
        drawn.jklm = [j, k, l, m];
        self.beg = drawn.end(); // 10640 to 10730
        Ok(curve)
    }

    /// SHTFMT (A, N), lines 10000 to 10080: a parameter as a word of the buffer, with the flag (N = 128) or without.
    ///
    /// # Errors
    /// [`Message::Range`], corrected: as printed, what is not from -8 to 7.875 becomes another number.
    pub fn shtfmt(&mut self, a: f64, flag: bool) -> Result<(), Message> {
        let i = self.shortened(a)?;
        if self.jptr > SIZE {
            self.output();
        }
        self.nbuff[self.jptr - 1] = i + if flag { FLAG } else { 0 }; // 10050
        self.jptr += 1; // 10060
        Ok(())
    }

    /// Lines 10030 and 10040: eighths, cut off towards 0, in seven bits of two's complement.
    fn shortened(&self, a: f64) -> Result<u16, Message> {
        let l = (a * 8.0) as i64;
        if self.listing == Listing::Corrected && !(-64..64).contains(&l) {
            return Err(Message::Range);
        }
        Ok((l & 0o177) as u16)
    }

    /// OUTPUT, which is lost: hands the words out and empties the buffer but for its head.
    pub fn output(&mut self) {
        (self.output)(&self.nbuff[..self.jptr - 1]);
        self.jptr = HEAD.len() + 1;
    }
}

/// RNDOFF (A, B, N), lines 10200 to 10270: cuts both off to whole Nths, towards 0, as the buffer's words are.
pub(super) fn rndoff(a: &mut f64, b: &mut f64, n: f64) {
    *a = (*a * n).trunc() / n; // 10210 (lost), 10240
    *b = (*b * n).trunc() / n; // 10220, 10250
}

/// XTRACT (I, A), lines 4700 to 4780: the number in a word of the buffer, whatever its flag.
#[must_use]
pub fn xtract(i: u16) -> f64 {
    let (j, k) = (i & 0o100, f64::from(i & 0o77)); // 4720, 4730
    let b = if j == 0 { k } else { -(64.0 - k) }; // 4740, 4750
    b / 8.0 // 4760
}
