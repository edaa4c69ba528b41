//! A worker: one machine of lanes that is kept full.
//!
//! It runs blocks of ticks. After each block the lanes that stopped in it are read at their very tick from the recorded
//! history and refilled; a block is only as long as makes the ticks lost after a stop few against the lengths of runs,
//! and ends early where inputs have to change. Lanes that were filled together form a cohort: they share one time.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use super::counters::{EdgeCounters, MOST_WORDS};
use super::edges::Edges;
use super::job::Job;
use super::queue::{Answer, Found, Queue, Results, Stimuli};
use super::{Feed, Sink};
use crate::base::{Stimulus, StopRule, StoppedBy};
use crate::engine::lanes::Machine;

/// How many stimuli are drawn, and how many results kept, between two visits to the queue.
const CHUNK: usize = 256;
/// A run is to lose at most one part in so many to the rest of its last block.
const SHARE_LOST: u64 = 32;

pub(super) struct Worker<'a, 'w, F, S> {
    job: &'a Job,
    queue: &'a Queue<'w, F, S>,
    cancel: Option<&'a AtomicBool>,
    machine: Machine,
    lanes: Vec<Lane>,
    /// Lanes that run.
    active: Vec<u64>,
    /// Lanes whose stop is judged.
    judged: Vec<u64>,
    /// Cohorts whose inputs will still change, oldest first.
    cohorts: Vec<Cohort>,
    events: Vec<Event>,
    /// Ticks run since the worker began; the machine stands at this one.
    now: u64,
    /// No lane reaches the last tick there may be before this one.
    deadline: u64,
    waiting: Stimuli,
    /// How many of the waiting stimuli are in lanes already.
    taken: usize,
    is_over: bool,
    results: Results,
    counters: Vec<EdgeCounters>,
    /// The edges themselves, where they are kept.
    edges: Option<Edges>,
    /// A slow mean of the lengths of runs, times 64.
    usual_ticks: u64,
}

#[derive(Clone, Copy, Debug, Default)]
struct Lane {
    index: u64,
    start: u64,
}

#[derive(Clone, Debug)]
struct Cohort {
    start: u64,
    mask: Vec<u64>,
    next_event: usize,
}

/// What happens to a cohort at a tick of its own.
#[derive(Clone, Debug)]
struct Event {
    tick: u64,
    /// Inputs and their new words.
    changes: Vec<(usize, u64)>,
    is_judged_from_here: bool,
}

fn events(stimulus: &Stimulus) -> Vec<Event> {
    let mut events: Vec<Event> = Vec::new();
    for change in &stimulus.changes {
        match events.last_mut().filter(|event| event.tick == change.tick) {
            Some(event) => event.changes.push((change.input, change.word)),
            None => {
                let changes = vec![(change.input, change.word)];
                events.push(Event { tick: change.tick, changes, is_judged_from_here: false });
            }
        }
    }
    if let StopRule::Until { .. } = stimulus.stop {
        let tick = stimulus.first_judged_tick();
        match events.last_mut().filter(|event| event.tick == tick) {
            Some(event) => event.is_judged_from_here = true,
            None => events.push(Event { tick, changes: Vec::new(), is_judged_from_here: true }),
        }
    }
    events.retain(|event| event.tick <= stimulus.last_tick().0);
    events
}

/// The lanes of a mask.
fn lanes_of(mask: &[u64]) -> impl Iterator<Item = usize> + '_ {
    mask.iter().enumerate().flat_map(|(at, &word)| {
        std::iter::successors(Some(word), |word| Some(word & word.wrapping_sub(1)))
            .take_while(|&word| word != 0)
            .map(move |word| at * 64 + word.trailing_zeros() as usize)
    })
}

fn clear(mask: &mut [u64], lane: usize) {
    mask[lane / 64] &= !(1 << (lane % 64));
}

impl<'a, 'w, F: Feed, S: Sink> Worker<'a, 'w, F, S> {
    pub(super) fn new(job: &'a Job, queue: &'a Queue<'w, F, S>, cancel: Option<&'a AtomicBool>) -> Self {
        let machine = Machine::new(Arc::clone(&job.compiled));
        let lanes = job.compiled.lanes();
        let counted = job.pulses.iter().map(|_| EdgeCounters::new(lanes / 64));
        Self {
            job,
            queue,
            cancel,
            machine,
            lanes: vec![Lane::default(); lanes],
            active: vec![0; lanes / 64],
            judged: vec![0; lanes / 64],
            cohorts: Vec::new(),
            events: events(&job.stimulus),
            now: 0,
            deadline: u64::MAX,
            waiting: Stimuli { first: 0, words: Vec::new(), count: 0 },
            taken: 0,
            is_over: false,
            results: Results::default(),
            counters: counted.collect(),
            edges: job.keeps_edges.then(|| Edges::new(lanes, job.pulses.len())),
            usual_ticks: 64 * SHARE_LOST,
        }
    }

