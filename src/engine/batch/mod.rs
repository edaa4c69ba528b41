//! Batches: many independent stimuli of one program, run in lanes on all cores, answered in order.
//!
//! A stimulus is one word for each input, held from its tick 0, and the changes of the [`Plan`] that all stimuli share.
//! Stimuli are drawn from a feed and rows given to a sink as they come, so that memory stays flat however many there are.

mod counters;
mod queue;
mod worker;

use std::fmt;
use std::ops::ControlFlow;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use super::lanes::{Compiled, Path};
use crate::base::{Diagnostic, Op};
use crate::compile::{Program, compile_graph};
use queue::Queue;
use worker::Worker;

/// What all stimuli of a batch have in common.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Plan {
    /// Inputs over time, in order of tick.
    pub changes: Vec<InputChange>,
    /// When a run is over.
    pub end: End,
}

/// An input that changes, and stays so until it is changed again.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct InputChange {
    /// Tick of the stimulus from which on the input has the word.
    pub tick: u64,
    /// Input `Op::Input(input)`.
    pub input: usize,
    /// Its new word, which must fit.
    pub word: u64,
}

/// When a run is over.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum End {
    /// After so many ticks, at least 1.
    Ticks(u64),
    /// In the tick in which the program's `stop` is 1, judged from [`Plan::first_judged_tick`] on, or else after `limit`
    /// ticks.
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
}

impl fmt::Display for StoppedBy {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            StoppedBy::Until => "until",
            StoppedBy::Ticks => "ticks",
            StoppedBy::Limit => "limit",
        })
    }
}

impl Plan {
    /// The tick from which on `stop` is judged: 1, or that of the last change if it is later.
    #[must_use]
    pub fn first_judged_tick(&self) -> u64 {
        self.changes.iter().map(|change| change.tick).fold(1, u64::max)
    }

    /// The last tick there may be, and what stops a run there.
    fn last_tick(&self) -> (u64, StoppedBy) {
        match self.end {
            End::Ticks(ticks) => (ticks.saturating_sub(1), StoppedBy::Ticks),
            End::Until { limit } => (limit.saturating_sub(1), StoppedBy::Limit),
        }
    }
}

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
    /// For each of the program's `pulses`, how many ticks it was high, the last one included.
    pub pulses: &'a [u64],
}

/// Draws stimuli: fills the words of the inputs (all 0 at first, each must fit its width) and returns `true`, or
/// returns `false` when there are no more.
pub trait Feed: FnMut(&mut [u64]) -> bool + Send {}
impl<T: FnMut(&mut [u64]) -> bool + Send> Feed for T {}

/// Takes rows in the order of the stimuli; may break the batch off.
pub trait Sink: FnMut(Row<'_>) -> ControlFlow<()> + Send {}
impl<T: FnMut(Row<'_>) -> ControlFlow<()> + Send> Sink for T {}

/// Takes the words of the program's signals at a tick of the stimulus that is watched.
pub trait Sample: FnMut(u64, &[u64]) + Send {}
impl<T: FnMut(u64, &[u64]) + Send> Sample for T {}

/// One stimulus whose waveform is wanted.
pub struct Watch<'a> {
    /// Which stimulus, from 0.
    pub index: u64,
    /// Called for every tick from 0 to the one it stops at, with a word for each of the program's signals.
    pub sample: &'a mut dyn Sample,
}

/// How to run a batch.
pub struct Options<'a> {
    /// Worker threads, at least 1.
    pub threads: usize,
    /// How lanes are computed.
    pub path: Path,
    /// Breaks the batch off when it becomes true.
    pub cancel: Option<&'a AtomicBool>,
    /// A stimulus to watch.
    pub watch: Option<Watch<'a>>,
}

impl Default for Options<'_> {
    /// All cores, the best path.
    fn default() -> Self {
        let threads = std::thread::available_parallelism().map_or(1, usize::from);
        Self { threads, path: Path::best(), cancel: None, watch: None }
    }
}

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

