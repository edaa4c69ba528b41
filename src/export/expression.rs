//! Expressions: one op as Verilog.
//!
//! Every operand is a sized literal or the name of a wire that has just the operand's width, so that Verilog's rules
//! for extending operands never apply.

use crate::base::graph::evaluate;
use crate::base::word::{clog2, mask};
use crate::base::{Graph, MemoryImage, Node, Op, RamId, RegisterId, RomId, ValueId};

/// The name inside a body of an input port's word.
///
/// Names made here start with an underscore, which no block gives to its own signals: so none can hide another.
pub(super) fn input_name(input: usize) -> String {
    format!("_in{input}")
}

/// The name of a register.
pub(super) fn register_name(id: RegisterId) -> String {
    format!("_state{}", id.index())
}

/// The name of a read-only memory.
pub(super) fn rom_name(id: RomId) -> String {
    format!("_rom{}", id.index())
}

/// The name of a writable memory.
pub(super) fn ram_name(id: RamId) -> String {
    format!("_ram{}", id.index())
}

/// A sized constant.
pub(super) fn literal(value: u64, width: u32) -> String {
    format!("{width}'d{}", value & mask(width))
}

/// The range of a declaration, with a space after it; nothing for one bit.
pub(super) fn range(width: u32) -> String {
    if width == 1 { String::new() } else { format!("[{}:0] ", width - 1) }
}

/// Writes the ops of one graph.
#[derive(Clone, Copy)]
pub(super) struct Expressions<'a> {
    /// The ops.
    pub(super) graph: &'a Graph,
}

impl Expressions<'_> {
    /// What stands for a value wherever it is read.
    pub(super) fn name(self, id: ValueId) -> String {
        let node = self.graph.node(id);
        match node.op {
            Op::Copy(a) => self.name(a),
            op if op.is_leaf() => self.expression(node),
            _ => format!("_op{}", id.index()),
        }
    }

    /// An op on the names of its operands.
    pub(super) fn expression(self, Node { op, width }: Node) -> String {
        let name = |id| self.name(id);
        match op {
            Op::Const(value) => literal(value, width),
            Op::Input(i) => input_name(i as usize),
            Op::Register(id) => register_name(id),
            Op::Copy(a) => name(a),
            Op::Not(a) => format!("~{}", name(a)),
            Op::And(a, b) => format!("{} & {}", name(a), name(b)),
            Op::Or(a, b) => format!("{} | {}", name(a), name(b)),
            Op::Xor(a, b) => format!("{} ^ {}", name(a), name(b)),
            Op::Add(a, b) => format!("{} + {}", name(a), name(b)),
            Op::Sub(a, b) => format!("{} - {}", name(a), name(b)),
            Op::Mul(a, b) => format!("{} * {}", name(a), name(b)),
            Op::Eq(a, b) => format!("{} == {}", name(a), name(b)),
            Op::LtU(a, b) => format!("{} < {}", name(a), name(b)),
            Op::LtS(a, b) => format!("$signed({}) < $signed({})", name(a), name(b)),
            Op::Shl(a, b) => format!("{} << {}", name(a), name(b)),
            Op::ShrU(a, b) => format!("{} >> {}", name(a), name(b)),
            Op::ShrS(a, b) => format!("$signed({}) >>> {}", name(a), name(b)),
            Op::Mux(s, a, b) => format!("{} ? {} : {}", name(s), name(a), name(b)),
            Op::Slice(a, low) => self.bits(a, low, width),
            Op::Concat(a, b) => format!("{{{}, {}}}", name(a), name(b)),
            Op::ZeroExtend(a) => self.fitted(a, width),
            Op::SignExtend(a) => self.sign_extended(a, width),
            Op::ReduceAnd(a) => format!("&{}", name(a)),
            Op::ReduceOr(a) => format!("|{}", name(a)),
            Op::ReduceXor(a) => format!("^{}", name(a)),
            Op::RomRead(id, address) => {
                self.memory_read(&rom_name(id), &self.graph.roms[id.index()].image, address, width)
            }
            Op::RamRead(id, address) => {
                self.memory_read(&ram_name(id), &self.graph.rams[id.index()].image, address, width)
            }
        }
    }

    /// Whether an address lies within a memory; `None` when it always does.
    pub(super) fn within(self, image: &MemoryImage, address: ValueId) -> Option<String> {
        let (depth, width) = (image.depth() as u64, self.graph.width(address));
        let beyond = depth <= mask(width);
        beyond.then(|| format!("{} < {}", self.name(address), literal(depth, width)))
    }

    /// An address cut or widened to just the bits that number the words of a memory.
    pub(super) fn index(self, image: &MemoryImage, address: ValueId) -> String {
        self.fitted(address, clog2(image.depth() as u64).max(1))
    }

    fn memory_read(self, memory: &str, image: &MemoryImage, address: ValueId, width: u32) -> String {
        let word = format!("{memory}[{}]", self.index(image, address));
        if let Some(at) = self.constant(address) {
            return if at < image.depth() as u64 { word } else { literal(0, width) };
        }
        match self.within(image, address) {
            Some(within) => format!("{within} ? {word} : {}", literal(0, width)),
            None => word,
        }
    }

    /// The low bits of a value, with zeros above when it has too few.
    fn fitted(self, a: ValueId, width: u32) -> String {
        let own = self.graph.width(a);
        match self.constant(a) {
            Some(value) => literal(value, width),
            None if own < width => format!("{{{}, {}}}", literal(0, width - own), self.name(a)),
            None => self.bits(a, 0, width),
        }
    }

    /// Some bits of a value. Verilog selects bits of names only, and not of a one-bit name.
    fn bits(self, a: ValueId, low: u32, width: u32) -> String {
        match self.constant(a) {
            Some(value) => literal(value >> low, width),
            None if self.graph.width(a) == width => self.name(a),
            None if width == 1 => format!("{}[{low}]", self.name(a)),
            None => format!("{}[{}:{low}]", self.name(a), low + width - 1),
        }
    }

    fn sign_extended(self, a: ValueId, width: u32) -> String {
        let own = self.graph.width(a);
        let extended = self.constant(a).and_then(|value| evaluate(Op::SignExtend(a), width, own, [value, 0, 0]));
        match extended {
            Some(value) => literal(value, width),
            None if own == width => self.name(a),
            None => format!("{{{{{}{{{}}}}}, {}}}", width - own, self.bits(a, own - 1, 1), self.name(a)),
        }
    }

    fn constant(self, id: ValueId) -> Option<u64> {
        match self.graph.node(id).op {
            Op::Const(value) => Some(value),
            Op::Copy(a) => self.constant(a),
            _ => None,
        }
    }
}
