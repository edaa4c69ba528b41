//! Probe: counters for the pulses of one-bit outputs, made of ops, so that every engine counts them for nothing.

use super::{Observe, OwnerId, Program};
use crate::base::{Op, Register, RegisterId};

/// Adds the counters when they are wanted.
pub(super) fn probe(mut program: Program, observe: &Observe<'_>) -> Program {
    if observe.pulses {
        let one_bit = program.outputs.iter().enumerate().filter(|(_, port)| port.width == 1);
        program.pulses = one_bit.map(|(i, port)| (i, port.value)).collect();
        for i in 0..program.pulses.len() {
            let pulse = program.pulses[i].1;
            let graph = &mut program.graph;
            let count = graph.push(Op::Register(RegisterId::new(graph.registers.len())), 64);
            let step = graph.push(Op::ZeroExtend(pulse), 64);
            let next = graph.push(Op::Add(count, step), 64);
            graph.registers.push(Register { width: 64, init: 0, next, enable: None, clear: None });
            program.owner.resize(graph.nodes.len(), OwnerId::new(0));
            program.pulses[i].1 = next;
        }
    }
    program
}