/// Runs every stimulus of `feed` and gives the rows to `sink`, in the order of the stimuli whatever the number of
/// threads.
///
/// # Errors
/// When the threads cannot be started.
pub fn run_batch(
    program: &Program,
    plan: &Plan,
    feed: impl Feed,
    sink: impl Sink,
    options: Options<'_>,
) -> Result<Done, Diagnostic> {
    let job = Job::new(program, plan, options.watch.is_some(), options.path);
    let threads = options.threads.max(1);
    let queue = Queue::new(&job, feed, sink, options.watch, threads);
    let work = || Worker::new(&job, &queue, options.cancel).run();
    if threads == 1 {
        work();
    } else {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        let pool = pool.map_err(|error| Diagnostic::new("C060", format!("cannot start {threads} threads: {error}")))?;
        pool.broadcast(|_| work());
    }
    Ok(queue.done())
}

/// A batch made ready: the program without what nobody sees, compiled to lanes. Values are known by their planes in
/// the recorded history, low bit first.
struct Job {
    plan: Plan,
    compiled: Arc<Compiled>,
    inputs: usize,
    outputs: Vec<Vec<u32>>,
    pulses: Vec<Pulse>,
    signals: Vec<Vec<u32>>,
    stop: Option<u32>,
}

/// How a pulse count is come by.
#[derive(Clone, Debug)]
enum Pulse {
    /// By counting the ticks at which this plane is 1. A 64-bit counter made of planes would cost more than most
    /// circuits.
    Count(u32),
    /// By reading this word.
    Read(Vec<u32>),
}

impl Job {
    fn new(program: &Program, plan: &Plan, keeps_signals: bool, path: Path) -> Self {
        let mut program = program.clone();
        let is_counted: Vec<bool> = (0..program.pulses.len()).map(|i| uncount(&mut program, i)).collect();
        if !keeps_signals {
            program.signals.clear();
        }
        if let End::Ticks(_) = plan.end {
            program.stop = None;
        }
        let program = compile_graph(program);
        let outputs = program.outputs.iter().map(|port| port.value);
        let signals = program.signals.iter().map(|signal| signal.value);
        let counts = program.pulses.iter().map(|(_, value)| *value);
        let mut wanted: Vec<_> =
            outputs.clone().chain(signals.clone()).chain(counts.clone()).chain(program.stop).collect();
        wanted.sort_unstable();
        wanted.dedup();
        let compiled = Compiled::new(&program, &wanted, path);
        let planes = |id| compiled.planes(id).to_vec();
        let pulses = counts.map(planes).zip(is_counted);
        Self {
            plan: plan.clone(),
            inputs: program.inputs.len(),
            outputs: outputs.map(planes).collect(),
            pulses: pulses
                .map(|(planes, counted)| if counted { Pulse::Count(planes[0]) } else { Pulse::Read(planes) })
                .collect(),
            signals: signals.map(planes).collect(),
            stop: program.stop.map(|stop| compiled.planes(stop)[0]),
            compiled: Arc::new(compiled),
        }
    }

    /// Words of a result: outputs, then pulse counts.
    fn result_words(&self) -> usize {
        self.outputs.len() + self.pulses.len()
    }
}

/// If the `i`-th pulse count is a counter of its own (`count(t+1) = count(t) + bit(t)`), puts the bit in its place.
fn uncount(program: &mut Program, i: usize) -> bool {
    let graph = &program.graph;
    let id = program.pulses[i].1;
    let Op::Add(a, b) = graph.node(id).op else { return false };
    for (count, step) in [(a, b), (b, a)] {
        if let (Op::Register(register), Op::ZeroExtend(bit)) = (graph.node(count).op, graph.node(step).op) {
            let register = &graph.registers[register.index()];
            let is_plain = register.enable.is_none() && register.clear.is_none() && register.init == 0;
            if is_plain && register.next == id && graph.width(bit) == 1 {
                program.pulses[i].1 = bit;
                return true;
            }
        }
    }
    false
}

#[cfg(test)]
mod tests;
