//! Values that are kept, each as small as what it says.

use super::planes::{last_mask, words_of};

/// Values of one width, in the order in which they came.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub(super) struct Values {
    /// Of each value the place after its last word, and its [`Shape`].
    ends: Vec<u64>,
    /// Of each value the words of its bits, then those of its unknown bits if there are any, both without the words
    /// at the top that are like its highest bit.
    words: Vec<u64>,
}

/// What a value's words do not say: its highest bit, whether that is unknown, whether all others are known.
type Shape = u64;

const HIGH: Shape = 1;
const HIGH_UNKNOWN: Shape = 2;
const ALL_KNOWN: Shape = 4;
const SHAPE_BITS: u32 = 3;

/// One of them.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Kept<'a> {
    shape: Shape,
    words: &'a [u64],
}

impl Values {
    /// How many bytes they take.
    pub fn bytes(&self) -> usize {
        8 * (self.ends.capacity() + self.words.capacity())
    }

    /// Keeps a value of `width` bits, at least 1.
    pub fn push(&mut self, width: u32, bits: &[u64], unknown: &[u64]) {
        let top = (width - 1) as usize;
        let is_set = |plane: &[u64]| plane[top / 64] >> (top % 64) & 1;
        let mut shape = (is_set(bits) * HIGH) | (is_set(unknown) * HIGH_UNKNOWN);
        let mut kept = words_of(width);
        while kept > 0
            && is_like(bits, shape & HIGH, kept - 1, width)
            && is_like(unknown, shape & HIGH_UNKNOWN, kept - 1, width)
        {
            kept -= 1;
        }
        self.words.extend_from_slice(&bits[..kept]);
        if unknown[..kept].iter().all(|&word| word == 0) {
            shape |= ALL_KNOWN;
        } else {
            self.words.extend_from_slice(&unknown[..kept]);
        }
        self.ends.push((self.words.len() as u64) << SHAPE_BITS | shape);
    }

    /// Takes the last value away.
    pub fn pop(&mut self) {
        self.ends.pop();
        self.words.truncate(self.start(self.ends.len()));
    }

    fn start(&self, index: usize) -> usize {
        index.checked_sub(1).map_or(0, |before| (self.ends[before] >> SHAPE_BITS) as usize)
    }

    pub fn get(&self, index: usize) -> Kept<'_> {
        let end = (self.ends[index] >> SHAPE_BITS) as usize;
        Kept { shape: self.ends[index] & ((1 << SHAPE_BITS) - 1), words: &self.words[self.start(index)..end] }
    }
}

/// Whether a word of a plane says just what the highest bit says.
fn is_like(plane: &[u64], high: u64, word: usize, width: u32) -> bool {
    let fill = if high == 0 { 0 } else { u64::MAX };
    let mask = if word + 1 == words_of(width) { last_mask(width) } else { u64::MAX };
    plane[word] == fill & mask
}

impl Kept<'_> {
    /// Writes the value into planes of its width.
    pub fn write(&self, width: u32, bits: &mut [u64], unknown: &mut [u64]) {
        let kept = if self.shape & ALL_KNOWN == 0 { self.words.len() / 2 } else { self.words.len() };
        let fill = |is_high: u64| if is_high == 0 { 0 } else { u64::MAX };
        bits[..kept].copy_from_slice(&self.words[..kept]);
        bits[kept..].fill(fill(self.shape & HIGH));
        if self.shape & ALL_KNOWN == 0 {
            unknown[..kept].copy_from_slice(&self.words[kept..]);
        } else {
            unknown[..kept].fill(0);
        }
        unknown[kept..].fill(fill(self.shape & HIGH_UNKNOWN));
        for plane in [bits, unknown] {
            if let Some(last) = plane.last_mut() {
                *last &= last_mask(width);
            }
        }
    }
}
