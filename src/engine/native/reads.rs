//! Reading many values in every tick: sorted by where they stand and how wide they are, so that no read has to ask.

use super::memory::{Layout, Memory, Place};
use crate::base::ValueId;

/// How to read a list of values.
#[derive(Debug, Default)]
pub(super) struct Reads {
    constants: Vec<(usize, u64)>,
    state: Area,
    wires: Area,
}

/// Reads from one area of memory, by size of the element: its place in the list and its offset.
#[derive(Debug, Default)]
struct Area {
    bytes: Vec<(usize, usize)>,
    halves: Vec<(usize, usize)>,
    words: Vec<(usize, usize)>,
}

impl Reads {
    /// How to read the values `ids`.
    pub fn new(layout: &Layout, ids: &[ValueId]) -> Self {
        let mut reads = Self::default();
        for (i, &id) in ids.iter().enumerate() {
            match layout.place(id) {
                Place::Constant(value) => reads.constants.push((i, value)),
                Place::State(spot) => reads.state.of_size(spot.bytes).push((i, spot.offset as usize)),
                Place::Wire(spot) => reads.wires.of_size(spot.bytes).push((i, spot.offset as usize)),
            }
        }
        reads
    }

    /// Puts each value into its place in `words`.
    pub fn fill(&self, memory: &Memory, words: &mut [u64]) {
        self.constants.iter().for_each(|&(i, value)| words[i] = value);
        self.state.fill(memory.now.as_bytes(), words);
        self.wires.fill(memory.wires.as_bytes(), words);
    }
}

impl Area {
    fn of_size(&mut self, bytes: u32) -> &mut Vec<(usize, usize)> {
        match bytes {
            1 => &mut self.bytes,
            4 => &mut self.halves,
            _ => &mut self.words,
        }
    }

    /// Loads just the bytes that the code has written: a wider load would have to wait until they reach the cache.
    fn fill(&self, memory: &[u8], words: &mut [u64]) {
        let half = |at: usize| memory[at..].first_chunk().map_or(0, |word| u32::from_ne_bytes(*word));
        let word = |at: usize| memory[at..].first_chunk().map_or(0, |word| u64::from_ne_bytes(*word));
        self.bytes.iter().for_each(|&(i, at)| words[i] = memory[at].into());
        self.halves.iter().for_each(|&(i, at)| words[i] = half(at).into());
        self.words.iter().for_each(|&(i, at)| words[i] = word(at));
    }
}
