//! The values of one signal over time, held as bits.

use std::fmt;
use std::ops::Range;

use bitvec::{field::BitField, order::Lsb0, slice::BitSlice, vec::BitVec};

/// What a signal is from each of its change times on.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Track {
    width: usize,
    times: Vec<u64>,
    /// For each change `width` value bits, then `width` bits that tell which of them are unknown.
    bits: BitVec<u64, Lsb0>,
}

/// A signal's value; bit 0 is the least significant.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Value<'a> {
    /// 0 or 1; of an unknown bit 0 for `x`, 1 for `z`.
    pub bits: &'a BitSlice<u64, Lsb0>,
    /// 1 where the bit is `x` or `z`.
    pub unknown: &'a BitSlice<u64, Lsb0>,
}

impl Track {
    /// A signal of `width` bits that has no value yet.
    #[must_use]
    pub fn new(width: u32) -> Self {
        Self { width: width as usize, times: Vec::new(), bits: BitVec::new() }
    }

    /// Width in bits.
    #[must_use]
    pub fn width(&self) -> u32 {
        self.width as u32
    }

    /// The times at which a value was given.
    #[must_use]
    pub fn times(&self) -> &[u64] {
        &self.times
    }

    /// The value from `time` on, as `(bit, unknown)`, least significant first; bits beyond those given are 0. A second
    /// value at one time replaces the first. Times must not decrease.
    pub fn set(&mut self, time: u64, value: impl IntoIterator<Item = (bool, bool)>) {
        if self.times.last() != Some(&time) {
            self.times.push(time);
        }
        let start = (self.times.len() - 1) * 2 * self.width;
        self.bits.resize(start, false);
        self.bits.resize(start + 2 * self.width, false);
        for (i, (bit, unknown)) in value.into_iter().take(self.width).enumerate() {
            self.bits.set(start + i, bit);
            self.bits.set(start + self.width + i, unknown);
        }
    }

    /// The value at `time`; `None` before the first.
    #[must_use]
    pub fn at(&self, time: u64) -> Option<Value<'_>> {
        let after = self.times.partition_point(|&change| change <= time);
        after.checked_sub(1).map(|change| self.value(change))
    }

    fn value(&self, change: usize) -> Value<'_> {
        let both = &self.bits[change * 2 * self.width..][..2 * self.width];
        let (bits, unknown) = both.split_at(self.width);
        Value { bits, unknown }
    }

    /// The spans of time within `span` in which two signals have different values, in order.
    pub fn differences<'a>(&'a self, other: &'a Track, span: Range<u64>) -> impl Iterator<Item = Range<u64>> + 'a {
        let mut time = span.start;
        let passed = |track: &Track| track.times.partition_point(|&change| change <= span.start);
        let (mut mine, mut theirs) = (passed(self), passed(other));
        let end = span.end;
        std::iter::from_fn(move || {
            while time < end {
                let from = time;
                let same = mine.checked_sub(1).map(|i| self.value(i)) == theirs.checked_sub(1).map(|i| other.value(i));
                let next = |track: &Track, passed: usize| track.times.get(passed).copied().unwrap_or(end);
                time = next(self, mine).min(next(other, theirs)).min(end);
                mine += usize::from(self.times.get(mine) == Some(&time));
                theirs += usize::from(other.times.get(theirs) == Some(&time));
                if !same {
                    return Some(from..time);
                }
            }
            None
        })
    }

    /// The same values at other times: `map` must not decrease.
    pub(super) fn retimed(&self, map: impl Fn(u64) -> u64) -> Self {
        let mut track = Track::new(self.width());
        for (change, &time) in self.times.iter().enumerate() {
            let value = self.value(change);
            let bits = value.bits.iter().by_vals().zip(value.unknown.iter().by_vals());
            track.set(map(time), bits);
        }
        track
    }
}

impl Value<'_> {
    /// The word, when it is known and has no more than 64 bits.
    #[must_use]
    pub fn word(&self) -> Option<u64> {
        (self.bits.len() <= 64 && self.unknown.not_any()).then(|| self.bits.load_le())
    }
}

impl fmt::Display for Value<'_> {
    /// One bit as itself, a known word in hex with all its digits, others bit by bit.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let width = self.bits.len();
        if width > 1 && self.unknown.not_any() {
            let digits: Vec<u8> = self.bits.chunks(4).map(|four| four.load_le()).collect();
            return digits.iter().rev().try_for_each(|digit| write!(f, "{digit:x}"));
        }
        let symbol = |i: usize| match (self.unknown[i], self.bits[i]) {
            (true, false) => 'x',
            (true, true) => 'z',
            (false, bit) => char::from(b'0' + u8::from(bit)),
        };
        let text: String = (0..width).rev().map(symbol).collect();
        f.write_str(&text)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn known(word: u64) -> impl Iterator<Item = (bool, bool)> {
        (0..64).map(move |i| (word >> i & 1 == 1, false))
    }

    fn track(changes: &[(u64, u64)]) -> Track {
        let mut track = Track::new(3);
        let mut time = 0;
        for (pause, word) in changes {
            time += pause;
            track.set(time, known(*word));
        }
        track
    }

    fn changes() -> impl Strategy<Value = Vec<(u64, u64)>> {
        prop::collection::vec((0u64..4, 0u64..3), 0..12)
    }

    proptest! {
        #[test]
        fn the_spans_of_difference_are_those_that_asking_at_every_time_finds(
            a in changes(), b in changes(), start in 0u64..20, length in 0u64..40,
        ) {
            let (a, b, span) = (track(&a), track(&b), start..start + length);
            let by_spans: Vec<u64> = a.differences(&b, span.clone()).flatten().collect();
            let one_by_one: Vec<u64> = span.filter(|&time| a.at(time) != b.at(time)).collect();
            prop_assert_eq!(by_spans, one_by_one);
        }

        #[test]
        fn a_word_comes_back_as_it_was_set_at_any_width(word: u64, width in 1u32..=64) {
            let word = word & crate::base::word::mask(width);
            let mut track = Track::new(width);
            track.set(3, known(!word));
            track.set(3, known(word));
            prop_assert_eq!(track.at(2), None);
            prop_assert_eq!(track.at(9).and_then(|value| value.word()), Some(word));
            let shown = track.at(3).unwrap().to_string();
            prop_assert_eq!(u64::from_str_radix(&shown, 16).unwrap(), word);
            prop_assert_eq!(shown.len(), width.div_ceil(4) as usize);
        }
    }

    #[test]
    fn unknown_bits_are_shown_one_by_one_and_differ_from_known_ones() {
        let mut track = Track::new(3);
        track.set(0, [(true, false), (false, true), (true, true)]);
        assert_eq!(track.at(0).unwrap().to_string(), "zx1");
        assert_eq!(track.at(0).unwrap().word(), None);
        let mut other = Track::new(3);
        other.set(0, [(true, false), (false, false), (true, false)]);
        assert_eq!(track.differences(&other, 0..2).collect::<Vec<_>>(), [Range { start: 0, end: 2 }]);
    }
}
