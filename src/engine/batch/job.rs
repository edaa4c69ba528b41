//! A batch made ready.

use std::sync::Arc;

use crate::base::{Diagnostic, Stimulus, StopRule};
use crate::compile::{Program, compile_graph};
use crate::engine::lanes::{Compiled, Path};

/// A batch made ready: the program without what nobody sees, compiled to lanes. Values are known by their planes in
/// the recorded history, low bit first.
pub(super) struct Job {
    pub stimulus: Stimulus,
    pub compiled: Arc<Compiled>,
    pub outputs: Vec<Vec<u32>>,
    /// The outputs whose pulses are counted, by their planes.
    pub pulses: Vec<u32>,
    pub signals: Vec<Vec<u32>>,
    /// Whether rows have every edge of the outputs whose pulses are counted.
    pub keeps_edges: bool,
    pub stop: Option<u32>,
}

impl Job {
    /// # Errors
    /// `E005` when the program is too large for lanes.
    pub fn new(program: &Program, stimulus: &Stimulus, keeps_signals: bool, path: Path) -> Result<Self, Diagnostic> {
        let mut program = program.clone();
        if !keeps_signals {
            program.signals.clear();
        }
        if let StopRule::Ticks(_) = stimulus.stop {
            program.stop = None;
        }
        let program = compile_graph(program);
        let outputs = program.outputs.iter().map(|port| port.value);
        let signals = program.signals.iter().map(|signal| signal.value);
        let mut wanted: Vec<_> = outputs.clone().chain(signals.clone()).chain(program.stop).collect();
        wanted.sort_unstable();
        wanted.dedup();
        let compiled = Compiled::new(&program, &wanted, path)?;
        let planes = |id| compiled.planes(id).to_vec();
        Ok(Self {
            stimulus: stimulus.clone(),
            outputs: outputs.map(planes).collect(),
            pulses: program.counted().map(|bit| compiled.planes(bit)[0]).collect(),
            signals: signals.map(planes).collect(),
            keeps_edges: false,
            stop: program.stop.map(|stop| compiled.planes(stop)[0]),
            compiled: Arc::new(compiled),
        })
    }

    /// Words of a result: outputs, then pulse counts.
    pub fn result_words(&self) -> usize {
        self.outputs.len() + self.pulses.len()
    }
}
