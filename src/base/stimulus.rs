//! A stimulus in words: what is done to a program's inputs, when a run is over, and why it ended.

use std::fmt;

/// What is done to the inputs of one run, or of every run of a batch, and when it is over.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Stimulus {
    /// The word of every input at tick 0 before the changes of tick 0, in the order of the program's inputs.
    pub initial: Vec<u64>,
    /// Inputs over time, in order of tick.
    pub changes: Vec<Change>,
    /// When a run is over.
    pub stop: StopRule,
}

/// An input that changes, and stays so until it is changed again.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Change {
    /// The tick from which on the input has the word.
    pub tick: u64,
    /// Input `Op::Input(input)`.
    pub input: usize,
    /// Its new word, which must fit.
    pub word: u64,
}

/// When a run is over.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum StopRule {
    /// After so many ticks, at least 1.
    Ticks(u64),
    /// In the tick in which the program's stop condition is 1, judged from [`Stimulus::first_judged_tick`] on, or else
    /// after `limit` ticks.
    Until {
        /// Most ticks, at least 1.
        limit: u64,
    },
}

/// Why a run ended.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum StoppedBy {
    /// The net it waited for.
    Until,
    /// The number of ticks asked for.
    Ticks,
    /// The limit: the net it waited for never came.
    Limit,
    /// It was broken off from outside.
    Interrupt,
}

impl Stimulus {
    /// The first tick in which the stop condition is judged: not before tick 1, and not before the last change of an
    /// input, because a circuit at rest would otherwise satisfy `!busy` before it has begun.
    #[must_use]
    pub fn first_judged_tick(&self) -> u64 {
        self.changes.iter().map(|change| change.tick).fold(1, u64::max)
    }

    /// The last tick there may be, and what stops a run there.
    #[must_use]
    pub fn last_tick(&self) -> (u64, StoppedBy) {
        match self.stop {
            StopRule::Ticks(ticks) => (ticks.saturating_sub(1), StoppedBy::Ticks),
            StopRule::Until { limit } => (limit.saturating_sub(1), StoppedBy::Limit),
        }
    }
}

impl fmt::Display for StoppedBy {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            StoppedBy::Until => "until",
            StoppedBy::Ticks => "ticks",
            StoppedBy::Limit => "limit",
            StoppedBy::Interrupt => "interrupt",
        })
    }
}
