//! What goes into a batch and what comes out, whatever engine runs it.

use std::ops::ControlFlow;

use crate::base::{Edge, StoppedBy};

/// What came of one stimulus.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Row<'a> {
    /// Which stimulus, from 0.
    pub index: u64,
    /// Its input words at the start, in the order of the program's inputs.
    pub inputs: &'a [u64],
    /// Ticks run, from tick 0 to the one it stopped in.
    pub ticks: u64,
    /// Why it ended.
    pub stopped_by: StoppedBy,
    /// Output words in the last tick, in the order of the program's outputs.
    pub outputs: &'a [u64],
    /// For each output whose pulses the program counts, its rising edges, the last tick included.
    pub pulses: &'a [u64],
    /// Those edges one by one, tick by tick, where the batch was asked for them; else none.
    pub edges: &'a [Edge],
}

/// Draws stimuli: changes the words of the inputs at tick 0, which are [`crate::base::Stimulus::initial`] at first, and returns
/// `true`, or returns `false` when there are no more. Each word must fit its input.
pub trait Feed: FnMut(&mut [u64]) -> bool + Send {}
impl<T: FnMut(&mut [u64]) -> bool + Send> Feed for T {}

/// Takes rows in the order of the stimuli; may break the batch off.
pub trait Sink: FnMut(Row<'_>) -> ControlFlow<()> + Send {}
impl<T: FnMut(Row<'_>) -> ControlFlow<()> + Send> Sink for T {}

/// What a batch did.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Done {
    /// Rows given to the sink.
    pub rows: u64,
    /// Sum of their ticks.
    pub ticks: u64,
    /// Whether all stimuli have their row.
    pub complete: bool,
}
