//! Lanes against the interpreter, on every path this machine has.

use std::sync::Arc;

use proptest::prelude::*;

use super::{LanesEngine, Path};
use crate::base::word::mask;
use crate::base::{
    Graph, MemoryImage, MemoryWrite, Op, Port, Ram, RamId, Register, RegisterId, Rom, RomId, Signal, ValueId,
};
use crate::compile::{Owner, OwnerId, Program, compile_graph};
use crate::engine::{Engine, Interpreter};

/// A program that shows every node of `graph`.
pub(in crate::engine) fn program(graph: Graph, stop: Option<ValueId>) -> Program {
    let port =
        |name: String, value: ValueId| Port { name, width: graph.width(value), signed: false, fraction: None, value };
    let inputs = graph.nodes.iter().enumerate().filter(|(_, node)| matches!(node.op, Op::Input(_)));
    let inputs = inputs.map(|(i, _)| port(format!("in{i}"), ValueId::new(i))).collect();
    let last = ValueId::new(graph.nodes.len() - 1);
    let signal = |i: usize| Signal {
        path: vec!["top".into(), format!("n{i}")],
        width: graph.nodes[i].width,
        signed: false,
        fraction: None,
        value: ValueId::new(i),
    };
    compile_graph(Program {
        owner: vec![OwnerId::new(0); graph.nodes.len()],
        owners: vec![Owner { parent: None, module: "top".into() }],
        inputs,
        outputs: vec![port("out".into(), last)],
        pulses: Vec::new(),
        signals: (0..graph.nodes.len()).map(signal).collect(),
        stop,
        graph,
    })
}

/// Makes graphs of all ops out of a string of random numbers.
struct Maker<'a> {
    graph: Graph,
    choices: std::slice::Iter<'a, u64>,
}

impl Maker<'_> {
    fn choice(&mut self) -> u64 {
        self.choices.next().copied().unwrap_or(0)
    }

    fn any(&mut self) -> ValueId {
        let count = self.graph.nodes.len() as u64;
        ValueId::new((self.choice() % count) as usize)
    }

    /// Some value cut or extended to `width`.
    fn word(&mut self, width: u32) -> ValueId {
        let value = self.any();
        self.fitted(value, width)
    }

    fn fitted(&mut self, value: ValueId, width: u32) -> ValueId {
        match self.graph.width(value) {
            same if same == width => value,
            wider if wider > width => self.graph.push(Op::Slice(value, (wider - width) / 2), width),
            _ => self.graph.push(Op::SignExtend(value), width),
        }
    }

    fn op(&mut self) {
        let width = 1 + (self.choice() % 64) as u32;
        let (a, b) = (self.word(width), self.word(width));
        let kind = self.choice() % 27;
        let (op, width) = match kind {
            0 => (Op::Const(self.choice() & mask(width)), width),
            1 => (Op::Not(a), width),
            2 => (Op::And(a, b), width),
            3 => (Op::Or(a, b), width),
            4 => (Op::Xor(a, b), width),
            5 => (Op::Add(a, b), width),
            6 => (Op::Sub(a, b), width),
            7 => (Op::Mul(a, b), width),
            8 => (Op::Eq(a, b), 1),
            9 => (Op::LtU(a, b), 1),
            10 => (Op::LtS(a, b), 1),
            11..=13 => {
                let amount_width = 1 + (self.choice() % 9) as u32;
                let amount = self.word(amount_width);
                ([Op::Shl(a, amount), Op::ShrU(a, amount), Op::ShrS(a, amount)][kind as usize - 11], width)
            }
            14 => (Op::Mux(self.word(1), a, b), width),
            15 => {
                let low = (self.choice() % u64::from(width)) as u32;
                (Op::Slice(a, low), width - low)
            }
            16 if width > 32 => (Op::Copy(a), width),
            16 => (Op::Concat(a, b), 2 * width),
            17 => (Op::ZeroExtend(a), 64),
            18 => (Op::SignExtend(a), 64),
            19 => (Op::ReduceAnd(a), 1),
            20 => (Op::ReduceOr(a), 1),
            21 => (Op::ReduceXor(a), 1),
            22 | 23 => self.rom(width, kind == 22),
            24 | 25 => self.ram(width, kind == 24),
            _ => self.register(width),
        };
        self.graph.push(op, width);
    }

    fn image(&mut self, width: u32, depth: u64) -> MemoryImage {
        let seed = self.choice() | 1;
        MemoryImage::from_words(width, (1..=depth).map(|i| (seed.wrapping_mul(i) ^ seed >> 17) & mask(width)))
    }

    /// A large memory is read lane by lane, a small one is made of gates.
    fn rom(&mut self, width: u32, large: bool) -> (Op, u32) {
        let depth = if large { 16_400 } else { 1 + self.choice() % 20 };
        let image = self.image(width, depth);
        self.graph.roms.push(Rom { image });
        let address_width = if large { 15 } else { 5 };
        (Op::RomRead(RomId::new(self.graph.roms.len() - 1), self.word(address_width)), width)
    }

    fn ram(&mut self, width: u32, large: bool) -> (Op, u32) {
        let depth = if large { 1_030 } else { 1 + self.choice() % 10 };
        let image = self.image(width, depth);
        let address_width = if large { 11 } else { 4 };
        let write = MemoryWrite { enable: self.word(1), address: self.word(address_width), data: self.word(width) };
        self.graph.rams.push(Ram { image, write });
        (Op::RamRead(RamId::new(self.graph.rams.len() - 1), self.word(address_width)), width)
    }

    fn register(&mut self, width: u32) -> (Op, u32) {
        let choice = self.choice();
        let (next, init) = (self.word(width), self.choice() & mask(width));
        let enable = (choice & 1 == 1).then(|| self.word(1));
        let clear = (choice & 6 == 2).then(|| self.word(1));
        self.graph.registers.push(Register { width, init, next, enable, clear });
        (Op::Register(RegisterId::new(self.graph.registers.len() - 1)), width)
    }
}

