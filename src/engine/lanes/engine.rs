//! The lanes engine for a single run: one lane of a machine, behind the same face as every engine.

use std::sync::Arc;

use super::{Compiled, Machine, Path};
use crate::base::{Diagnostic, ValueId};
use crate::compile::Program;
use crate::engine::pulses::PulseMeter;
use crate::engine::{Engine, EngineFormat, Pulses};

/// The lanes engine by its name.
pub(in crate::engine) static ENGINE: EngineFormat = EngineFormat {
    name: "lanes",
    doc: "Hundreds of stimuli at once, for a sweep",
    runs_many: true,
    build: |program, _| Ok(Box::new(LanesEngine::new(&program)?)),
};

/// Runs one stimulus in one lane. It gains nothing by that; it is there to be compared with the other engines.
#[derive(Debug)]
pub struct LanesEngine {
    machine: Machine,
    stop: Option<ValueId>,
    /// The tick of the last pass at which it stands.
    at: usize,
    inputs_changed: bool,
    watched: Vec<ValueId>,
    counted: Vec<ValueId>,
    pulses: PulseMeter,
}

impl LanesEngine {
    /// Puts `program` at tick 0 with all inputs 0, on the best path this machine has.
    ///
    /// # Errors
    /// `E005` when the program is too large for it.
    pub fn new(program: &Program) -> Result<Self, Diagnostic> {
        Self::on(program, Path::best())
    }

    /// The same on a path of choice.
    ///
    /// # Errors
    /// As for [`LanesEngine::new`].
    pub fn on(program: &Program, path: Path) -> Result<Self, Diagnostic> {
        let compiled = Arc::new(Compiled::new(program, &program.observed(), path)?);
        let mut machine = Machine::new(compiled);
        machine.pass(1);
        let counted: Vec<_> = program.counted().collect();
        let pulses = PulseMeter::new(counted.len());
        Ok(Self { machine, stop: program.stop, at: 0, inputs_changed: false, watched: Vec::new(), counted, pulses })
    }

    fn is_high(&self, counted: usize, tick: usize) -> bool {
        self.machine.history().word(tick, self.machine.compiled().planes(self.counted[counted]), 0) != 0
    }

    /// Counts the pulses of a tick of the last pass, which ends.
    fn leave(&mut self, tick: usize) {
        let mut pulses = std::mem::replace(&mut self.pulses, PulseMeter::new(0));
        pulses.leave(|i| self.is_high(i, tick));
        self.pulses = pulses;
    }

    fn has_stopped(&self, tick: usize) -> bool {
        self.stop.is_some_and(|stop| self.machine.history().word(tick, self.machine.compiled().planes(stop), 0) != 0)
    }

    /// Advances by one block of ticks; tells how many and whether the program stopped.
    fn block(&mut self, ticks: usize, until_stop: bool) -> (usize, bool) {
        self.leave(self.at);
        self.machine.commit();
        let before = if until_stop && ticks > 1 { self.machine.present_state() } else { Vec::new() };
        self.machine.pass(ticks);
        self.at = ticks - 1;
        let stopped = if until_stop { (0..ticks).find(|&tick| self.has_stopped(tick)) } else { None };
        if let Some(tick) = stopped.filter(|tick| tick + 1 < ticks) {
            self.machine.rewind(&before);
            self.machine.pass(tick + 1);
            self.at = tick;
        }
        (0..self.at).for_each(|tick| self.leave(tick));
        (self.at + 1, stopped.is_some())
    }
}

impl Engine for LanesEngine {
    fn name(&self) -> &'static str {
        ENGINE.name
    }

    fn set_input(&mut self, input: usize, word: u64) {
        self.machine.set(0, input, word);
        self.inputs_changed = true;
    }

    fn settle(&mut self) {
        self.machine.pass(1);
        self.at = 0;
        self.inputs_changed = false;
    }

    fn advance(&mut self, ticks: u64, until_stop: bool) -> u64 {
        if std::mem::take(&mut self.inputs_changed) {
            self.settle();
        }
        // Large RAMs cannot be taken back, so that a block with a stop in its middle must not be run.
        let can_rewind = self.machine.compiled().can_rewind();
        let most = if until_stop && !can_rewind { 1 } else { self.machine.compiled().most_ticks as u64 };
        let mut done = 0;
        while done < ticks {
            let (advanced, stopped) = self.block(most.min(ticks - done) as usize, until_stop);
            done += advanced as u64;
            if stopped {
                break;
            }
        }
        done
    }

    fn value(&self, id: ValueId) -> u64 {
        self.machine.history().word(self.at, self.machine.compiled().planes(id), 0)
    }

    fn pulses(&self) -> Vec<Pulses> {
        self.pulses.counts(|i| self.is_high(i, self.at))
    }

    fn watch(&mut self, ids: &[ValueId]) {
        self.watched = ids.to_vec();
    }

    fn read(&self, words: &mut [u64]) {
        for (word, &id) in words.iter_mut().zip(&self.watched) {
            *word = self.value(id);
        }
    }
}
