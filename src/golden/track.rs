//! The values of one signal over time.

use std::fmt;

use super::declared::Kind;
use super::planes::{last_mask, words_of};
use super::values::Values;

/// What a signal is from each of its change times on; each value takes as much memory as it says.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Track {
    kind: Kind,
    width: u32,
    times: Vec<u64>,
    values: Values,
}

/// A signal's value; bit 0 is the least significant.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Value {
    kind: Kind,
    width: u32,
    bits: Vec<u64>,
    unknown: Vec<u64>,
}

impl Track {
    /// A signal of `width` bits that has no value yet; a real has 64.
    pub(super) fn new(kind: Kind, width: u32) -> Self {
        Self { kind, width, times: Vec::new(), values: Values::default() }
    }

    /// Width in bits.
    #[must_use]
    pub fn width(&self) -> u32 {
        self.width
    }

    /// The times at which a value was given.
    #[must_use]
    pub fn times(&self) -> &[u64] {
        &self.times
    }

    /// How many bytes of values it holds.
    pub(super) fn bytes(&self) -> usize {
        8 * self.times.capacity() + self.values.bytes()
    }

    /// The value from `time` on. A second value at one time replaces the first. Times must not decrease.
    pub(super) fn push(&mut self, time: u64, bits: &[u64], unknown: &[u64]) {
        if self.times.last() == Some(&time) {
            self.values.pop();
        } else {
            self.times.push(time);
        }
        self.values.push(self.width, bits, unknown);
    }

    /// The value at `time`; `None` before the first.
    #[must_use]
    pub fn at(&self, time: u64) -> Option<Value> {
        let after = self.times.partition_point(|&change| change <= time);
        after.checked_sub(1).map(|change| {
            let mut value = Value::new(self.kind, self.width);
            self.write(change, &mut value.bits, &mut value.unknown);
            value
        })
    }

    /// Writes the value of a change, counted from 0, into planes of its width.
    pub(super) fn write(&self, change: usize, bits: &mut [u64], unknown: &mut [u64]) {
        self.values.get(change).write(self.width, bits, unknown);
    }

    /// The same values at other times: `map` must not decrease.
    pub(super) fn retimed(&self, map: impl Fn(u64) -> u64) -> Self {
        let mut track = Track::new(self.kind, self.width);
        let mut value = Value::new(self.kind, self.width);
        for (change, &time) in self.times.iter().enumerate() {
            self.write(change, &mut value.bits, &mut value.unknown);
            track.push(map(time), &value.bits, &value.unknown);
        }
        track
    }
}

impl Value {
    pub(super) fn new(kind: Kind, width: u32) -> Self {
        let plane = vec![0; words_of(width)];
        Self { kind, width, bits: plane.clone(), unknown: plane }
    }

    pub(super) fn of(kind: Kind, width: u32, bits: &[u64], unknown: &[u64]) -> Self {
        Self { kind, width, bits: bits.to_vec(), unknown: unknown.to_vec() }
    }

    /// The same with 0 for every unknown bit.
    pub(super) fn with_zeros(mut self) -> Self {
        for (bits, unknown) in self.bits.iter_mut().zip(&mut self.unknown) {
            *bits &= !std::mem::take(unknown);
        }
        self
    }

    /// The same with 0 for every bit that is unknown in either.
    pub(super) fn without(&self, other: &Value) -> Self {
        let mut value = self.clone();
        value.unknown.iter_mut().zip(&other.unknown).for_each(|(mine, theirs)| *mine |= theirs);
        value.with_zeros()
    }

    /// Whether two values of one width are equal or, as numbers, no further apart than `distance`; words are compared
    /// on the circle of their width.
    pub(super) fn is_near(&self, other: &Value, distance: f64) -> bool {
        let apart = match (self.kind, self.word(), other.word()) {
            _ if self == other => return true,
            (Kind::Real, ..) => (f64::from_bits(self.bits[0]) - f64::from_bits(other.bits[0])).abs(),
            (_, Some(a), Some(b)) => {
                let mask = last_mask(self.width);
                (a.wrapping_sub(b) & mask).min(b.wrapping_sub(a) & mask) as f64
            }
            _ => return false,
        };
        apart <= distance
    }

    /// Width in bits.
    #[must_use]
    pub fn width(&self) -> u32 {
        self.width
    }

    /// A bit, and whether it is unknown: then it is 0 for `x`, 1 for `z`.
    pub(super) fn bit(&self, at: u32) -> (bool, bool) {
        let is_set = |plane: &[u64]| plane[at as usize / 64] >> (at % 64) & 1 == 1;
        (is_set(&self.bits), is_set(&self.unknown))
    }

    pub(super) fn set_bit(&mut self, at: u32, (bit, unknown): (bool, bool)) {
        self.bits[at as usize / 64] |= u64::from(bit) << (at % 64);
        self.unknown[at as usize / 64] |= u64::from(unknown) << (at % 64);
    }

    fn is_known(&self) -> bool {
        self.unknown.iter().all(|&word| word == 0)
    }

    /// The word, when it is known and has no more than 64 bits.
    #[must_use]
    pub fn word(&self) -> Option<u64> {
        (self.kind == Kind::Bits && self.width <= 64 && self.is_known()).then(|| self.bits[0])
    }
}

impl fmt::Display for Value {
    /// One bit as itself, a known word in hex with all its digits, others bit by bit; a real as a number.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.kind == Kind::Real {
            return write!(f, "{:?}", f64::from_bits(self.bits[0]));
        }
        if self.width > 1 && self.is_known() {
            let digit = |at: u32| self.bits[at as usize / 16] >> (at % 16 * 4) & 15;
            return (0..self.width.div_ceil(4)).rev().try_for_each(|at| write!(f, "{:x}", digit(at)));
        }
        let symbol = |at| match self.bit(at) {
            (false, true) => 'x',
            (true, true) => 'z',
            (bit, false) => char::from(b'0' + u8::from(bit)),
        };
        let text: String = (0..self.width).rev().map(symbol).collect();
        f.write_str(&text)
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn a_word_comes_back_as_it_was_set_at_any_width(word: u64, width in 1u32..=64) {
            let word = word & crate::base::word::mask(width);
            let mut track = Track::new(Kind::Bits, width);
            track.push(3, &[!word & crate::base::word::mask(width)], &[0]);
            track.push(3, &[word], &[0]);
            prop_assert_eq!(track.at(2), None);
            prop_assert_eq!(track.at(9).and_then(|value| value.word()), Some(word));
            let shown = track.at(3).unwrap().to_string();
            prop_assert_eq!(u64::from_str_radix(&shown, 16).unwrap(), word);
            prop_assert_eq!(shown.len(), width.div_ceil(4) as usize);
        }
    }

    #[test]
    fn unknown_bits_are_shown_one_by_one() {
        let mut track = Track::new(Kind::Bits, 3);
        track.push(0, &[0b101], &[0b110]);
        assert_eq!(track.at(0).unwrap().to_string(), "zx1");
        assert_eq!(track.at(0).unwrap().word(), None);
    }

    #[test]
    fn a_real_is_shown_as_a_number() {
        let mut track = Track::new(Kind::Real, 64);
        track.push(0, &[0.5f64.to_bits()], &[0]);
        assert_eq!(track.at(0).unwrap().to_string(), "0.5");
    }
}
