//! The program: what every engine runs.

use std::sync::Arc;

use crate::base::{Graph, Port, Signal, ValueId};

crate::define_id!(
    /// A module instance, as far as sharing of code cares.
    OwnerId
);

/// A module instance. Two owners of equal `module` were built from the same text, perhaps with other parameters.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub struct Owner {
    /// Enclosing instance; `None` for the top.
    pub parent: Option<OwnerId>,
    /// Module name.
    pub module: Arc<str>,
}

/// A circuit made of ops in an order in which each op follows its operands, registers and inputs being leaves.
///
/// There is no [`crate::base::Op::Copy`] in it, and no op that nobody needs.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Program {
    /// Ops and state.
    pub graph: Graph,
    /// Module instance each node belongs to.
    pub owner: Vec<OwnerId>,
    /// Module instances; the first is the top, a parent comes before its children.
    pub owners: Vec<Owner>,
    /// Inputs; `Op::Input(i)` is `inputs[i]`.
    pub inputs: Vec<Port>,
    /// Outputs.
    pub outputs: Vec<Port>,
    /// The one-bit outputs whose pulses an engine counts: places in `outputs`.
    pub pulses: Vec<usize>,
    /// Signals that can be traced.
    pub signals: Vec<Signal>,
    /// One bit that is 1 when the run is to stop.
    pub stop: Option<ValueId>,
}

impl Program {
    /// Every value that must be readable after a tick, in increasing order, each once.
    #[must_use]
    pub fn observed(&self) -> Vec<ValueId> {
        let ports = self.inputs.iter().chain(&self.outputs).map(|port| port.value);
        let signals = self.signals.iter().map(|signal| signal.value);
        let mut all: Vec<_> = ports.chain(signals).chain(self.stop).collect();
        all.sort_unstable();
        all.dedup();
        all
    }

    /// The values of the outputs whose pulses are counted, in order.
    pub fn counted(&self) -> impl Iterator<Item = ValueId> + '_ {
        self.pulses.iter().map(|&output| self.outputs[output].value)
    }

    /// Applies `f` to every value that is kept because it is observable.
    pub(super) fn map_observed(&mut self, f: impl Fn(ValueId) -> ValueId) {
        let ports = self.inputs.iter_mut().chain(&mut self.outputs).map(|port| &mut port.value);
        let signals = self.signals.iter_mut().map(|signal| &mut signal.value);
        ports.chain(signals).chain(&mut self.stop).for_each(|value| *value = f(*value));
    }
}
