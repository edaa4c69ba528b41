//! A run: an engine, a stimulus, and what came of it.

use super::stimulus::Stimulus;
use crate::compile::Program;
use crate::engine::{Engine, StoppedBy};

/// What a run came to.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Outcome {
    /// Ticks run: those sampled, from tick 0 to the last one.
    pub ticks: u64,
    /// Why it ended.
    pub stopped_by: StoppedBy,
    /// Words of the outputs in the last tick, in the order of the circuit's header.
    pub outputs: Vec<u64>,
    /// For each one-bit output in that order: how many ticks it was high, when the program counts them.
    pub pulses: Vec<u64>,
}

/// Is called at the sample point of a tick, with the tick and the engine that stands at it.
pub type Sample<'s> = dyn FnMut(u64, &dyn Engine) + 's;

/// Runs `engine`, which stands at tick 0 of `program`, through `stimulus`. With a `sample`, calls it at the sample
/// point of every tick; without, the engine runs freely between input changes.
pub fn run<'s>(
    engine: &mut dyn Engine,
    program: &Program,
    stimulus: &Stimulus,
    sample: Option<&'s mut Sample<'s>>,
) -> Outcome {
    for (input, &word) in stimulus.initial.iter().enumerate() {
        engine.set_input(input, word);
    }
    let mut run = Run { engine, program, stimulus, sample, tick: 0 };
    let last = stimulus.stop.ticks - 1;
    run.stimulate(last);
    run.run_free(last);
    let stopped_by = match stimulus.stop.until {
        Some(_) if run.stops_now() => StoppedBy::Until,
        Some(_) => StoppedBy::Limit,
        None => StoppedBy::Ticks,
    };
    run.outcome(stopped_by)
}

struct Run<'a, 's> {
    engine: &'a mut dyn Engine,
    program: &'a Program,
    stimulus: &'a Stimulus,
    sample: Option<&'s mut Sample<'s>>,
    tick: u64,
}

impl Run<'_, '_> {
    /// From tick 0 through all changes of inputs to the first tick in which the stop is judged.
    fn stimulate(&mut self, last: u64) {
        let stimulus = self.stimulus;
        let begun = stimulus.changes.first().is_some_and(|(tick, _)| *tick == 0);
        if !begun {
            self.apply(&[]);
        }
        for (tick, words) in stimulus.changes.iter().take_while(|(tick, _)| *tick <= last) {
            self.go_to(*tick);
            self.apply(words);
        }
        let judged = stimulus.stop.first_judged.min(last);
        if self.tick < judged {
            self.go_to(judged);
            self.observe();
        }
    }

    /// On to the tick in which the run stops, or the last one.
    fn run_free(&mut self, last: u64) {
        while self.tick < last && !self.stops_now() {
            let ticks = if self.sample.is_some() { 1 } else { last - self.tick };
            self.tick += self.engine.advance(ticks, self.stimulus.stop.until.is_some());
            self.observe();
        }
    }

    /// Advances to `tick` without judging, observing every tick before it: its own inputs may still change.
    fn go_to(&mut self, tick: u64) {
        while self.tick < tick {
            let ticks = if self.sample.is_some() { 1 } else { tick - self.tick };
            self.tick += self.engine.advance(ticks, false);
            if self.tick < tick {
                self.observe();
            }
        }
    }

    fn apply(&mut self, words: &[(usize, u64)]) {
        for &(input, word) in words {
            self.engine.set_input(input, word);
        }
        self.engine.settle();
        self.observe();
    }

    fn observe(&mut self) {
        if let Some(sample) = &mut self.sample {
            sample(self.tick, self.engine);
        }
    }

    fn stops_now(&self) -> bool {
        let rule = self.stimulus.stop;
        let wanted = rule.until.is_some() && self.tick >= rule.first_judged;
        wanted && self.program.stop.is_some_and(|stop| self.engine.value(stop) != 0)
    }

    fn outcome(&self, stopped_by: StoppedBy) -> Outcome {
        let value = |id| self.engine.value(id);
        Outcome {
            ticks: self.tick + 1,
            stopped_by,
            outputs: self.program.outputs.iter().map(|port| value(port.value)).collect(),
            pulses: self.program.pulses.iter().map(|&(_, count)| value(count)).collect(),
        }
    }
}
