//! Ops: the word-level operations that all blocks are made of, and the graph that holds them.
//!
//! A [`Graph`] is a table of nodes; a node's value is one word of 1 to 64 bits. Ops are pure; state lives in
//! [`Register`]s and [`Ram`]s, which change only at the end of a tick:
//!
//! ```text
//! register:  q(t+1) = clear(t) ? init : enable(t) ? next(t) : q(t)
//! ram:       m[address](t+1) = write(t) ? data(t) : m[address](t)
//! ```

use super::memory::MemoryImage;
use super::word::{mask, signed};

crate::define_id!(
    /// A node of a [`Graph`], that is: a value.
    ValueId
);
crate::define_id!(
    /// A register of a [`Graph`].
    RegisterId
);
crate::define_id!(
    /// A read-only memory of a [`Graph`].
    RomId
);
crate::define_id!(
    /// A writable memory of a [`Graph`].
    RamId
);

/// One operation. Unless said otherwise operands and result have the node's width and arithmetic wraps.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Op {
    /// A constant word.
    Const(u64),
    /// Input number so-and-so of the graph.
    Input(u32),
    /// The present content of a register.
    Register(RegisterId),
    /// Another name for a value.
    Copy(ValueId),
    /// Bitwise complement.
    Not(ValueId),
    /// Bitwise and.
    And(ValueId, ValueId),
    /// Bitwise or.
    Or(ValueId, ValueId),
    /// Bitwise exclusive or.
    Xor(ValueId, ValueId),
    /// Sum modulo 2^width.
    Add(ValueId, ValueId),
    /// Difference modulo 2^width.
    Sub(ValueId, ValueId),
    /// Product modulo 2^width.
    Mul(ValueId, ValueId),
    /// 1 when the operands (of any one width) are equal. One bit.
    Eq(ValueId, ValueId),
    /// 1 when the first operand is less, both unsigned. One bit.
    LtU(ValueId, ValueId),
    /// 1 when the first operand is less, both in two's complement. One bit.
    LtS(ValueId, ValueId),
    /// Left shift by the second operand (any width, unsigned); 0 from the width on.
    Shl(ValueId, ValueId),
    /// Logical right shift by the second operand (any width, unsigned); 0 from the width on.
    ShrU(ValueId, ValueId),
    /// Arithmetic right shift by the second operand (any width, unsigned); the sign from the width on.
    ShrS(ValueId, ValueId),
    /// First operand (one bit) 1: the second operand; 0: the third.
    Mux(ValueId, ValueId, ValueId),
    /// The bits `low .. low + width` of a wider or equal word.
    Slice(ValueId, u32),
    /// The first operand above the second; the width is the sum of both.
    Concat(ValueId, ValueId),
    /// Widened with zeros.
    ZeroExtend(ValueId),
    /// Widened with the sign bit.
    SignExtend(ValueId),
    /// 1 when all bits are 1. One bit.
    ReduceAnd(ValueId),
    /// 1 when a bit is 1. One bit.
    ReduceOr(ValueId),
    /// 1 when an odd number of bits is 1. One bit.
    ReduceXor(ValueId),
    /// The word of a ROM at an address; 0 beyond its depth.
    RomRead(RomId, ValueId),
    /// The present word of a RAM at an address; 0 beyond its depth.
    RamRead(RamId, ValueId),
}

impl Op {
    /// Calls `visit` for each operand, in order.
    pub fn operands(&self, mut visit: impl FnMut(ValueId)) {
        let _ = self.map(|id| {
            visit(id);
            id
        });
    }