    pub(super) fn run(mut self) {
        loop {
            if self.cancel.is_some_and(|cancel| cancel.load(Ordering::Relaxed)) || self.queue.is_broken_off() {
                self.queue.break_off(&mut self.results);
                return;
            }
            self.fill();
            if self.active.iter().all(|&word| word == 0) {
                break;
            }
            self.happen();
            let ticks = self.block();
            self.machine.pass(ticks);
            self.watch(ticks);
            self.harvest(ticks);
            self.count(ticks);
            self.machine.commit();
            self.now += ticks as u64;
        }
        // Nothing can be drawn any more: this only gives back what is left.
        let _ = self.queue.exchange(&mut self.results, 0, false);
    }

    /// Puts stimuli into all free lanes, as one cohort.
    fn fill(&mut self) {
        let mut mask = vec![0; self.active.len()];
        let mut may_wait = self.active.iter().all(|&word| word == 0);
        for (at, started) in mask.iter_mut().enumerate() {
            let mut free = !self.active[at];
            while free != 0 && self.has_stimulus(may_wait) {
                let lane = free & free.wrapping_neg();
                free ^= lane;
                *started |= lane;
                may_wait = false;
                self.start(at * 64 + lane.trailing_zeros() as usize);
            }
        }
        if mask.iter().any(|&word| word != 0) {
            self.begin(mask);
        }
    }

    /// Puts the lanes of a new cohort at their tick 0.
    fn begin(&mut self, mask: Vec<u64>) {
        self.machine.reset(&mask);
        self.counters.iter_mut().for_each(|counters| counters.clear(&mask));
        self.edges.iter_mut().for_each(|edges| edges.clear(&mask));
        for (at, word) in mask.iter().enumerate() {
            self.active[at] |= word;
            self.judged[at] &= !word;
        }
        self.deadline = self.deadline.min(self.now.saturating_add(self.job.stimulus.last_tick().0));
        self.cohorts.push(Cohort { start: self.now, mask, next_event: 0 });
    }

    /// Whether a stimulus is at hand; draws more when there is none.
    fn has_stimulus(&mut self, may_wait: bool) -> bool {
        if self.taken == self.waiting.count && !self.is_over {
            self.waiting.count = 0;
            self.taken = 0;
            match self.queue.exchange(&mut self.results, CHUNK, may_wait) {
                Answer::Some(stimuli) => self.waiting = stimuli,
                Answer::Later => {}
                Answer::Over => self.is_over = true,
            }
        }
        self.taken < self.waiting.count
    }

    fn start(&mut self, lane: usize) {
        let inputs = self.job.stimulus.initial.len();
        let words = &self.waiting.words[self.taken * inputs..][..inputs];
        for (input, &word) in words.iter().enumerate() {
            self.machine.set(lane, input, word);
        }
        self.lanes[lane] = Lane { index: self.waiting.first + self.taken as u64, start: self.now };
        self.taken += 1;
    }

    /// Lets the events of this tick happen to the cohorts they are due for.
    fn happen(&mut self) {
        for cohort in &mut self.cohorts {
            while let Some(event) = self.events.get(cohort.next_event)
                && cohort.start + event.tick == self.now
            {
                for &(input, word) in &event.changes {
                    self.machine.set_all(&cohort.mask, input, word);
                }
                if event.is_judged_from_here {
                    self.judged.iter_mut().zip(&cohort.mask).for_each(|(judged, mask)| *judged |= mask);
                }
                cohort.next_event += 1;
            }
        }
        let events = self.events.len();
        self.cohorts.retain(|cohort| cohort.next_event < events);
    }

    /// How many ticks to run next.
    fn block(&self) -> usize {
        let usual = (self.usual_ticks / 64 / SHARE_LOST).clamp(1, self.job.compiled.most_ticks as u64);
        let next_event = |cohort: &Cohort| cohort.start + self.events[cohort.next_event].tick - self.now;
        self.cohorts.iter().map(next_event).fold(usual, u64::min) as usize
    }

