//! What each op becomes in generated code.

use std::collections::HashMap;

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::{I8, I64};
use cranelift_codegen::ir::{InstBuilder, MemFlagsData, Type, Value};
use cranelift_frontend::FunctionBuilder;

use super::word::{Word, constant, cut, machine_type, resize};
use crate::base::word::mask;
use crate::base::{Graph, MemoryImage, MemoryWrite, Op, RamId, Register, RomId, ValueId};

/// Where the code of one function finds what it does not compute.
pub(super) trait Outside {
    /// The word of a register, an input, or an op that other code has computed: clean, of the width's machine type.
    fn fetch(&mut self, b: &mut FunctionBuilder<'_>, id: ValueId, width: u32) -> Value;
    /// Address of word 0 of a ROM, and its depth.
    fn rom(&mut self, b: &mut FunctionBuilder<'_>, id: RomId) -> (Value, usize);
    /// Address of word 0 of a RAM, and its depth.
    fn ram(&mut self, b: &mut FunctionBuilder<'_>, id: RamId) -> (Value, usize);
}

/// Turns ops into code, one straight line of it.
pub(super) struct Emitter<'a, 'f, O> {
    pub b: &'a mut FunctionBuilder<'f>,
    pub outside: O,
    graph: &'a Graph,
    words: HashMap<ValueId, Word>,
}

impl<'a, 'f, O: Outside> Emitter<'a, 'f, O> {
    pub fn new(b: &'a mut FunctionBuilder<'f>, graph: &'a Graph, outside: O) -> Self {
        Self::with(b, graph, outside, HashMap::new())
    }

    /// Goes on where another one has computed these words.
    pub fn with(b: &'a mut FunctionBuilder<'f>, graph: &'a Graph, outside: O, words: HashMap<ValueId, Word>) -> Self {
        Self { b, outside, graph, words }
    }

    /// Whether a value has its word.
    pub fn has(&self, id: ValueId) -> bool {
        self.words.contains_key(&id)
    }

    /// The words computed so far.
    pub fn into_words(self) -> HashMap<ValueId, Word> {
        self.words
    }

    /// Gives a value its word.
    pub fn define(&mut self, id: ValueId, word: Word) {
        self.words.insert(id, word);
    }

    /// Emits the op of a value that is not a leaf.
    pub fn emit(&mut self, id: ValueId) {
        let node = self.graph.node(id);
        let word = if node.width == 1 { self.bit(node.op) } else { self.word_op(node.op, node.width) };
        self.define(id, word);
    }

    /// The word of a value, bits above its width being rubbish.
    fn loose(&mut self, id: ValueId) -> Word {
        if let Some(&word) = self.words.get(&id) {
            return word;
        }
        let node = self.graph.node(id);
        if let Op::Const(value) = node.op {
            let bits = u64::BITS - value.leading_zeros();
            return Word { value: constant(self.b, machine_type(node.width), value), bits };
        }
        let word = Word { value: self.outside.fetch(self.b, id, node.width), bits: node.width };
        self.define(id, word);
        word
    }

    /// The word of a value with the bits above its width cleared.
    pub fn clean(&mut self, id: ValueId) -> Value {
        let (word, width) = (self.loose(id), self.graph.width(id));
        if word.bits <= width {
            return word.value;
        }
        let value = cut(self.b, word.value, width);
        self.define(id, Word { value, bits: width });
        value
    }

    fn constant_of(&self, id: ValueId) -> Option<u64> {
        match self.graph.node(id).op {
            Op::Const(value) => Some(value),
            _ => None,
        }
    }

    /// What a register holds after the end of the tick: `clear ? init : enable ? next : q`. Clean.
    pub fn committed(&mut self, register: &Register, q: Value) -> Value {
        let mut value = self.clean(register.next);
        if let Some(enable) = register.enable {
            let enable = self.clean(enable);
            value = self.b.ins().select(enable, value, q);
        }
        if let Some(clear) = register.clear {
            let clear = self.clean(clear);
            let init = constant(self.b, machine_type(register.width), register.init);
            value = self.b.ins().select(clear, init, value);
        }
        value
    }

    /// An op whose result has one bit, as 0 or 1 in a byte.
    fn bit(&mut self, op: Op) -> Word {
        let value = match op {
            Op::Not(a) => self.inverted(a),
            Op::Add(a, b) | Op::Sub(a, b) => self.xor_bits(a, b),
            Op::Mul(a, b) => self.and_bits(a, b),
            Op::Eq(a, b) if self.graph.width(a) == 1 => self.equal_bits(a, b),
            Op::Eq(a, b) => self.equal(a, b),
            Op::LtU(a, b) => self.less(a, b),
            Op::LtS(a, b) => self.less_signed(a, b),
            Op::Shl(a, n) | Op::ShrU(a, n) => {
                let (a, none) = (self.clean(a), self.is_zero(n));
                self.b.ins().band(a, none)
            }
            Op::ShrS(a, _) => self.clean(a),
            Op::Mux(s, a, b) => self.mux_bits(s, a, b),
            Op::ReduceAnd(a) => {
                let (ty, ones) = self.type_and_ones(a);
                let (a, ones) = (self.clean(a), constant(self.b, ty, ones));
                self.b.ins().icmp(IntCC::Equal, a, ones)
            }
            Op::ReduceOr(a) => {
                let a = self.clean(a);
                self.b.ins().icmp_imm_u(IntCC::NotEqual, a, 0)
            }
            Op::ReduceXor(a) => {
                let a = self.clean(a);
                let count = self.b.ins().popcnt(a);
                let count = resize(self.b, count, I8);
                cut(self.b, count, 1)
            }
            op => {
                let word = self.word_op(op, 1);
                if word.bits <= 1 { word.value } else { cut(self.b, word.value, 1) }
            }
        };
        Word { value, bits: 1 }
    }

    /// An op whose result has any width; `bits` of the result tells what is rubbish.
    fn word_op(&mut self, op: Op, width: u32) -> Word {
        let ty = machine_type(width);
        let all = ty.bits();
        match op {
            Op::Const(_) | Op::Input(_) | Op::Register(_) => unreachable!("leaves are fetched, not computed"),
            Op::Copy(a) => self.loose(a),
            Op::Not(a) => self.complement(a, width),
            Op::And(a, b) => self.both(a, b, |b, x, y| b.ins().band(x, y), |x, y| x.min(y)),
            Op::Or(a, b) => self.both(a, b, |b, x, y| b.ins().bor(x, y), |x, y| x.max(y)),
            Op::Xor(a, b) => self.both(a, b, |b, x, y| b.ins().bxor(x, y), |x, y| x.max(y)),
            Op::Add(a, b) => self.both(a, b, |b, x, y| b.ins().iadd(x, y), |x, y| all.min(x.max(y) + 1)),
            Op::Sub(a, b) => self.both(a, b, |b, x, y| b.ins().isub(x, y), |_, _| all),
            Op::Mul(a, b) => self.both(a, b, |b, x, y| b.ins().imul(x, y), |x, y| all.min(x + y)),
            Op::Shl(a, n) => self.shift_left(a, n, width),
            Op::ShrU(a, n) => self.shift_right(a, n, width),
            Op::ShrS(a, n) => self.shift_right_signed(a, n, width),
            Op::Mux(s, a, b) => {
                let when = self.clean(s);
                self.both(a, b, |b, x, y| b.ins().select(when, x, y), |x, y| x.max(y))
            }
            Op::Slice(a, low) => self.slice(a, low, ty),
            Op::Concat(high, low) => self.concat(high, low, ty),
            Op::ZeroExtend(a) => {
                let value = self.clean(a);
                Word { value: resize(self.b, value, ty), bits: self.loose(a).bits }
            }
            Op::SignExtend(a) => {
                let word = self.loose(a);
                let value = resize(self.b, word.value, ty);
                Word { value: self.sign_filled(value, self.graph.width(a)), bits: all }
            }
            Op::RomRead(rom, address) => {
                let memory = self.outside.rom(self.b, rom);
                self.read(memory, address, width)
            }
            Op::RamRead(ram, address) => {
                let memory = self.outside.ram(self.b, ram);
                self.read(memory, address, width)
            }
            Op::Eq(..) | Op::LtU(..) | Op::LtS(..) | Op::ReduceAnd(_) | Op::ReduceOr(_) | Op::ReduceXor(_) => {
                unreachable!("one-bit results are computed as bits")
            }
        }
    }

    fn both(
        &mut self,
        a: ValueId,
        b: ValueId,
        op: impl FnOnce(&mut FunctionBuilder<'f>, Value, Value) -> Value,
        bits: impl FnOnce(u32, u32) -> u32,
    ) -> Word {
        let (a, b) = (self.loose(a), self.loose(b));
        Word { value: op(self.b, a.value, b.value), bits: bits(a.bits, b.bits) }
    }

    fn complement(&mut self, a: ValueId, width: u32) -> Word {
        let word = self.loose(a);
        if word.bits > width {
            return Word { value: self.b.ins().bnot(word.value), bits: machine_type(width).bits() };
        }
        let ones = constant(self.b, machine_type(width), mask(width));
        Word { value: self.b.ins().bxor(word.value, ones), bits: width }
    }

    fn inverted(&mut self, a: ValueId) -> Value {
        let a = self.clean(a);
        self.b.ins().bxor_imm_u(a, 1)
    }

    fn xor_bits(&mut self, a: ValueId, b: ValueId) -> Value {
        let (a, b) = (self.clean(a), self.clean(b));
        self.b.ins().bxor(a, b)
    }

    fn and_bits(&mut self, a: ValueId, b: ValueId) -> Value {
        let (a, b) = (self.clean(a), self.clean(b));
        self.b.ins().band(a, b)
    }

    fn equal_bits(&mut self, a: ValueId, b: ValueId) -> Value {
        match (self.constant_of(a), self.constant_of(b)) {
            (_, Some(1)) => self.clean(a),
            (_, Some(_)) => self.inverted(a),
            (Some(1), _) => self.clean(b),
            (Some(_), _) => self.inverted(b),
            _ => {
                let differ = self.xor_bits(a, b);
                self.b.ins().bxor_imm_u(differ, 1)
            }
        }
    }

    fn type_and_ones(&self, a: ValueId) -> (Type, u64) {
        let width = self.graph.width(a);
        (machine_type(width), mask(width))
    }

    fn equal(&mut self, a: ValueId, b: ValueId) -> Value {
        let width = self.graph.width(a);
        if self.loose(a).bits > width && self.loose(b).bits > width {
            let differ = self.both(a, b, |b, x, y| b.ins().bxor(x, y), |x, _| x);
            let differ = cut(self.b, differ.value, width);
            return self.b.ins().icmp_imm_u(IntCC::Equal, differ, 0);
        }
        let (a, b) = (self.clean(a), self.clean(b));
        self.b.ins().icmp(IntCC::Equal, a, b)
    }

    fn is_zero(&mut self, a: ValueId) -> Value {
        let a = self.clean(a);
        self.b.ins().icmp_imm_u(IntCC::Equal, a, 0)
    }

    fn less(&mut self, a: ValueId, b: ValueId) -> Value {
        let (a, b) = (self.clean(a), self.clean(b));
        self.b.ins().icmp(IntCC::UnsignedLessThan, a, b)
    }

    /// Compares with the sign bits moved to the top of the machine words, which also drops what is above them.
    fn less_signed(&mut self, a: ValueId, b: ValueId) -> Value {
        let (a, b) = (self.topped(a), self.topped(b));
        self.b.ins().icmp(IntCC::SignedLessThan, a, b)
    }

    fn topped(&mut self, a: ValueId) -> Value {
        let (width, word) = (self.graph.width(a), self.loose(a));
        let spare = machine_type(width).bits() - width;
        if spare == 0 { word.value } else { self.b.ins().ishl_imm_u(word.value, i64::from(spare)) }
    }

    fn mux_bits(&mut self, s: ValueId, a: ValueId, b: ValueId) -> Value {
        let when = self.clean(s);
        match (self.constant_of(a), self.constant_of(b)) {
            (Some(0), _) => {
                let (not, b) = (self.inverted(s), self.clean(b));
                self.b.ins().band(not, b)
            }
            (Some(_), _) => {
                let b = self.clean(b);
                self.b.ins().bor(when, b)
            }
            (_, Some(0)) => {
                let a = self.clean(a);
                self.b.ins().band(when, a)
            }
            (_, Some(_)) => {
                let (not, a) = (self.inverted(s), self.clean(a));
                self.b.ins().bor(not, a)
            }
            _ => {
                let (a, b) = (self.clean(a), self.clean(b));
                self.b.ins().select(when, a, b)
            }
        }
    }

    fn shift_left(&mut self, a: ValueId, n: ValueId, width: u32) -> Word {
        let (ty, word) = (machine_type(width), self.loose(a));
        let amount = self.clean(n);
        let shifted = self.b.ins().ishl(word.value, amount);
        // The machine shifts by the amount modulo its word; up to there what leaves the word is rubbish above it.
        let value = self.unless_beyond(n, ty.bits(), width, shifted);
        Word { value, bits: ty.bits() }
    }

    fn shift_right(&mut self, a: ValueId, n: ValueId, width: u32) -> Word {
        let ty = machine_type(width);
        let (value, amount) = (self.clean(a), self.clean(n));
        let shifted = self.b.ins().ushr(value, amount);
        Word { value: self.unless_beyond(n, ty.bits(), width, shifted), bits: width }
    }

    /// `shifted`, or 0 when the amount `n` can be `limit` or more and is at least `width`.
    fn unless_beyond(&mut self, n: ValueId, limit: u32, width: u32, shifted: Value) -> Value {
        if mask(self.loose(n).bits) < u64::from(limit) {
            return shifted;
        }
        let amount = self.clean(n);
        let within = self.b.ins().icmp_imm_u(IntCC::UnsignedLessThan, amount, i64::from(width));
        let zero = constant(self.b, machine_type(width), 0);
        self.b.ins().select(within, shifted, zero)
    }

    fn shift_right_signed(&mut self, a: ValueId, n: ValueId, width: u32) -> Word {
        let ty = machine_type(width);
        let value = self.loose(a).value;
        let value = self.sign_filled(value, width);
        let mut amount = self.clean(n);
        if mask(self.loose(n).bits) >= u64::from(ty.bits()) {
            let most = constant(self.b, machine_type(self.graph.width(n)), u64::from(ty.bits()) - 1);
            amount = self.b.ins().umin(amount, most);
        }
        Word { value: self.b.ins().sshr(value, amount), bits: ty.bits() }
    }

    /// The value with the bit `width - 1` copied into all bits above it.
    fn sign_filled(&mut self, value: Value, width: u32) -> Value {
        let spare = i64::from(self.b.func.dfg.value_type(value).bits() - width);
        if spare == 0 {
            return value;
        }
        let top = self.b.ins().ishl_imm_u(value, spare);
        self.b.ins().sshr_imm_u(top, spare)
    }

    fn slice(&mut self, a: ValueId, low: u32, ty: Type) -> Word {
        let word = self.loose(a);
        let shifted = if low == 0 { word.value } else { self.b.ins().ushr_imm_u(word.value, i64::from(low)) };
        let bits = word.bits.saturating_sub(low).min(ty.bits());
        Word { value: resize(self.b, shifted, ty), bits }
    }

    fn concat(&mut self, high: ValueId, low: ValueId, ty: Type) -> Word {
        let split = self.graph.width(low);
        let (top, bottom) = (self.loose(high), self.clean(low));
        let (value, bottom) = (resize(self.b, top.value, ty), resize(self.b, bottom, ty));
        let value = self.b.ins().ishl_imm_u(value, i64::from(split));
        Word { value: self.b.ins().bor(value, bottom), bits: (top.bits + split).min(ty.bits()) }
    }

    /// A word of a memory whose words are followed by a zero, which answers all addresses beyond its depth.
    fn read(&mut self, (base, depth): (Value, usize), address: ValueId, width: u32) -> Word {
        let ty = machine_type(width);
        let index = self.index(address, depth);
        let place = self.element(base, index, ty);
        Word { value: self.b.ins().load(ty, MemFlagsData::trusted(), place, 0), bits: width }
    }

    /// Where a RAM's write goes at the end of the tick, and the word. A write that is not enabled or beyond the
    /// depth goes to the second element after the last, which nobody reads.
    pub fn write(&mut self, write: &MemoryWrite, image: &MemoryImage, id: RamId) -> (Value, Value) {
        let (base, depth) = self.outside.ram(self.b, id);
        let (enable, data) = (self.clean(write.enable), self.clean(write.data));
        let lost = constant(self.b, I64, depth as u64 + 1);
        let address = self.clean(write.address);
        let address = resize(self.b, address, I64);
        let within = self.b.ins().icmp_imm_u(IntCC::UnsignedLessThan, address, depth as i64);
        let taken = self.b.ins().band(within, enable);
        let index = self.b.ins().select(taken, address, lost);
        (self.element(base, index, machine_type(image.width())), data)
    }

    /// The address, or the depth for all addresses beyond it.
    fn index(&mut self, address: ValueId, depth: usize) -> Value {
        let mut index = self.clean(address);
        if mask(self.loose(address).bits) > depth as u64 {
            let last = constant(self.b, machine_type(self.graph.width(address)), depth as u64);
            index = self.b.ins().umin(index, last);
        }
        resize(self.b, index, I64)
    }

    fn element(&mut self, base: Value, index: Value, ty: Type) -> Value {
        let offset = self.b.ins().ishl_imm_u(index, i64::from(ty.bytes().trailing_zeros()));
        self.b.ins().iadd(base, offset)
    }
}
