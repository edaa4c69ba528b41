//! Lower: a program of words becomes a network of single-bit gates, one plane of lanes for each bit.
//!
//! A memory that is small is made of gates too (multiplexers, and for a RAM one plane of state a bit). A large one is
//! left to a look-up lane by lane: its address is computed in one stage of gates, its word is known in the next.

use std::collections::HashMap;

use super::gates::{Bit, Gates};
use crate::base::{MemoryImage, Op, RamId, RomId, ValueId};
use crate::compile::Program;

/// The bits of a memory up to which gates are the faster way to read it: a look-up lane by lane costs as much as
/// several thousand gates.
const ROM_OF_GATES: usize = 16_384;
/// The same for a RAM, whose every bit is written at every tick when it is made of gates.
const RAM_OF_GATES: usize = 1_024;

/// A program as gates.
#[derive(Debug)]
pub(super) struct Lowered {
    pub(super) gates: Gates,
    /// For each input, the gates that are its bits.
    pub(super) inputs: Vec<Vec<Bit>>,
    /// Bits of state.
    pub(super) states: Vec<State>,
    /// Reads of large memories.
    pub(super) lookups: Vec<Lookup>,
    /// Large RAMs and their write ports.
    pub(super) stores: Vec<Store>,
    /// Bits of every wanted value.
    pub(super) values: HashMap<ValueId, Vec<Bit>>,
}

/// One bit of a register or of a small RAM.
#[derive(Clone, Copy, Debug)]
pub(super) struct State {
    pub(super) now: Bit,
    pub(super) init: bool,
    pub(super) next: Bit,
}

/// A memory that is read lane by lane.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Memory {
    Rom(RomId),
    Ram(RamId),
}

/// A read of a large memory.
#[derive(Clone, Debug)]
pub(super) struct Lookup {
    pub(super) memory: Memory,
    pub(super) address: Vec<Bit>,
    /// Leaves that hold the word read.
    pub(super) word: Vec<Bit>,
}

/// The write port of a large RAM: enable, address, data.
#[derive(Clone, Debug)]
pub(super) struct Store {
    pub(super) ram: RamId,
    pub(super) enable: Bit,
    pub(super) address: Vec<Bit>,
    pub(super) data: Vec<Bit>,
}

/// Gates, and leaves, at most: each takes some 250 bytes until its code is made.
const MOST_GATES: usize = 2 << 20;
/// Bits of all ops at most: four bytes each.
const MOST_BITS: u64 = 64 << 20;

/// Lowers `program`, keeping the bits of the values that are `wanted`. `None` when it is too large for that.
pub(super) fn lower(program: &Program, wanted: &[ValueId]) -> Option<Lowered> {
    if bits(program) > MOST_BITS {
        return None;
    }
    let mut gates = Gates::new();
    let inputs = program.inputs.iter().map(|port| leaves(&mut gates, port.width, 0)).collect();
    let registers = program.graph.registers.iter().map(|r| leaves(&mut gates, r.width, 0)).collect();
    let small = program.graph.rams.iter().map(|ram| {
        let words = ram.image.depth();
        let is_small = words * ram.image.width() as usize <= RAM_OF_GATES;
        is_small.then(|| (0..words).map(|_| leaves(&mut gates, ram.image.width(), 0)).collect())
    });
    let small_rams = small.collect();
    let mut lowering =
        Lowering { program, gates, inputs, registers, small_rams, lookups: Vec::new(), bits: Vec::new() };
    lowering.place_nodes()?;
    lowering.finish(wanted)
}

/// The bits of all values of a program, and of the RAMs that may become gates.
fn bits(program: &Program) -> u64 {
    let nodes = program.graph.nodes.iter().map(|node| u64::from(node.width));
    let rams = program.graph.rams.iter().map(|ram| ram.image.depth().min(RAM_OF_GATES) as u64);
    nodes.chain(rams).sum()
}

fn leaves(gates: &mut Gates, width: u32, stage: u32) -> Vec<Bit> {
    (0..width).map(|_| gates.leaf(stage)).collect()
}

fn constant(word: u64, width: u32) -> Vec<Bit> {
    (0..width).map(|i| Bit::constant(word >> i & 1 == 1)).collect()
}

struct Lowering<'a> {
    program: &'a Program,
    gates: Gates,
    inputs: Vec<Vec<Bit>>,
    registers: Vec<Vec<Bit>>,
    /// For each RAM made of gates, the state bits of its words.
    small_rams: Vec<Option<Vec<Vec<Bit>>>>,
    lookups: Vec<Lookup>,
    /// Bits of every node.
    bits: Vec<Vec<Bit>>,
}

