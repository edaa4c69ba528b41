//! The sampler: compares the distinct values of a trace with those of the tick before, and yields what changed.

use super::{Frame, Plan, SlotId};

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

/// Finds what changed from tick to tick among the values of a [`Plan`].
#[derive(Clone, Debug)]
pub struct Sampler {
    changes: Vec<Change>,
    window: Window,
    started: bool,
}

impl Sampler {
    /// A sampler for the ticks of `window`.
    #[must_use]
    pub fn new(plan: &Plan, window: Window) -> Self {
        Self { changes: Vec::with_capacity(plan.slots().len()), window, started: false }
    }

    /// What is not as it was in the tick before; at the first tick of the window every value. `None` outside the
    /// window. `frame` holds the words of the plan's slots.
    pub fn sample(&mut self, frame: Frame<'_>) -> Option<&[Change]> {
        if frame.tick < self.window.from || frame.tick > self.window.to {
            return None;
        }
        self.changes.clear();
        let started = std::mem::replace(&mut self.started, true);
        match frame.before.filter(|_| started) {
            Some(before) => self.compare(before, frame.words),
            None => {
                let all = frame.words.iter().enumerate();
                self.changes.extend(all.map(|(slot, &word)| Change { slot: SlotId::new(slot), word }));
            }
        }
        Some(&self.changes)
    }

    /// Gathers the changed ones of up to 64 values in a mask, because a branch for each would be guessed wrong
    /// about as often as a signal changes.
    fn compare(&mut self, before: &[u64], words: &[u64]) {
        for (part, (old, new)) in before.chunks(64).zip(words.chunks(64)).enumerate() {
            let mut changed = changed(old, new);
            while changed != 0 {
                let i = changed.trailing_zeros() as usize;
                self.changes.push(Change { slot: SlotId::new(part * 64 + i), word: new[i] });
                changed &= changed - 1;
            }
        }
    }
}

/// Which of up to 64 words differ, as a mask.
fn changed(old: &[u64], new: &[u64]) -> u64 {
    let pairs = old.iter().zip(new).enumerate();
    pairs.fold(0, |mask, (i, (old, new))| mask | u64::from(old != new) << i)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::{Signal, ValueId};
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
                let frame = Frame { tick: tick as u64, words, before: old.map(Vec::as_slice) };
                let got = sampler.sample(frame).expect("inside the window").to_vec();
                let differs = |i: &usize| old.is_none_or(|old| old[*i] != words[*i]);
                let expected = (0..words.len()).filter(differs).map(|i| Change { slot: SlotId::new(i), word: words[i] });
                prop_assert_eq!(got, expected.collect::<Vec<_>>());
                old = Some(words);
            }
        }
    }

    #[test]
    fn outside_the_window_there_is_nothing_and_its_first_tick_yields_every_value() {
        let mut sampler = Sampler::new(&plan(2), Window { from: 3, to: 4 });
        let words = [0, 0];
        let mut yielded =
            |tick| sampler.sample(Frame { tick, words: &words, before: Some(&words) }).map(<[Change]>::len);
        assert_eq!([2, 3, 4, 5].map(&mut yielded), [None, Some(2), Some(0), None]);
    }
}
