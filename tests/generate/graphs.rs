//! Random graphs of ops: all ops, widths 1 to 64, registers with every kind of control, memories.
//!
//! A graph is grown from a [`Recipe`], which is plain data that shrinks: every choice in it is a number that is
//! taken modulo what there is to choose from, so any part may be left out.

use proptest::prelude::*;
use stepwright::base::word::mask;
use stepwright::base::{
    Graph, MemoryImage, MemoryWrite, Op, Port, Ram, RamId, Register, RegisterId, Rom, RomId, Signal, ValueId,
};
use stepwright::compile::{Owner, OwnerId, Program};

/// What to grow.
#[derive(Clone, Debug)]
pub struct Recipe {
    /// Widths of the inputs.
    pub inputs: Vec<u32>,
    /// Registers.
    pub registers: Vec<State>,
    /// Ops.
    pub steps: Vec<Step>,
    /// Every so many values, one is observed; 1 is all of them.
    pub observe_every: usize,
    /// Which value stops the run.
    pub stop: u16,
}

/// A register to grow.
#[derive(Clone, Debug)]
pub struct State {
    /// Its width.
    pub width: u32,
    /// Its content at power-on, to be cut.
    pub init: u64,
    /// Which value it loads.
    pub next: u16,
    /// Which value enables it, if any.
    pub enable: Option<u16>,
    /// Which value clears it, if any.
    pub clear: Option<u16>,
}

/// An op to grow.
#[derive(Clone, Debug)]
pub struct Step {
    /// Which op.
    pub kind: u8,
    /// Its width, as far as it is free.
    pub width: u32,
    /// Which values it takes.
    pub operands: [u16; 3],
    /// A constant, a place, the seed of a memory's words.
    pub word: u64,
}

/// Recipes of up to so many ops.
pub fn recipes(ops: usize) -> impl Strategy<Value = Recipe> {
    recipes_of(1..ops)
}

/// Recipes of so many ops.
pub fn recipes_of(ops: std::ops::Range<usize>) -> impl Strategy<Value = Recipe> {
    let inputs = prop::collection::vec(widths(), 0..4);
    let registers = prop::collection::vec(states(), 0..6);
    let steps = prop::collection::vec(steps(), ops);
    (inputs, registers, steps, 1..9_usize, any::<u16>()).prop_map(|(inputs, registers, steps, observe_every, stop)| {
        Recipe { inputs, registers, steps, observe_every, stop }
    })
}

fn widths() -> impl Strategy<Value = u32> {
    prop_oneof![4 => Just(1), 3 => 2..=16_u32, 2 => 1..=64_u32, 2 => prop::sample::select(vec![8, 31, 32, 33, 63, 64])]
}

fn words() -> impl Strategy<Value = u64> {
    prop_oneof![Just(0), Just(u64::MAX), 0..70_u64, any::<u64>()]
}

fn states() -> impl Strategy<Value = State> {
    let control = || prop::option::of(any::<u16>());
    (widths(), words(), any::<u16>(), control(), control()).prop_map(|(width, init, next, enable, clear)| State {
        width,
        init,
        next,
        enable,
        clear,
    })
}

fn steps() -> impl Strategy<Value = Step> {
    (any::<u8>(), widths(), any::<[u16; 3]>(), words()).prop_map(|(kind, width, operands, word)| Step {
        kind,
        width,
        operands,
        word,
    })
}

/// The program of a recipe, as it is before compilation: its ops stand after their operands.
pub fn grow(recipe: &Recipe) -> Program {
    let mut grower = Grower::default();
    for (i, &width) in recipe.inputs.iter().enumerate() {
        grower.graph.push(Op::Input(i as u32), width);
    }
    for (i, state) in recipe.registers.iter().enumerate() {
        grower.graph.push(Op::Register(RegisterId::new(i)), state.width);
    }
    grower.graph.push(Op::Const(1), 1);
    for step in &recipe.steps {
        grower.step(step);
    }
    for state in &recipe.registers {
        grower.finish_register(state);
    }
    grower.finish_rams();
    let stop = grower.pick(recipe.stop, 1);
    grower.into_program(recipe, stop)
}

#[derive(Default)]
struct Grower {
    graph: Graph,
    writes: Vec<[u16; 3]>,
}

impl Grower {
    /// A value of `width` bits: an old one, cut or widened where it does not fit.
    fn pick(&mut self, choice: u16, width: u32) -> ValueId {
        let id = ValueId::new(usize::from(choice) % self.graph.nodes.len());
        let old = self.graph.width(id);
        match old.cmp(&width) {
            std::cmp::Ordering::Equal => id,
            std::cmp::Ordering::Greater => {
                self.graph.push(Op::Slice(id, u32::from(choice >> 8) % (old - width + 1)), width)
            }
            std::cmp::Ordering::Less if choice & 0x100 == 0 => self.graph.push(Op::ZeroExtend(id), width),
            std::cmp::Ordering::Less => self.graph.push(Op::SignExtend(id), width),
        }
    }

