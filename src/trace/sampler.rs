//! The sampler: reads each distinct value once a tick, keeps the old ones, yields what changed.

use multiversion::multiversion;

use super::{Plan, SlotId};
use crate::base::ValueId;

/// A value that is not what it was at the tick before.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Change {
    /// Which of the plan's values.
    pub slot: SlotId,
    /// Its new word.
    pub word: u64,
}

/// The ticks that are traced, both ends included.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Window {
    /// First tick.
    pub from: u64,
    /// Last tick.
    pub to: u64,
}

impl Window {
    /// Every tick.
    pub const ALL: Window = Window { from: 0, to: u64::MAX };
}

/// Reads the values of a [`Plan`] tick by tick.
#[derive(Clone, Debug)]
pub struct Sampler {
    values: Vec<ValueId>,
    words: Vec<u64>,
    /// Those of the tick being read.
    fresh: Vec<u64>,
    changes: Vec<Change>,
    window: Window,
    started: bool,
}

impl Sampler {
    /// A sampler for the ticks of `window`.
    #[must_use]
    pub fn new(plan: &Plan, window: Window) -> Self {
        let values: Vec<_> = plan.slots().iter().map(|slot| slot.value).collect();
        let count = values.len();
        let (words, fresh) = (vec![0; count], vec![0; count]);
        Self { words, fresh, changes: Vec::with_capacity(count), values, window, started: false }
    }

    /// The values that are read, in order.
    #[must_use]
    pub fn values(&self) -> &[ValueId] {
        &self.values
    }

    /// Reads the values at `tick` and returns those that changed since the last call; the first time all of them.
    /// `None` outside the window, where nothing is read.
    pub fn sample(&mut self, tick: u64, read: impl Fn(ValueId) -> u64) -> Option<&[Change]> {
        let values = std::mem::take(&mut self.values);
        let read_all = |words: &mut [u64]| words.iter_mut().zip(&values).for_each(|(word, &value)| *word = read(value));
        let sampled = self.sample_all(tick, read_all).is_some();
        self.values = values;
        sampled.then_some(&self.changes)
    }

    /// The same with one call that reads all values: `read` puts the words of [`Sampler::values`] into the places given.
    pub fn sample_all(&mut self, tick: u64, read: impl FnOnce(&mut [u64])) -> Option<&[Change]> {
        if tick < self.window.from || tick > self.window.to {
            return None;
        }
        self.changes.clear();
        read(&mut self.fresh);
        if self.started {
            self.compare();
        } else {
            self.started = true;
            let all = self.fresh.iter().enumerate();
            self.changes.extend(all.map(|(slot, &word)| Change { slot: SlotId::new(slot), word }));
        }
        std::mem::swap(&mut self.words, &mut self.fresh);
        Some(&self.changes)
    }

    /// Gathers the changed ones of up to 64 values in a mask, because a branch for each would be guessed wrong
    /// about as often as a signal changes.
    fn compare(&mut self) {
        for (part, (old, new)) in self.words.chunks(64).zip(self.fresh.chunks(64)).enumerate() {
            let mut changed = changed(old, new);
            while changed != 0 {
                let i = changed.trailing_zeros() as usize;
                self.changes.push(Change { slot: SlotId::new(part * 64 + i), word: new[i] });
                changed &= changed - 1;
            }
        }
    }
}

/// Which of up to 64 words differ, as a mask; with the vector instructions that the machine turns out to have.
#[multiversion(targets = "simd")]
fn changed(old: &[u64], new: &[u64]) -> u64 {
    let pairs = old.iter().zip(new).enumerate();
    pairs.fold(0, |mask, (i, (old, new))| mask | u64::from(old != new) << i)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::Signal;
    use proptest::prelude::*;

    fn plan(count: usize) -> Plan {
        let signal = |i: usize| Signal {
            path: vec!["t".into(), format!("n{i}")],
            width: 64,
            signed: false,
            fraction: None,
            value: ValueId::new(i),
        };
        Plan::new(&(0..count).map(signal).collect::<Vec<_>>())
    }

    proptest! {
        #[test]
        fn the_changes_are_those_that_a_plain_comparison_finds(
            history in (1usize..150).prop_flat_map(|n| prop::collection::vec(prop::collection::vec(0u64..3, n), 1..8)),
        ) {
            let mut sampler = Sampler::new(&plan(history[0].len()), Window::ALL);
            let mut old: Option<&Vec<u64>> = None;
            for (tick, words) in history.iter().enumerate() {
                let got = sampler.sample(tick as u64, |id| words[id.index()]).expect("inside the window").to_vec();
                let differs = |i: &usize| old.is_none_or(|old| old[*i] != words[*i]);
                let expected = (0..words.len()).filter(differs).map(|i| Change { slot: SlotId::new(i), word: words[i] });
                prop_assert_eq!(got, expected.collect::<Vec<_>>());
                old = Some(words);
            }
        }
    }

    #[test]
    fn outside_the_window_nothing_is_read_and_its_first_tick_yields_every_value() {
        let mut sampler = Sampler::new(&plan(2), Window { from: 3, to: 4 });
        let yielded = |changes: Option<&[Change]>| changes.map(<[Change]>::len);
        assert_eq!(yielded(sampler.sample(2, |_| panic!("read before the window"))), None);
        assert_eq!(yielded(sampler.sample(3, |_| 0)), Some(2));
        assert_eq!(yielded(sampler.sample(4, |_| 0)), Some(0));
        assert_eq!(yielded(sampler.sample(5, |_| panic!("read after the window"))), None);
    }
}
