//! The values of all signals of a file at one time.

use super::declared::{Declared, Kind, Signal, SignalId};
use super::planes::{last_mask, words_of};

/// The values at one time, in place: two planes of bits for each signal, and which signals have been touched.
#[derive(Clone, Debug)]
pub(super) struct State {
    signals: Vec<Signal>,
    /// Where the planes of a signal begin.
    offsets: Vec<u32>,
    /// For each signal its bits, then which of them are unknown: of an unknown bit the first plane has 0 for x, 1 for
    /// z. Bits beyond the width are 0.
    words: Vec<u64>,
    has_value: Vec<bool>,
    is_touched: Vec<bool>,
    touched: Vec<u32>,
}

impl State {
    pub fn new(declared: &Declared) -> Self {
        let mut end = 0;
        let mut offset = |signal: &Signal| {
            let start = end;
            end += 2 * words_of(signal.width) as u32;
            start
        };
        let offsets = declared.signals.iter().map(&mut offset).collect();
        let count = declared.signals.len();
        Self {
            signals: declared.signals.clone(),
            offsets,
            words: vec![0; end as usize],
            has_value: vec![false; count],
            is_touched: vec![false; count],
            touched: Vec::new(),
        }
    }

    pub fn signal(&self, id: SignalId) -> Signal {
        self.signals[id.index()]
    }

    /// Bits and unknown bits; `None` before the first value.
    pub fn planes(&self, id: SignalId) -> Option<(&[u64], &[u64])> {
        let length = words_of(self.signals[id.index()].width);
        let both = &self.words[self.offsets[id.index()] as usize..][..2 * length];
        self.has_value[id.index()].then(|| both.split_at(length))
    }

    /// The planes of a signal, to be written.
    pub fn touch(&mut self, id: SignalId) -> (&mut [u64], &mut [u64]) {
        let index = id.index();
        if !std::mem::replace(&mut self.is_touched[index], true) {
            self.touched.push(index as u32);
        }
        self.has_value[index] = true;
        let length = words_of(self.signals[index].width);
        self.words[self.offsets[index] as usize..][..2 * length].split_at_mut(length)
    }

    /// Sets a signal from digits, the most significant first. A vector that is cut short is widened: x with x, z with
    /// z, others with 0 (IEEE 1364-2005, 18.2.1). `None`: no digit, too many, or a strange one.
    pub fn set_digits(&mut self, id: SignalId, digits: &[u8]) -> Option<()> {
        let width = self.signals[id.index()].width;
        if digits.is_empty() || digits.len() > width as usize || self.signals[id.index()].kind != Kind::Bits {
            return None;
        }
        if !digits.iter().all(|&digit| digit_of(digit).is_some()) {
            return None;
        }
        let (bits, unknown) = self.touch(id);
        for (word, chunk) in digits.rchunks(64).enumerate() {
            (bits[word], unknown[word]) = packed(chunk);
        }
        let fill = match digit_of(digits[0]) {
            Some((bit, true)) => (u64::from(bit).wrapping_neg(), u64::MAX),
            _ => (0, 0),
        };
        fill_above(digits.len(), width, bits, fill.0);
        fill_above(digits.len(), width, unknown, fill.1);
        Some(())
    }

    /// Sets a real. Values that count as equal get equal bits.
    pub fn set_real(&mut self, id: SignalId, value: f64) -> Option<()> {
        if self.signals[id.index()].kind != Kind::Real {
            return None;
        }
        let canonical = if value.is_nan() { f64::NAN } else { value + 0.0 };
        self.touch(id).0[0] = canonical.to_bits();
        Some(())
    }

    /// The signals touched since the last call of [`Self::settle`], each once.
    pub fn touched(&self) -> impl Iterator<Item = SignalId> + '_ {
        self.touched.iter().map(|&index| SignalId::new(index as usize))
    }

    /// Forgets what was touched.
    pub fn settle(&mut self) {
        for index in self.touched.drain(..) {
            self.is_touched[index as usize] = false;
        }
    }
}

/// Up to 64 digits as bits and unknown bits.
fn packed(digits: &[u8]) -> (u64, u64) {
    let (mut bits, mut unknown) = (0, 0);
    for &digit in digits {
        let (bit, is_unknown) = digit_of(digit).unwrap_or_default();
        bits = bits << 1 | u64::from(bit);
        unknown = unknown << 1 | u64::from(is_unknown);
    }
    (bits, unknown)
}

/// Fills the bits from `from` up to `width`.
fn fill_above(from: usize, width: u32, plane: &mut [u64], fill: u64) {
    let (word, bit) = (from / 64, from % 64);
    if word < plane.len() {
        plane[word] = if bit == 0 { fill } else { plane[word] & !(u64::MAX << bit) | fill << bit };
        plane[word + 1..].fill(fill);
    }
    if let Some(last) = plane.last_mut() {
        *last &= last_mask(width);
    }
}

/// A digit as bit and whether it is unknown. Of the nine values of VHDL, `u`, `w` and `-` count as x, weak ones as
/// themselves.
pub(super) fn digit_of(digit: u8) -> Option<(bool, bool)> {
    match digit {
        b'0' | b'l' | b'L' => Some((false, false)),
        b'1' | b'h' | b'H' => Some((true, false)),
        b'x' | b'X' | b'u' | b'U' | b'w' | b'W' | b'-' => Some((false, true)),
        b'z' | b'Z' => Some((true, true)),
        _ => None,
    }
}