    fn step(&mut self, step: &Step) {
        let Step { kind, width, operands: [x, y, z], word } = *step;
        let (op, width) = match kind % 27 {
            0 => (Op::Const(word & mask(width)), width),
            1 => (Op::Copy(self.pick(x, width)), width),
            2 => (Op::Not(self.pick(x, width)), width),
            kind @ 3..=8 => {
                let (a, b) = (self.pick(x, width), self.pick(y, width));
                let ops = [Op::And(a, b), Op::Or(a, b), Op::Xor(a, b), Op::Add(a, b), Op::Sub(a, b), Op::Mul(a, b)];
                (ops[usize::from(kind) - 3], width)
            }
            kind @ 9..=11 => {
                let (a, b) = (self.pick(x, width), self.pick(y, width));
                ([Op::Eq(a, b), Op::LtU(a, b), Op::LtS(a, b)][usize::from(kind) - 9], 1)
            }
            kind @ 12..=14 => {
                let amount = if word & 1 == 0 { 1 + (word >> 1) as u32 % 8 } else { 1 + (word >> 1) as u32 % 64 };
                let (a, n) = (self.pick(x, width), self.pick(y, amount));
                ([Op::Shl(a, n), Op::ShrU(a, n), Op::ShrS(a, n)][usize::from(kind) - 12], width)
            }
            15 | 16 => (Op::Mux(self.pick(x, 1), self.pick(y, width), self.pick(z, width)), width),
            17 => {
                let whole = width + (word % u64::from(65 - width)) as u32;
                (Op::Slice(self.pick(x, whole), (word >> 8) as u32 % (whole - width + 1)), width)
            }
            18 | 19 => {
                let width = width.max(2);
                let low = 1 + (word % u64::from(width - 1)) as u32;
                (Op::Concat(self.pick(x, width - low), self.pick(y, low)), width)
            }
            kind @ (20 | 21) => {
                let a = self.pick(x, 1 + (word % u64::from(width)) as u32);
                (if kind == 20 { Op::ZeroExtend(a) } else { Op::SignExtend(a) }, width)
            }
            kind @ 22..=24 => {
                let a = self.pick(x, width);
                ([Op::ReduceAnd(a), Op::ReduceOr(a), Op::ReduceXor(a)][usize::from(kind) - 22], 1)
            }
            25 => {
                self.graph.roms.push(Rom { image: image(width, word) });
                (Op::RomRead(RomId::new(self.graph.roms.len() - 1), self.address(x, word)), width)
            }
            _ => {
                let nothing = ValueId::new(0);
                let write = MemoryWrite { enable: nothing, address: nothing, data: nothing };
                self.graph.rams.push(Ram { image: image(width, word), write });
                self.writes.push([x, y, z]);
                (Op::RamRead(RamId::new(self.graph.rams.len() - 1), self.address(x, word)), width)
            }
        };
        self.graph.push(op, width);
    }

    /// An address that is often within a small memory, and may be as wide as words are.
    fn address(&mut self, choice: u16, word: u64) -> ValueId {
        let widths = [1, 2, 3, 4, 5, 8, 40, 64];
        self.pick(choice, widths[(word >> 3) as usize % widths.len()])
    }

    fn control(&mut self, choice: Option<u16>) -> Option<ValueId> {
        choice.map(|choice| self.pick(choice, 1))
    }

    fn finish_register(&mut self, state: &State) {
        let next = self.pick(state.next, state.width);
        let (enable, clear) = (self.control(state.enable), self.control(state.clear));
        let init = state.init & mask(state.width);
        self.graph.registers.push(Register { width: state.width, init, next, enable, clear });
    }

    fn finish_rams(&mut self) {
        for (i, [x, y, z]) in std::mem::take(&mut self.writes).into_iter().enumerate() {
            let width = self.graph.rams[i].image.width();
            let enable = self.pick(z, 1);
            let address = self.address(y, u64::from(x));
            let data = self.pick(x, width);
            self.graph.rams[i].write = MemoryWrite { enable, address, data };
        }
    }

    fn into_program(self, recipe: &Recipe, stop: ValueId) -> Program {
        let graph = self.graph;
        let port = |(i, &width): (usize, &u32)| Port {
            name: format!("in{i}"),
            width,
            signed: false,
            fraction: None,
            value: ValueId::new(i),
        };
        let signal = |i: usize| Signal {
            path: vec!["top".into(), format!("v{i}")],
            width: graph.nodes[i].width,
            signed: false,
            fraction: None,
            value: ValueId::new(i),
        };
        Program {
            owner: vec![OwnerId::new(0); graph.nodes.len()],
            owners: vec![Owner { parent: None, module: "top".into() }],
            inputs: recipe.inputs.iter().enumerate().map(port).collect(),
            outputs: Vec::new(),
            pulses: Vec::new(),
            signals: (0..graph.nodes.len()).rev().step_by(recipe.observe_every).map(signal).collect(),
            stop: Some(stop),
            graph,
        }
    }
}

/// Some words from a seed.
fn image(width: u32, seed: u64) -> MemoryImage {
    let depth = 1 + seed % 19;
    let words = (0..depth).map(|i| (seed ^ i).wrapping_mul(0x9E37_79B9_7F4A_7C15).rotate_left(i as u32));
    MemoryImage::from_words(width, words.map(|word| word & mask(width)))
}
