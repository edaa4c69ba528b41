//! A profile: the values of one bit in ticks that were looked at, to tell how often each is 1 and how often it flips.

use crate::base::{Graph, Op, ValueId};

/// What one-bit values were in some ticks.
#[derive(Clone, Default)]
pub(in crate::engine::native) struct Profile {
    /// The values looked at.
    pub values: Vec<ValueId>,
    /// Of each value a bit a tick.
    history: Vec<Vec<u64>>,
    ticks: usize,
}

/// A set of the profile's ticks.
pub(super) type Ticks = Vec<u64>;

impl Profile {
    /// An empty profile of all one-bit values of a graph.
    pub fn new(graph: &Graph) -> Self {
        let is_bit = |id: &ValueId| graph.width(*id) == 1 && !matches!(graph.node(*id).op, Op::Const(_));
        let values: Vec<_> = (0..graph.nodes.len()).map(ValueId::new).filter(is_bit).collect();
        Self { history: vec![Vec::new(); values.len()], values, ticks: 0 }
    }

    /// Takes in a tick.
    pub fn tick(&mut self, word: impl Fn(ValueId) -> u64) {
        let bit = self.ticks % 64;
        for (history, &id) in self.history.iter_mut().zip(&self.values) {
            if bit == 0 {
                history.push(0);
            }
            if let Some(last) = history.last_mut() {
                *last |= (word(id) & 1) << bit;
            }
        }
        self.ticks += 1;
    }

    /// How many ticks it has seen.
    pub fn ticks(&self) -> usize {
        self.ticks
    }

    /// All its ticks.
    pub(super) fn all(&self) -> Ticks {
        let whole = vec![u64::MAX; self.ticks / 64];
        let rest = self.ticks % 64;
        whole.into_iter().chain((rest > 0).then(|| (1 << rest) - 1)).collect()
    }

    /// Those of `ticks` in which value number so-and-so is `bit`.
    pub(super) fn among(&self, ticks: &Ticks, value: usize, bit: bool) -> Ticks {
        let with = |(ticks, history): (&u64, &u64)| ticks & if bit { *history } else { !history };
        ticks.iter().zip(&self.history[value]).map(with).collect()
    }

    /// In how many of `ticks` value number so-and-so is not what it was in the tick before.
    pub(super) fn flips(&self, ticks: &Ticks, value: usize) -> u32 {
        let mut before = 0;
        let count = |(ticks, &history): (&u64, &u64)| {
            let flips = history ^ (history << 1 | before);
            before = history >> 63;
            (flips & ticks).count_ones()
        };
        ticks.iter().zip(&self.history[value]).map(count).sum()
    }
}

/// How many ticks a set has.
pub(super) fn count(ticks: &Ticks) -> u32 {
    ticks.iter().map(|part| part.count_ones()).sum()
}
