//! Lockstep: two engines run the same stimulus, and the first difference between them is named.

use std::collections::HashSet;
use std::fmt;

use super::{Engine, Pulses};
use crate::base::ValueId;
use crate::compile::Program;

/// Runs two engines side by side and behaves like the first.
pub struct Lockstep {
    names: Vec<(String, ValueId)>,
    /// Outputs whose pulses are counted.
    counted: Vec<String>,
    stop: Option<ValueId>,
    engines: [Box<dyn Engine>; 2],
    stride: u64,
    tick: u64,
    difference: Option<Difference>,
}

/// Where two engines went apart.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Difference {
    /// The first tick that was compared and not equal.
    pub tick: u64,
    /// Names of the engines.
    pub engines: [&'static str; 2],
    /// How many ticks each advanced, when that is the difference.
    pub advanced: Option<[u64; 2]>,
    /// Every signal that differs: its name, and the word in either engine.
    pub signals: Vec<(String, [u64; 2])>,
}

impl Lockstep {
    /// Runs `engines`, both new ones of `program`, and compares every observed value after each `stride` ticks.
    /// A stride of 1 names the very tick; a longer one also tests how the engines run when left alone.
    #[must_use]
    pub fn new(program: &Program, engines: [Box<dyn Engine>; 2], stride: u64) -> Self {
        let (names, stop) = (names(program), program.stop);
        let counted = program.pulses.iter().map(|&output| program.outputs[output].name.clone()).collect();
        let mut lockstep = Self { names, counted, stop, engines, stride: stride.max(1), tick: 0, difference: None };
        lockstep.compare(None);
        lockstep
    }

    /// The first difference so far.
    #[must_use]
    pub fn difference(&self) -> Option<&Difference> {
        self.difference.as_ref()
    }

    fn stopped(&self, until_stop: bool) -> bool {
        until_stop && self.stop.is_some_and(|stop| self.value(stop) != 0)
    }

    fn compare(&mut self, advanced: Option<[u64; 2]>) {
        if self.difference.is_some() {
            return;
        }
        let words = |id: ValueId| [self.engines[0].value(id), self.engines[1].value(id)];
        let all = self.names.iter().map(|(name, id)| (name, words(*id)));
        let values = all.map(|(name, words)| (name.clone(), words));
        let signals: Vec<_> = values.chain(self.counts()).filter(|(_, [a, b])| a != b).collect();
        let advanced = advanced.filter(|[a, b]| a != b);
        if advanced.is_some() || !signals.is_empty() {
            let engines = [self.engines[0].name(), self.engines[1].name()];
            self.difference = Some(Difference { tick: self.tick, engines, advanced, signals });
        }
    }
}

impl Lockstep {
    /// Rising edges and high ticks of the counted outputs.
    fn counts(&self) -> impl Iterator<Item = (String, [u64; 2])> {
        let pulses = self.engines[0].pulses().into_iter().zip(self.engines[1].pulses());
        self.counted.iter().zip(pulses).flat_map(|(name, (a, b))| {
            let rising = (format!("rising edges of {name}"), [a.rising, b.rising]);
            [rising, (format!("high ticks of {name}"), [a.high, b.high])]
        })
    }
}

/// Every observed value with a name to tell it by; a value of several names by the first.
fn names(program: &Program) -> Vec<(String, ValueId)> {
    let signals = program.signals.iter().map(|signal| (signal.name(), signal.value));
    let ports = program.inputs.iter().chain(&program.outputs).map(|port| (port.name.clone(), port.value));
    let stop = program.stop.map(|value| ("the stop condition".to_owned(), value));
    let mut all: Vec<_> = signals.chain(ports).chain(stop).collect();
    let mut seen = HashSet::new();
    all.retain(|(_, value)| seen.insert(*value));
    all
}

impl Engine for Lockstep {
    fn name(&self) -> &'static str {
        "lockstep"
    }

    fn set_input(&mut self, input: usize, word: u64) {
        self.engines.iter_mut().for_each(|engine| engine.set_input(input, word));
    }

    fn settle(&mut self) {
        self.engines.iter_mut().for_each(|engine| engine.settle());
        self.compare(None);
    }

    fn advance(&mut self, ticks: u64, until_stop: bool) -> u64 {
        let mut done = 0;
        loop {
            let step = self.stride.min(ticks - done);
            let [a, b] = &mut self.engines;
            let advanced = [a.advance(step, until_stop), b.advance(step, until_stop)];
            done += advanced[0];
            self.tick += advanced[0];
            self.compare(Some(advanced));
            if done == ticks || advanced[0] < step || self.stopped(until_stop) {
                return done;
            }
        }
    }

    fn value(&self, id: ValueId) -> u64 {
        self.engines[0].value(id)
    }

    fn pulses(&self) -> Vec<Pulses> {
        self.engines[0].pulses()
    }

    fn watch(&mut self, ids: &[ValueId]) {
        self.engines[0].watch(ids);
    }

    fn read(&self, words: &mut [u64]) {
        self.engines[0].read(words);
    }
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [a, b] = self.engines;
        write!(f, "{a} and {b} differ at tick {}", self.tick)?;
        if let Some([x, y]) = self.advanced {
            write!(f, "\n  {a} advanced {x} ticks, {b} {y}")?;
        }
        for (name, [x, y]) in &self.signals {
            write!(f, "\n  {name}: {a} {x}, {b} {y}")?;
        }
        Ok(())
    }
}
