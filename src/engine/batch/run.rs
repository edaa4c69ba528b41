//! A batch in lanes, on all cores.
//!
//! All stimuli share the changes and the stop rule of one [`Stimulus`]; each has input words of its own at tick 0. They
//! are drawn from a feed and rows given to a sink as they come, so that memory stays flat however many there are.

use std::sync::atomic::AtomicBool;

use super::job::Job;
use super::queue::Queue;
use super::worker::Worker;
use super::{Done, Feed, Sink};
use crate::base::{Diagnostic, Stimulus};
use crate::compile::Program;
use crate::engine::lanes::Path;

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
    /// Whether rows have every edge, besides how many there are.
    pub edges: bool,
    /// A stimulus to watch.
    pub watch: Option<Watch<'a>>,
}

impl Default for Options<'_> {
    /// All cores, the best path.
    fn default() -> Self {
        let threads = std::thread::available_parallelism().map_or(1, usize::from);
        Self { threads, path: Path::best(), cancel: None, edges: false, watch: None }
    }
}

/// Runs every stimulus of `feed` and gives the rows to `sink`, in the order of the stimuli whatever the number of
/// threads.
///
/// # Errors
/// When the threads cannot be started, or the program is too large for lanes (`E005`).
pub fn run_batch(
    program: &Program,
    stimulus: &Stimulus,
    feed: impl Feed,
    sink: impl Sink,
    options: Options<'_>,
) -> Result<Done, Diagnostic> {
    let job = Job::new(program, stimulus, options.watch.is_some(), options.path)?;
    let job = Job { keeps_edges: options.edges, ..job };
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
