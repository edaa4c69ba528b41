//! How the rows of a sweep are computed: in lanes, or one stimulus after another on an engine of choice.

use std::ops::ControlFlow;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use super::stimuli::Feed;
use crate::base::Report;
use crate::cli::prepare::Prepared;
use crate::compile::Program;
use crate::engine::EngineKind;
use crate::engine::batch::{Done, End, InputChange, Options, Plan, Row, run_batch};
use crate::simulation::{self, Stimulus};

/// What to run the stimuli on.
pub struct Job<'a> {
    pub prepared: &'a Prepared,
    pub program: &'a Arc<Program>,
    pub threads: Option<usize>,
    pub engine: EngineKind,
    pub cancel: &'a AtomicBool,
}

impl Job<'_> {
    /// Runs all stimuli of `feed`.
    ///
    /// # Errors
    /// When threads or an engine cannot be made.
    pub fn run(&self, feed: Feed, sink: impl FnMut(Row<'_>) -> ControlFlow<()> + Send) -> Result<Done, Report> {
        match self.engine {
            EngineKind::Auto | EngineKind::Lanes => self.in_lanes(feed, sink),
            engine => self.one_by_one(engine, feed, sink),
        }
    }

    fn in_lanes(&self, feed: Feed, sink: impl FnMut(Row<'_>) -> ControlFlow<()> + Send) -> Result<Done, Report> {
        let mut options = Options { cancel: Some(self.cancel), ..Options::default() };
        options.threads = self.threads.unwrap_or(options.threads);
        Ok(run_batch(self.program, &plan(&self.prepared.stimulus), feed, sink, options)?)
    }

    fn one_by_one(
        &self,
        engine: EngineKind,
        mut feed: Feed,
        mut sink: impl FnMut(Row<'_>) -> ControlFlow<()>,
    ) -> Result<Done, Report> {
        let mut stimulus = self.prepared.stimulus.clone();
        let mut inputs = stimulus.initial.clone();
        let mut done = Done::default();
        while !self.cancel.load(Ordering::Relaxed) {
            if !feed(&mut inputs) {
                done.complete = true;
                break;
            }
            stimulus.initial.clone_from(&inputs);
            let mut engine = engine.build(Arc::clone(self.program), stimulus.stop.ticks)?;
            let outcome = simulation::run(engine.as_mut(), self.program, &stimulus, None);
            let (index, ticks, stopped_by) = (done.rows, outcome.ticks, outcome.stopped_by);
            let (outputs, pulses) = (&outcome.outputs, &outcome.pulses);
            done = Done { rows: done.rows + 1, ticks: done.ticks + ticks, ..done };
            if sink(Row { index, inputs: &inputs, ticks, stopped_by, outputs, pulses }).is_break() {
                break;
            }
        }
        Ok(done)
    }
}

/// What all stimuli of the sweep have in common.
fn plan(stimulus: &Stimulus) -> Plan {
    let changes = stimulus
        .changes
        .iter()
        .flat_map(|(tick, words)| words.iter().map(|&(input, word)| InputChange { tick: *tick, input, word }));
    let ticks = stimulus.stop.ticks;
    let end = if stimulus.stop.until.is_some() { End::Until { limit: ticks } } else { End::Ticks(ticks) };
    Plan { changes: changes.collect(), end }
}
