//! Pulse counters as ops: the code generator keeps them in registers of the machine, which is cheaper than to come
//! back from its code at every tick.

use crate::base::{Graph, Op, Register, RegisterId, ValueId};
use crate::compile::{OwnerId, Program};
use crate::engine::Pulses;

/// Where the counts of one output are, the present tick included.
#[derive(Clone, Copy, Debug)]
pub(super) struct Counter {
    rising: ValueId,
    high: ValueId,
}

impl Counter {
    /// The values that hold the counts.
    pub fn values(self) -> [ValueId; 2] {
        [self.rising, self.high]
    }

    /// The counts.
    pub fn read(self, word: impl Fn(ValueId) -> u64) -> Pulses {
        Pulses { rising: word(self.rising), high: word(self.high) }
    }
}

/// The program with a counter for each output whose pulses are counted. All values keep their numbers.
pub(super) fn with_counters(program: &Program) -> (Program, Vec<Counter>) {
    let mut program = program.clone();
    let bits: Vec<_> = program.counted().collect();
    let graph = &mut program.graph;
    let counters = bits
        .into_iter()
        .map(|bit| {
            let before = register(graph, 1, |_, _| bit);
            let was_low = graph.push(Op::Not(before), 1);
            let rises = graph.push(Op::And(bit, was_low), 1);
            Counter { rising: count(graph, rises), high: count(graph, bit) }
        })
        .collect();
    program.owner.resize(program.graph.nodes.len(), OwnerId::new(0));
    (program, counters)
}

/// How many ticks `bit` has been 1, this one included.
fn count(graph: &mut Graph, bit: ValueId) -> ValueId {
    let mut sum = bit;
    register(graph, 64, |graph, so_far| {
        let step = graph.push(Op::ZeroExtend(bit), 64);
        sum = graph.push(Op::Add(so_far, step), 64);
        sum
    });
    sum
}

/// A register that is 0 at power-on; `next` makes what it loads at every tick out of its content.
fn register(graph: &mut Graph, width: u32, next: impl FnOnce(&mut Graph, ValueId) -> ValueId) -> ValueId {
    let id = RegisterId::new(graph.registers.len());
    let content = graph.push(Op::Register(id), width);
    let next = next(graph, content);
    graph.registers.push(Register { width, init: 0, next, enable: None, clear: None });
    content
}
