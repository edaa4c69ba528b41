//! What an engine has to tell about its own work.

use std::time::Duration;

/// What specialised code runs, and how often.
#[derive(Clone, PartialEq, Debug)]
pub struct Stats {
    /// A tick of the plain code.
    pub whole: Work,
    /// For each leaf of the decision tree: what is left of a tick, and its share of the profile's ticks, 0 to 1.
    pub leaves: Vec<(Work, f64)>,
    /// How long it took to grow the tree and to compile it.
    pub made_in: Duration,
    /// Ticks that the specialised code has run.
    pub ticks: u64,
    /// How often it has left a tick to the plain code, or has stopped.
    pub rests: u64,
}

/// What is to be done in a tick.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Work {
    /// Ops to compute.
    pub ops: usize,
    /// Registers to store.
    pub registers: usize,
}
