//! A batch: many stimuli of one design, one row of results each, in order.

use std::ops::ControlFlow;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use super::run::Input;
use super::{Design, EngineKind, Outcome, Run};
use crate::base::{Diagnostic, Edge, Port, Report};
use crate::compile::{Observe, compile};
use crate::engine::batch::{Done, Feed, Row, Sink};
use crate::trace::Edges;

/// Many stimuli of a design. All share the scenario's changes over time and its stop rule; each has inputs of its own
/// at tick 0.
///
/// ```
/// use std::ops::ControlFlow;
/// use stepwright::simulation::Session;
///
/// let design = Session::open("su1522157/interpolator")?.elaborate()?;
/// let batch = design.batch();
/// let minor = batch.input("minor_34")?;
/// let mut minors = 0..=8;
/// let feed = |words: &mut [u64]| minors.next().map(|word| words[minor.place()] = word).is_some();
/// let mut ticks = Vec::new();
/// batch.run(feed, |row| {
///     ticks.push(row.ticks);
///     ControlFlow::Continue(())
/// })?;
/// assert_eq!(ticks.len(), 9);
/// # Ok::<(), stepwright::base::Report>(())
/// ```
pub struct Batch<'a> {
    design: &'a Design,
    program: Arc<crate::compile::Program>,
    engine: EngineKind,
    #[cfg_attr(not(feature = "lanes"), expect(dead_code, reason = "only the lanes engine runs on several threads"))]
    threads: Option<usize>,
    cancel: Option<&'a AtomicBool>,
    edges: bool,
}

impl Design {
    /// Many stimuli at once, on the engine that was chosen; [`EngineKind::AUTO`] is the lanes engine on all cores.
    #[must_use]
    pub fn batch(&self) -> Batch<'_> {
        let program = compile(self.netlist(), &Observe { until: self.until(), pulses: true, ..Observe::OUTPUTS });
        Batch {
            design: self,
            program: Arc::new(program),
            engine: self.engine(),
            threads: None,
            cancel: None,
            edges: false,
        }
    }
}

impl<'a> Batch<'a> {
    /// The same batch without the counts of pulses, which cost something in every tick.
    #[must_use]
    pub fn without_pulses(self) -> Self {
        let program = compile(self.design.netlist(), &Observe { until: self.design.until(), ..Observe::OUTPUTS });
        Self { program: Arc::new(program), ..self }
    }

    /// The same batch on so many threads.
    ///
    /// # Errors
    /// `C067` more than one for an engine that runs one stimulus after another.
    pub fn threads(self, threads: usize) -> Result<Self, Diagnostic> {
        let has_lanes = cfg!(feature = "lanes") && self.engine.runs_many();
        if threads > 1 && !has_lanes {
            let message = format!("{threads} threads for the engine `{}`, which runs on one", self.engine.name());
            return Err(Diagnostic::new("C067", message).help("leave out --threads, or take the lanes engine"));
        }
        Ok(Self { threads: Some(threads), ..self })
    }

    /// Breaks the batch off, soon, when `cancel` becomes true.
    #[must_use]
    pub fn cancelled_by(self, cancel: &'a AtomicBool) -> Self {
        Self { cancel: Some(cancel), ..self }
    }

    /// The same batch, whose rows have every rising edge of the one-bit outputs, besides how many there are. Rows take
    /// more memory so, and fewer are under way.
    #[must_use]
    pub fn with_edges(self) -> Self {
        Self { edges: true, ..self }
    }

    /// The inputs: a stimulus has a word for each, in this order.
    #[must_use]
    pub fn inputs(&self) -> &[Port] {
        &self.program.inputs
    }

    /// The outputs: a row has a word for each, in this order.
    #[must_use]
    pub fn outputs(&self) -> &[Port] {
        &self.program.outputs
    }

    /// The one-bit outputs: a row has their pulses, in this order.
    pub fn counted(&self) -> impl Iterator<Item = &Port> {
        self.program.pulses.iter().map(|&output| &self.program.outputs[output])
    }

    /// The input of a name.
    ///
    /// # Errors
    /// `S010` the circuit has no such input.
    pub fn input(&self, name: &str) -> Result<Input, Report> {
        Input::find(self.inputs(), name)
    }

    /// Runs every stimulus that `feed` draws, and gives their rows to `sink`, in order. The words are those of the
    /// scenario before `feed` changes them.
    ///
    /// # Errors
    /// When the threads cannot be started or there is no such engine here.
    pub fn run(&self, mut feed: impl Feed, mut sink: impl Sink) -> Result<Done, Report> {
        if !self.engine.runs_many() {
            return self.one_by_one(feed, sink);
        }
        let is_too_large = |report: &Report| report.diagnostics.iter().any(|one| one.code == "E005");
        match self.in_lanes(&mut feed, &mut sink) {
            // No stimulus has been drawn by then.
            Err(report) if self.engine == EngineKind::AUTO && is_too_large(&report) => self.one_by_one(feed, sink),
            done => done,
        }
    }

    #[cfg(feature = "lanes")]
    fn in_lanes(&self, feed: impl Feed, sink: impl Sink) -> Result<Done, Report> {
        use crate::engine::batch::{Options, run_batch};
        let mut options = Options { cancel: self.cancel, edges: self.edges, ..Options::default() };
        options.threads = self.threads.unwrap_or(options.threads);
        Ok(run_batch(&self.program, self.design.stimulus(), feed, sink, options)?)
    }

    #[cfg(not(feature = "lanes"))]
    fn in_lanes(&self, feed: impl Feed, sink: impl Sink) -> Result<Done, Report> {
        self.one_by_one(feed, sink)
    }

    /// One stimulus after another, on one core.
    fn one_by_one(&self, mut feed: impl Feed, mut sink: impl Sink) -> Result<Done, Report> {
        let mut stimulus = self.design.stimulus().clone();
        let mut done = Done::default();
        loop {
            stimulus.initial.clone_from(&self.design.stimulus().initial);
            if !feed(&mut stimulus.initial) {
                return Ok(Done { complete: true, ..done });
            }
            let mut edges = Edges::default();
            let mut run = Run::of(Arc::clone(&self.program), stimulus.clone(), self.engine)?;
            if let Some(cancel) = self.cancel {
                run = run.cancelled_by(cancel);
            }
            if self.edges {
                run.add(Box::new(&mut edges), &self.program.counted().collect::<Vec<_>>());
            }
            let outcome = run.finish()?;
            drop(run);
            let is_cancelled = self.cancel.is_some_and(|cancel| cancel.load(Ordering::Relaxed));
            if is_cancelled || give(&mut sink, &mut done, &stimulus.initial, &outcome, edges.edges()).is_break() {
                return Ok(done);
            }
        }
    }
}

/// Gives the row of a stimulus.
fn give(sink: &mut impl Sink, done: &mut Done, inputs: &[u64], outcome: &Outcome, edges: &[Edge]) -> ControlFlow<()> {
    let Outcome { ticks, stopped_by, outputs } = outcome;
    let (index, ticks, stopped_by) = (done.rows, *ticks, *stopped_by);
    let pulses: Vec<_> = outputs.iter().filter_map(|output| output.pulses).map(|pulses| pulses.rising).collect();
    let outputs: Vec<_> = outputs.iter().map(|output| output.word).collect();
    *done = Done { rows: done.rows + 1, ticks: done.ticks + ticks, ..*done };
    sink(Row { index, inputs, ticks, stopped_by, outputs: &outputs, pulses: &pulses, edges })
}
