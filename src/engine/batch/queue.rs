//! The queue between the feed, the workers and the sink: rows leave in the order in which stimuli came.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};

use super::job::Job;
use super::{Done, Feed, Row, Sink, Watch};
use crate::base::{Edge, StoppedBy};

/// A stimulus on its way to a lane.
#[derive(Clone, Debug)]
pub(super) struct Stimuli {
    pub(super) first: u64,
    /// Input words of one after the other.
    pub(super) words: Vec<u64>,
    pub(super) count: usize,
}

/// What a lane found, for [`Queue::exchange`].
#[derive(Clone, Debug)]
pub(super) struct Found {
    pub(super) index: u64,
    pub(super) ticks: u64,
    pub(super) stopped_by: StoppedBy,
    pub(super) edges: Vec<Edge>,
}

/// Results that wait to be given back.
#[derive(Debug, Default)]
pub(super) struct Results {
    pub(super) found: Vec<Found>,
    /// Outputs and pulse counts of one after the other.
    pub(super) words: Vec<u64>,
}

/// What a worker is told when it asks for stimuli.
#[derive(Debug)]
pub(super) enum Answer {
    Some(Stimuli),
    /// None now: the sink still waits for a row of someone else.
    Later,
    /// None ever again.
    Over,
}

/// Feed, sink, and the rows between them: a ring of as many rows as may be under way.
pub(super) struct Queue<'a, F, S> {
    inner: Mutex<Inner<F, S>>,
    changed: Condvar,
    is_broken_off: AtomicBool,
    watch: Option<(u64, Mutex<Watch<'a>>)>,
    input_words: usize,
    output_words: usize,
    result_words: usize,
}

struct Inner<F, S> {
    feed: F,
    sink: S,
    /// Stimuli drawn so far.
    drawn: u64,
    initial: Vec<u64>,
    done: Done,
    is_exhausted: bool,
    inputs: Vec<u64>,
    results: Vec<u64>,
    found: Vec<Option<Found>>,
}

impl<'a, F: Feed, S: Sink> Queue<'a, F, S> {
    pub(super) fn new(job: &Job, feed: F, sink: S, watch: Option<Watch<'a>>, threads: usize) -> Self {
        // Edges take much more room than words.
        let window = if job.keeps_edges { 2 } else { 16 } * threads * job.compiled.lanes();
        let inner = Inner {
            feed,
            sink,
            drawn: 0,
            initial: job.stimulus.initial.clone(),
            done: Done::default(),
            is_exhausted: false,
            inputs: vec![0; window * job.stimulus.initial.len()],
            results: vec![0; window * job.result_words()],
            found: vec![None; window],
        };
        Self {
            inner: Mutex::new(inner),
            changed: Condvar::new(),
            is_broken_off: AtomicBool::new(false),
            watch: watch.map(|watch| (watch.index, Mutex::new(watch))),
            input_words: job.stimulus.initial.len(),
            output_words: job.outputs.len(),
            result_words: job.result_words(),
        }
    }

    /// A panic of the feed or the sink goes on in its own thread; for the others the batch is over.
    fn lock(&self) -> MutexGuard<'_, Inner<F, S>> {
        self.inner.lock().unwrap_or_else(|poisoned| {
            self.is_broken_off.store(true, Ordering::Relaxed);
            poisoned.into_inner()
        })
    }

    /// Whether nobody needs to go on.
    pub(super) fn is_broken_off(&self) -> bool {
        self.is_broken_off.load(Ordering::Relaxed)
    }

    pub(super) fn done(&self) -> Done {
        let inner = self.lock();
        Done { complete: inner.is_exhausted && inner.done.rows == inner.drawn, ..inner.done }
    }

    /// Gives `results` back and draws up to `count` stimuli. With `may_wait` the answer is never [`Answer::Later`].
    pub(super) fn exchange(&self, results: &mut Results, count: usize, may_wait: bool) -> Answer {
        let mut inner = self.lock();
        self.give_back(&mut inner, results);
        loop {
            if self.is_broken_off() {
                return Answer::Over;
            }
            if let Some(stimuli) = self.draw(&mut inner, count) {
                return Answer::Some(stimuli);
            }
            if inner.is_exhausted {
                return Answer::Over;
            }
            if !may_wait {
                return Answer::Later;
            }
            inner = self.changed.wait(inner).unwrap_or_else(PoisonError::into_inner);
        }
    }

    /// Ends the batch early.
    pub(super) fn break_off(&self, results: &mut Results) {
        let mut inner = self.lock();
        self.give_back(&mut inner, results);
        // Under the lock, or a worker that has just looked would begin to wait for ever.
        self.is_broken_off.store(true, Ordering::Relaxed);
        drop(inner);
        self.changed.notify_all();
    }

    fn draw(&self, inner: &mut Inner<F, S>, count: usize) -> Option<Stimuli> {
        let window = inner.found.len() as u64;
        let mut stimuli = Stimuli { first: inner.drawn, words: Vec::new(), count: 0 };
        while stimuli.count < count && inner.drawn < inner.done.rows + window && !inner.is_exhausted {
            let start = (inner.drawn % window) as usize * self.input_words;
            let inner = &mut *inner;
            let words = &mut inner.inputs[start..start + self.input_words];
            words.copy_from_slice(&inner.initial);
            if (inner.feed)(words) {
                stimuli.words.extend_from_slice(words);
                stimuli.count += 1;
                inner.drawn += 1;
            } else {
                inner.is_exhausted = true;
                self.changed.notify_all();
            }
        }
        (stimuli.count > 0).then_some(stimuli)
    }

    fn give_back(&self, inner: &mut Inner<F, S>, results: &mut Results) {
        let window = inner.found.len() as u64;
        for (i, found) in results.found.drain(..).enumerate() {
            let slot = (found.index % window) as usize;
            let words = &results.words[i * self.result_words..][..self.result_words];
            inner.results[slot * self.result_words..][..self.result_words].copy_from_slice(words);
            inner.found[slot] = Some(found);
        }
        results.words.clear();
        let before = inner.done.rows;
        while !self.is_broken_off()
            && let slot = (inner.done.rows % window) as usize
            && let Some(found) = inner.found[slot].take()
        {
            let words = &inner.results[slot * self.result_words..][..self.result_words];
            let (outputs, pulses) = words.split_at(self.output_words);
            let Found { index, ticks, stopped_by, edges } = found;
            let inputs = &inner.inputs[slot * self.input_words..][..self.input_words];
            inner.done.rows += 1;
            inner.done.ticks += ticks;
            let row = Row { index, inputs, ticks, stopped_by, outputs, pulses, edges: &edges };
            if let ControlFlow::Break(()) = (inner.sink)(row) {
                self.is_broken_off.store(true, Ordering::Relaxed);
            }
        }
        if inner.done.rows > before || self.is_broken_off() {
            self.changed.notify_all();
        }
    }

    /// The stimulus that is watched.
    pub(super) fn watched(&self) -> Option<u64> {
        self.watch.as_ref().map(|(index, _)| *index)
    }

    pub(super) fn sample(&self, tick: u64, words: &[u64]) {
        if let Some((_, watch)) = &self.watch {
            (watch.lock().unwrap_or_else(PoisonError::into_inner).sample)(tick, words);
        }
    }
}