impl Lowering<'_> {
    fn place_nodes(&mut self) -> Option<()> {
        for node in &self.program.graph.nodes {
            let bits = self.node(node.op, node.width);
            debug_assert_eq!(bits.len(), node.width as usize, "{:?}", node.op);
            self.bits.push(bits);
            self.within_limit()?;
        }
        Some(())
    }

    fn within_limit(&self) -> Option<()> {
        (self.gates.len() <= MOST_GATES).then_some(())
    }

    fn node(&mut self, op: Op, width: u32) -> Vec<Bit> {
        let all = &self.bits;
        let word = |id: ValueId| all[id.index()].as_slice();
        let bit = |id: ValueId| all[id.index()][0];
        let gates = &mut self.gates;
        match op {
            Op::Const(value) => constant(value, width),
            Op::Input(i) => self.inputs[i as usize].clone(),
            Op::Register(id) => self.registers[id.index()].clone(),
            Op::Copy(a) => word(a).to_vec(),
            Op::Not(a) => word(a).iter().map(|&bit| !bit).collect(),
            Op::And(a, b) => gates.each(word(a), word(b), Gates::and),
            Op::Or(a, b) => gates.each(word(a), word(b), Gates::or),
            Op::Xor(a, b) => gates.each(word(a), word(b), Gates::xor),
            Op::Add(a, b) => gates.add(word(a), word(b)),
            Op::Sub(a, b) => gates.sub(word(a), word(b)),
            Op::Mul(a, b) => gates.mul(word(a), word(b)),
            Op::Eq(a, b) => vec![gates.equal(word(a), word(b))],
            Op::LtU(a, b) => vec![gates.less(word(a), word(b))],
            Op::LtS(a, b) => vec![gates.less_signed(word(a), word(b))],
            Op::Shl(a, b) => gates.shift_left(word(a), word(b)),
            Op::ShrU(a, b) => gates.shift_right(word(a), word(b), Bit::FALSE),
            Op::ShrS(a, b) => gates.shift_right(word(a), word(b), word(a)[width as usize - 1]),
            Op::Mux(s, a, b) => gates.select(bit(s), word(a), word(b)),
            Op::Slice(a, low) => word(a)[low as usize..(low + width) as usize].to_vec(),
            Op::Concat(high, low) => [word(low), word(high)].concat(),
            Op::ZeroExtend(a) => extended(word(a), width, Bit::FALSE),
            Op::SignExtend(a) => extended(word(a), width, word(a)[word(a).len() - 1]),
            Op::ReduceAnd(a) => vec![gates.all(word(a))],
            Op::ReduceOr(a) => vec![gates.any(word(a))],
            Op::ReduceXor(a) => vec![gates.odd(word(a))],
            Op::RomRead(rom, address) => self.read_rom(rom, address),
            Op::RamRead(ram, address) => self.read_ram(ram, address),
        }
    }

    fn read_rom(&mut self, rom: RomId, address: ValueId) -> Vec<Bit> {
        let image: &MemoryImage = &self.program.graph.roms[rom.index()].image;
        let (depth, width) = (image.depth(), image.width());
        if depth * width as usize > ROM_OF_GATES {
            return self.read_by_lane(Memory::Rom(rom), address, width);
        }
        let table: Vec<_> = image.words().iter().map(|&word| constant(word, width)).collect();
        self.gates.look_up(&table, &self.bits[address.index()], width as usize)
    }

    fn read_ram(&mut self, ram: RamId, address: ValueId) -> Vec<Bit> {
        let width = self.program.graph.rams[ram.index()].image.width();
        match &self.small_rams[ram.index()] {
            Some(words) => self.gates.look_up(words, &self.bits[address.index()], width as usize),
            None => self.read_by_lane(Memory::Ram(ram), address, width),
        }
    }

    fn read_by_lane(&mut self, memory: Memory, address: ValueId, width: u32) -> Vec<Bit> {
        let address = self.bits[address.index()].clone();
        let stage = address.iter().map(|&bit| self.gates.stage(bit)).max().unwrap_or(0) + 1;
        let word = leaves(&mut self.gates, width, stage);
        self.lookups.push(Lookup { memory, address, word: word.clone() });
        word
    }

    fn finish(mut self, wanted: &[ValueId]) -> Option<Lowered> {
        let mut states = self.register_states()?;
        let mut stores = Vec::new();
        for (i, ram) in self.program.graph.rams.iter().enumerate() {
            let word = |id: ValueId| self.bits[id.index()].clone();
            let (address, data) = (word(ram.write.address), word(ram.write.data));
            let enable = self.bits[ram.write.enable.index()][0];
            match self.small_rams[i].take() {
                None => stores.push(Store { ram: RamId::new(i), enable, address, data }),
                Some(words) => {
                    for (at, (now, &init)) in words.iter().zip(ram.image.words()).enumerate() {
                        let here = self.is_address(&address, at);
                        let write = self.gates.and(enable, here);
                        let next = self.gates.select(write, &data, now);
                        states.extend(planes(now, init, &next));
                    }
                    self.within_limit()?;
                }
            }
        }
        let values = wanted.iter().map(|&id| (id, self.bits[id.index()].clone())).collect();
        Some(Lowered { gates: self.gates, inputs: self.inputs, states, lookups: self.lookups, stores, values })
    }

    fn register_states(&mut self) -> Option<Vec<State>> {
        let mut states = Vec::new();
        for (register, now) in self.program.graph.registers.iter().zip(&self.registers) {
            let mut next = self.bits[register.next.index()].clone();
            if let Some(enable) = register.enable {
                next = self.gates.select(self.bits[enable.index()][0], &next, now);
            }
            if let Some(clear) = register.clear {
                let init = constant(register.init, register.width);
                next = self.gates.select(self.bits[clear.index()][0], &init, &next);
            }
            states.extend(planes(now, register.init, &next));
            self.within_limit()?;
        }
        Some(states)
    }

    fn is_address(&mut self, address: &[Bit], at: usize) -> Bit {
        let reachable = address.len() >= usize::BITS as usize || at >> address.len() == 0;
        let wanted = constant(at as u64, address.len() as u32);
        let equal = self.gates.equal(address, &wanted);
        if reachable { equal } else { Bit::FALSE }
    }
}

fn extended(word: &[Bit], width: u32, fill: Bit) -> Vec<Bit> {
    let mut word = word.to_vec();
    word.resize(width as usize, fill);
    word
}

fn planes<'a>(now: &'a [Bit], init: u64, next: &'a [Bit]) -> impl Iterator<Item = State> + 'a {
    now.iter().zip(next).enumerate().map(move |(i, (&now, &next))| State { now, init: init >> i & 1 == 1, next })
}