    /// Shows the stimulus that is watched.
    fn watch(&mut self, ticks: usize) {
        let Some(index) = self.queue.watched() else { return };
        let Some(lane) = lanes_of(&self.active).find(|&lane| self.lanes[lane].index == index) else { return };
        let start = self.lanes[lane].start;
        let last = start.saturating_add(self.job.stimulus.last_tick().0);
        for tick in 0..ticks {
            let read = |planes: &[u32]| self.machine.history().word(tick, planes, lane);
            let words: Vec<_> = self.job.signals.iter().map(|planes| read(planes)).collect();
            let at = self.now + tick as u64;
            self.queue.sample(at - start, &words);
            let is_judged = self.judged[lane / 64] >> (lane % 64) & 1 == 1;
            if at == last || is_judged && self.job.stop.is_some_and(|stop| read(&[stop]) != 0) {
                break;
            }
        }
    }

    /// Reads the lanes that stopped in the block.
    fn harvest(&mut self, ticks: usize) {
        let end = self.now + ticks as u64;
        let has_deadline = self.deadline < end;
        for tick in 0..ticks {
            self.keep_edges(tick);
            if let Some(stop) = self.job.stop {
                self.finish_stopped(tick, stop);
            }
            if has_deadline {
                self.finish_at_deadline(tick);
            }
        }
        if has_deadline {
            let last = self.job.stimulus.last_tick().0;
            let starts = lanes_of(&self.active).map(|lane| self.lanes[lane].start);
            self.deadline = starts.min().map_or(u64::MAX, |start| start.saturating_add(last));
        }
        if self.results.found.len() >= CHUNK {
            let _ = self.queue.exchange(&mut self.results, 0, false);
        }
    }

    /// Keeps the edges of a tick of the block, in lanes that have not stopped before it.
    fn keep_edges(&mut self, tick: usize) {
        let Some(edges) = &mut self.edges else { return };
        let (history, at) = (self.machine.history(), self.now + tick as u64);
        for (pulse, &plane) in self.job.pulses.iter().enumerate() {
            edges.look(pulse, history.plane(tick, plane), &self.active, |lane| at - self.lanes[lane].start);
        }
    }

    fn finish_stopped(&mut self, tick: usize, stop: u32) {
        let mut stopped = [0; MOST_WORDS];
        let mut any = 0;
        let masks = self.active.iter().zip(&self.judged);
        for ((stopped, plane), (active, judged)) in
            stopped.iter_mut().zip(self.machine.history().plane(tick, stop)).zip(masks)
        {
            *stopped = plane & active & judged;
            any |= *stopped;
        }
        if any != 0 {
            lanes_of(&stopped).for_each(|lane| self.finish(lane, tick, StoppedBy::Until));
        }
    }

    fn finish_at_deadline(&mut self, tick: usize) {
        let (last, stopped_by) = self.job.stimulus.last_tick();
        let at = self.now + tick as u64;
        let due: Vec<_> = lanes_of(&self.active).filter(|&lane| at - self.lanes[lane].start.min(at) == last).collect();
        due.into_iter().for_each(|lane| self.finish(lane, tick, stopped_by));
    }

    /// Reads a lane at the tick of the block where its run is over.
    fn finish(&mut self, lane: usize, tick: usize, stopped_by: StoppedBy) {
        let Lane { index, start } = self.lanes[lane];
        let ticks = self.now + tick as u64 - start + 1;
        let history = self.machine.history();
        let words = &mut self.results.words;
        words.extend(self.job.outputs.iter().map(|planes| history.word(tick, planes, lane)));
        for (&plane, counters) in self.job.pulses.iter().zip(&self.counters) {
            let block = (0..=tick).map(|tick| history.bit(tick, plane, lane));
            words.push(counters.count(lane, block));
        }
        let edges = self.edges.as_mut().map(|edges| edges.take(lane)).unwrap_or_default();
        self.results.found.push(Found { index, ticks, stopped_by, edges });
        clear(&mut self.active, lane);
        self.usual_ticks = (self.usual_ticks - self.usual_ticks / 64).saturating_add(ticks);
    }

    /// Counts the pulses of the block.
    fn count(&mut self, ticks: usize) {
        let history = self.machine.history();
        for (&plane, counters) in self.job.pulses.iter().zip(&mut self.counters) {
            counters.add((0..ticks).map(|tick| history.plane(tick, plane)));
        }
    }
}