    /// The same op on other operands.
    #[must_use]
    pub fn map(self, mut f: impl FnMut(ValueId) -> ValueId) -> Self {
        match self {
            Op::Const(_) | Op::Input(_) | Op::Register(_) => self,
            Op::Copy(a) => Op::Copy(f(a)),
            Op::Not(a) => Op::Not(f(a)),
            Op::And(a, b) => Op::And(f(a), f(b)),
            Op::Or(a, b) => Op::Or(f(a), f(b)),
            Op::Xor(a, b) => Op::Xor(f(a), f(b)),
            Op::Add(a, b) => Op::Add(f(a), f(b)),
            Op::Sub(a, b) => Op::Sub(f(a), f(b)),
            Op::Mul(a, b) => Op::Mul(f(a), f(b)),
            Op::Eq(a, b) => Op::Eq(f(a), f(b)),
            Op::LtU(a, b) => Op::LtU(f(a), f(b)),
            Op::LtS(a, b) => Op::LtS(f(a), f(b)),
            Op::Shl(a, b) => Op::Shl(f(a), f(b)),
            Op::ShrU(a, b) => Op::ShrU(f(a), f(b)),
            Op::ShrS(a, b) => Op::ShrS(f(a), f(b)),
            Op::Mux(s, a, b) => Op::Mux(f(s), f(a), f(b)),
            Op::Slice(a, low) => Op::Slice(f(a), low),
            Op::Concat(a, b) => Op::Concat(f(a), f(b)),
            Op::ZeroExtend(a) => Op::ZeroExtend(f(a)),
            Op::SignExtend(a) => Op::SignExtend(f(a)),
            Op::ReduceAnd(a) => Op::ReduceAnd(f(a)),
            Op::ReduceOr(a) => Op::ReduceOr(f(a)),
            Op::ReduceXor(a) => Op::ReduceXor(f(a)),
            Op::RomRead(rom, a) => Op::RomRead(rom, f(a)),
            Op::RamRead(ram, a) => Op::RamRead(ram, f(a)),
        }
    }

    /// Whether the value is known before any op of the tick has run (constant, input, register).
    #[must_use]
    pub fn is_leaf(&self) -> bool {
        matches!(self, Op::Const(_) | Op::Input(_) | Op::Register(_))
    }
}

/// An op and the width of its result in bits.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Node {
    /// What is computed.
    pub op: Op,
    /// Result width, 1 to 64.
    pub width: u32,
}

/// A register: `q(t+1) = clear ? init : enable ? next : q`. Without `enable` it loads at every tick.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Register {
    /// Width in bits.
    pub width: u32,
    /// Content at power-on and after a clear.
    pub init: u64,
    /// Word to load.
    pub next: ValueId,
    /// One bit; loads only when 1.
    pub enable: Option<ValueId>,
    /// One bit; wins over `enable`.
    pub clear: Option<ValueId>,
}

/// A read-only memory.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub struct Rom {
    /// Its words.
    pub image: MemoryImage,
}

/// A write port.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct MemoryWrite {
    /// One bit; writes at the end of the tick when 1.
    pub enable: ValueId,
    /// Word number; a write beyond the depth is lost.
    pub address: ValueId,
    /// Word to write.
    pub data: ValueId,
}

/// A writable memory: combinational reads, one write port.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub struct Ram {
    /// Its words at power-on.
    pub image: MemoryImage,
    /// Its write port.
    pub write: MemoryWrite,
}

/// A table of nodes and the state they read.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Graph {
    /// Values, by [`ValueId`].
    pub nodes: Vec<Node>,
    /// Registers, by [`RegisterId`].
    pub registers: Vec<Register>,
    /// Read-only memories, by [`RomId`].
    pub roms: Vec<Rom>,
    /// Writable memories, by [`RamId`].
    pub rams: Vec<Ram>,
}

impl Graph {
    /// Appends a node.
    pub fn push(&mut self, op: Op, width: u32) -> ValueId {
        self.nodes.push(Node { op, width });
        ValueId::new(self.nodes.len() - 1)
    }

    /// The node of a value.
    #[must_use]
    pub fn node(&self, id: ValueId) -> Node {
        self.nodes[id.index()]
    }

    /// The width of a value in bits.
    #[must_use]
    pub fn width(&self, id: ValueId) -> u32 {
        self.nodes[id.index()].width
    }