/// A graph made of `choices`: three inputs, then ops.
pub(in crate::engine) fn graph(choices: &[u64], ops: usize) -> Graph {
    let mut maker = Maker { graph: Graph::default(), choices: choices.iter() };
    for (i, width) in [64, 17, 1].into_iter().enumerate() {
        maker.graph.push(Op::Input(i as u32), width);
    }
    (0..ops).for_each(|_| maker.op());
    maker.graph
}

/// Runs both engines side by side and compares every observed value at every tick.
fn agree(program: &Program, path: Path, stimulus: &[[u64; 3]]) -> Result<(), TestCaseError> {
    let mut plain = Interpreter::new(Arc::new(program.clone()));
    let mut lanes = LanesEngine::on(program, path).expect("lanes");
    for (tick, words) in stimulus.iter().enumerate() {
        for (input, port) in program.inputs.iter().enumerate() {
            plain.set_input(input, words[input] & mask(port.width));
            lanes.set_input(input, words[input] & mask(port.width));
        }
        plain.settle();
        lanes.settle();
        for id in program.observed() {
            let node = program.graph.node(id);
            prop_assert_eq!(lanes.value(id), plain.value(id), "tick {} of {:?} on {:?}", tick, node, path);
        }
        plain.advance(1, false);
        lanes.advance(1, false);
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn every_op_at_every_width_agrees_with_the_interpreter(
        choices in proptest::collection::vec(any::<u64>(), 400),
        ops in 1usize..40,
        stimulus in proptest::collection::vec(any::<[u64; 3]>(), 6),
    ) {
        let program = program(graph(&choices, ops), None);
        for path in Path::all() {
            agree(&program, path, &stimulus)?;
        }
    }

    #[test]
    fn a_long_advance_equals_many_short_ones_and_stops_where_the_interpreter_does(
        choices in proptest::collection::vec(any::<u64>(), 400),
        ticks in 1u64..300,
        words in any::<[u64; 3]>(),
    ) {
        let mut made = graph(&choices, 30);
        let last = ValueId::new(made.nodes.len() - 1);
        let stop = made.push(Op::ReduceAnd(last), 1);
        let program = program(made, Some(stop));
        for path in Path::all() {
            let mut plain = Interpreter::new(Arc::new(program.clone()));
            let mut lanes = LanesEngine::on(&program, path).expect("lanes");
            for (input, port) in program.inputs.iter().enumerate() {
                plain.set_input(input, words[input] & mask(port.width));
                lanes.set_input(input, words[input] & mask(port.width));
            }
            for until_stop in [true, false, true] {
                prop_assert_eq!(lanes.advance(ticks, until_stop), plain.advance(ticks, until_stop));
                for id in program.observed() {
                    prop_assert_eq!(lanes.value(id), plain.value(id), "{:?}", path);
                }
            }
        }
    }
}

/// `count` RAMs of 4096 bytes, which share their image.
pub(in crate::engine) fn many_rams(count: usize) -> Program {
    let mut graph = Graph::default();
    let image = MemoryImage::from_words(8, (0..4096).map(|i| i & 255));
    let address = graph.push(Op::Input(0), 12);
    let enable = graph.push(Op::Const(0), 1);
    let data = graph.push(Op::Const(0), 8);
    for i in 0..count {
        graph.rams.push(Ram { image: image.clone(), write: MemoryWrite { enable, address, data } });
        graph.push(Op::RamRead(RamId::new(i), address), 8);
    }
    program(graph, None)
}

/// `count` multiplications of 64 bits, each by the last one's result.
fn many_multipliers(count: usize) -> Program {
    let mut graph = Graph::default();
    let factor = graph.push(Op::Input(0), 64);
    (0..count).fold(factor, |last, _| graph.push(Op::Mul(last, factor), 64));
    program(graph, None)
}

#[test]
fn what_is_too_large_for_lanes_is_refused_before_its_memory_is_taken() {
    for path in Path::all() {
        assert!(LanesEngine::on(&many_rams(2), path).is_ok(), "{path:?}");
        let refused = LanesEngine::on(&many_rams(2000), path).expect_err("4 GiB and more");
        assert_eq!(refused.code, "E005");
        assert!(refused.message.contains("MiB for its lanes"), "{}", refused.message);
    }
    let refused = LanesEngine::new(&many_multipliers(500)).expect_err("3,000,000 gates");
    assert!(refused.message.contains("more gates than it takes"), "{}", refused.message);
}
