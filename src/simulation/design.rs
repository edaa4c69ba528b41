//! A design: a circuit that has been elaborated, with its stimulus resolved against it.

use std::path::PathBuf;
use std::sync::Arc;

use super::stimulus::Resolved;
use super::{Circuit, EngineKind};
use crate::base::{Signal, Stimulus};
use crate::compile::{self, Observe, Program, Until, compile};
use crate::netlist::{Net, NetId, Netlist};
use crate::scenario::{Requirement, Scenario};

/// A checked netlist and what shall be done with it. It may be run any number of times.
#[derive(Debug)]
pub struct Design {
    circuit: Circuit,
    scenario: Scenario,
    netlist: Netlist,
    stimulus: Stimulus,
    until: Option<Until>,
    required: Vec<Requirement<usize>>,
    engine: EngineKind,
    files: Vec<PathBuf>,
}

impl Design {
    pub(super) fn new(
        circuit: Circuit,
        scenario: Scenario,
        netlist: Netlist,
        resolved: Resolved,
        engine: EngineKind,
        files: Vec<PathBuf>,
    ) -> Self {
        let Resolved { stimulus, until, required } = resolved;
        Self { circuit, scenario, netlist, stimulus, until, required, engine, files }
    }

    /// The files on disk that it was read from: the circuit, its modules, the scenario.
    #[must_use]
    pub fn files(&self) -> &[PathBuf] {
        &self.files
    }

    /// The circuit.
    #[must_use]
    pub fn circuit(&self) -> &Circuit {
        &self.circuit
    }

    /// The scenario, with what was changed since.
    #[must_use]
    pub fn scenario(&self) -> &Scenario {
        &self.scenario
    }

    /// The checked netlist.
    #[must_use]
    pub fn netlist(&self) -> &Netlist {
        &self.netlist
    }

    /// What is done to the inputs, and when a run is over.
    #[must_use]
    pub fn stimulus(&self) -> &Stimulus {
        &self.stimulus
    }

    /// The engine that was chosen.
    #[must_use]
    pub fn engine(&self) -> EngineKind {
        self.engine
    }

    /// The inputs, in the order of the circuit's header.
    pub fn inputs(&self) -> impl Iterator<Item = &Net> {
        self.nets(&self.netlist.inputs)
    }

    /// The outputs, in the order of the circuit's header.
    pub fn outputs(&self) -> impl Iterator<Item = &Net> {
        self.nets(&self.netlist.outputs)
    }

    /// The same design with another stimulus, in words. What it waits for stays; a [`crate::base::StopRule::Until`] needs
    /// a scenario that waits.
    ///
    /// # Panics
    /// When it has not just one word for each input.
    #[must_use]
    pub fn with_stimulus(self, stimulus: Stimulus) -> Self {
        assert_eq!(stimulus.initial.len(), self.netlist.inputs.len(), "a word for each input");
        Self { stimulus, ..self }
    }

    /// The net to wait for, if any.
    #[must_use]
    pub fn until(&self) -> Option<Until> {
        self.until
    }

    /// What the inputs have to satisfy, by their places: the scenario's requirements, in order.
    pub(super) fn required(&self) -> &[Requirement<usize>] {
        &self.required
    }

    fn nets<'a>(&'a self, ids: &'a [NetId]) -> impl Iterator<Item = &'a Net> {
        ids.iter().map(|id| &self.netlist.nets[id.index()])
    }

    pub(super) fn compile(&self, wanted: &dyn Fn(&str) -> bool) -> Arc<Program> {
        let expected = |name: &str| self.scenario.expect.outputs.iter().any(|net| net.name == name);
        let signals = |name: &str| wanted(name) || expected(name);
        Arc::new(compile(&self.netlist, &Observe { signals: &signals, until: self.until, pulses: true }))
    }

    /// Every signal there is.
    pub(super) fn all_signals(&self) -> Vec<Signal> {
        compile::signals(&self.netlist)
    }
}