    /// Copies `other` into this graph with its inputs connected to `inputs`; returns where its values now are.
    pub fn append(&mut self, other: &Graph, inputs: &[ValueId]) -> impl Fn(ValueId) -> ValueId + Copy + use<> {
        let (nodes, registers) = (self.nodes.len(), self.registers.len());
        let (roms, rams) = (self.roms.len(), self.rams.len());
        let moved = move |id: ValueId| ValueId::new(nodes + id.index());
        self.nodes.extend(other.nodes.iter().map(|node| {
            let op = match node.op.map(moved) {
                Op::Input(i) => Op::Copy(inputs[i as usize]),
                Op::Register(id) => Op::Register(RegisterId::new(registers + id.index())),
                Op::RomRead(id, address) => Op::RomRead(RomId::new(roms + id.index()), address),
                Op::RamRead(id, address) => Op::RamRead(RamId::new(rams + id.index()), address),
                op => op,
            };
            Node { op, width: node.width }
        }));
        self.registers.extend(other.registers.iter().map(|r| Register {
            next: moved(r.next),
            enable: r.enable.map(moved),
            clear: r.clear.map(moved),
            ..*r
        }));
        self.roms.extend(other.roms.iter().cloned());
        self.rams.extend(other.rams.iter().map(|ram| Ram {
            image: ram.image.clone(),
            write: MemoryWrite {
                enable: moved(ram.write.enable),
                address: moved(ram.write.address),
                data: moved(ram.write.data),
            },
        }));
        moved
    }

    /// Every value that state reads at the end of a tick: inputs of registers and of write ports.
    pub fn state_reads(&self) -> impl Iterator<Item = ValueId> + '_ {
        let registers = self.registers.iter().flat_map(|r| [Some(r.next), r.enable, r.clear]).flatten();
        let rams = self.rams.iter().flat_map(|m| [m.write.enable, m.write.address, m.write.data]);
        registers.chain(rams)
    }
}

/// What a pure op yields, the one definition that the interpreter, constant folding and the tests of the fast
/// engines share. `width` is the result's; `operand_width` is that of the *first* operand (of a `Concat`'s second);
/// `a`, `b`, `c` are the operands in order. Leaves and memory reads have no place here and yield `None`.
#[must_use]
pub fn evaluate(op: Op, width: u32, operand_width: u32, [a, b, c]: [u64; 3]) -> Option<u64> {
    let bit = u64::from;
    let value = match op {
        Op::Const(_) | Op::Input(_) | Op::Register(_) | Op::RomRead(..) | Op::RamRead(..) => return None,
        Op::Copy(_) | Op::ZeroExtend(_) => a,
        Op::Not(_) => !a,
        Op::And(..) => a & b,
        Op::Or(..) => a | b,
        Op::Xor(..) => a ^ b,
        Op::Add(..) => a.wrapping_add(b),
        Op::Sub(..) => a.wrapping_sub(b),
        Op::Mul(..) => a.wrapping_mul(b),
        Op::Eq(..) => bit(a == b),
        Op::LtU(..) => bit(a < b),
        Op::LtS(..) => bit(signed(a, operand_width) < signed(b, operand_width)),
        Op::Shl(..) if b >= u64::from(width) => 0,
        Op::Shl(..) => a << b,
        Op::ShrU(..) if b >= u64::from(width) => 0,
        Op::ShrU(..) => a >> b,
        Op::ShrS(..) => (signed(a, width) >> b.min(63)) as u64,
        Op::Mux(..) => {
            if a != 0 {
                b
            } else {
                c
            }
        }
        Op::Slice(_, low) => a >> low,
        Op::Concat(..) => (a << operand_width) | b,
        Op::SignExtend(_) => signed(a, operand_width) as u64,
        Op::ReduceAnd(_) => bit(a == mask(operand_width)),
        Op::ReduceOr(_) => bit(a != 0),
        Op::ReduceXor(_) => bit(a.count_ones() % 2 == 1),
    };
    Some(value & mask(width))
}
