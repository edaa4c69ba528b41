//! The builder: how a block puts itself together out of ops and other blocks.

use super::body::{Body, InnerSignal};
use super::describe::{Description, Direction, Parameters};
use super::{Block, find};
use crate::base::word::{MAX_WIDTH, mask};
use crate::base::{MemoryImage, MemoryWrite, Op, Ram, RamId, Register, RegisterId, Rom, RomId, ValueId};

/// A register that has been declared and still wants its inputs: its content can be read before they exist.
#[derive(Clone, Copy, Debug)]
#[must_use = "a register without inputs never changes: give it to Builder::load"]
pub struct Held {
    id: RegisterId,
    /// The content.
    pub q: ValueId,
}

/// Builds one block for one set of parameters.
///
/// Methods that make ops check widths and panic on a mismatch: that is a mistake in a block's file, and the
/// registry tests build every block at the ends of its parameters' ranges to find it.
#[derive(Debug)]
pub struct Builder {
    description: &'static Description,
    parameters: Parameters,
    body: Body,
    outputs: Vec<Option<ValueId>>,
    scope: Vec<String>,
}

impl Builder {
    /// Builds `block`; `parameters` must be in range.
    ///
    /// # Panics
    /// When the block's file contradicts itself.
    #[must_use]
    pub fn build(block: &Block, parameters: &Parameters) -> Body {
        let description = block.description();
        let mut b = Builder {
            description,
            parameters: parameters.clone(),
            body: Body::default(),
            outputs: vec![None; description.ports_of(Direction::Output).count()],
            scope: Vec::new(),
        };
        for (i, port) in description.ports_of(Direction::Input).enumerate() {
            let width = port_width(port.width.bits(parameters), description.name, port.name);
            b.body.inputs.push(width);
            b.body.graph.push(Op::Input(i as u32), width);
        }
        block.build(&mut b);
        let outputs = b.outputs.iter().zip(description.ports_of(Direction::Output)).map(|(value, port)| {
            value.unwrap_or_else(|| panic!("{}: output {} is not built", description.name, port.name))
        });
        b.body.outputs = outputs.collect();
        b.body
    }

    /// A parameter's value.
    #[must_use]
    pub fn param(&self, name: &str) -> i64 {
        self.parameters.get(name)
    }

    /// A parameter's value as a width or a count.
    ///
    /// # Panics
    /// When it is negative, which the parameter's range must exclude.
    #[must_use]
    pub fn count(&self, name: &str) -> u32 {
        u32::try_from(self.param(name)).expect("a parameter used as a count is not negative")
    }

    /// The memory image that the block's [`super::ImageFormat`] has read; `None` where its parameter names no file.
    #[must_use]
    pub fn image(&self) -> Option<MemoryImage> {
        self.parameters.image().cloned()
    }

    /// The value of an input port.
    ///
    /// # Panics
    /// When the description has no such input.
    #[must_use]
    pub fn input(&self, name: &str) -> ValueId {
        let place = self.description.ports_of(Direction::Input).position(|port| port.name == name);
        ValueId::new(place.unwrap_or_else(|| panic!("{}: no input {name}", self.description.name)))
    }

    /// The values of all input ports, in the order of the description.
    pub fn inputs(&self) -> impl Iterator<Item = ValueId> + use<> {
        (0..self.body.inputs.len()).map(ValueId::new)
    }

    /// Gives an output port its value.
    ///
    /// # Panics
    /// When the description has no such output, or one of another width.
    pub fn output(&mut self, name: &str, value: ValueId) {
        let mut ports = self.description.ports_of(Direction::Output).enumerate();
        let (i, port) = ports.find(|(_, port)| port.name == name).unwrap_or_else(|| panic!("no output {name}"));
        let width = port.width.bits(&self.parameters);
        assert_eq!(i64::from(self.width(value)), width, "{}: width of output {name}", self.description.name);
        self.outputs[i] = Some(value);
    }

    /// Shows a value inside the block under a name in the waveform, and returns it.
    pub fn name(&mut self, name: &str, value: ValueId) -> ValueId {
        self.show(name, value, false)
    }

    /// The same for a two's-complement word.
    pub fn name_signed(&mut self, name: &str, value: ValueId) -> ValueId {
        self.show(name, value, true)
    }

    fn show(&mut self, name: &str, value: ValueId, signed: bool) -> ValueId {
        let path = self.scope.iter().cloned().chain([name.to_owned()]).collect();
        self.body.signals.push(InnerSignal { path, signed, value });
        value
    }

    /// Puts what `inside` builds into a sub-scope of the waveform.
    pub fn scope<T>(&mut self, name: &str, inside: impl FnOnce(&mut Self) -> T) -> T {
        self.scope.push(name.to_owned());
        let result = inside(self);
        self.scope.pop();
        result
    }

    /// Places another block inside this one, as a sub-scope; returns its outputs in the order of its ports.
    ///
    /// # Panics
    /// When there is no such block, parameter or input, a parameter is out of range, or an input is left open.
    pub fn block(
        &mut self,
        instance: &str,
        block: &str,
        parameters: &[(&str, i64)],
        inputs: &[(&str, ValueId)],
    ) -> Vec<ValueId> {
        let block = find(block).unwrap_or_else(|| panic!("no block {block}"));
        let description = block.description();
        let mut values = Parameters::defaults(description);
        for (name, value) in parameters {
            assert!(values.set(name, *value), "{}: no parameter {name}", description.name);
        }
        let inner = Builder::build(block, &values);
        let connected: Vec<ValueId> = description
            .ports_of(Direction::Input)
            .map(|port| {
                let found = inputs.iter().find(|(name, _)| *name == port.name);
                found.unwrap_or_else(|| panic!("{}: input {} is open", description.name, port.name)).1
            })
            .collect();
        for (value, width) in connected.iter().zip(&inner.inputs) {
            assert_eq!(self.width(*value), *width, "{}: width of an input", description.name);
        }
        let place = self.body.graph.append(&inner.graph, &connected);
        self.scope(instance, |b| {
            for signal in &inner.signals {
                let path = b.scope.iter().chain(&signal.path).cloned().collect();
                let value = place(signal.value);
                b.body.signals.push(InnerSignal { path, signed: signal.signed, value });
            }
        });
        inner.outputs.iter().map(|&output| place(output)).collect()
    }

    /// The width of a value in bits.
    #[must_use]
    pub fn width(&self, value: ValueId) -> u32 {
        self.body.graph.width(value)
    }

    fn push(&mut self, op: Op, width: u32) -> ValueId {
        assert!((1..=MAX_WIDTH).contains(&width), "{}: a word of {width} bits", self.description.name);
        self.body.graph.push(op, width)
    }

    fn same_width(&self, a: ValueId, b: ValueId) -> u32 {
        assert_eq!(self.width(a), self.width(b), "{}: operands of unequal width", self.description.name);
        self.width(a)
    }

    fn bit_wide(&self, value: ValueId) -> ValueId {
        assert_eq!(self.width(value), 1, "{}: one bit wanted", self.description.name);
        value
    }

    /// A constant, cut to `width` bits.
    pub fn constant(&mut self, value: u64, width: u32) -> ValueId {
        self.push(Op::Const(value & mask(width)), width)
    }

    /// A constant of one bit.
    pub fn bit(&mut self, value: bool) -> ValueId {
        self.constant(value.into(), 1)
    }

    /// Bitwise complement.
    pub fn not(&mut self, a: ValueId) -> ValueId {
        self.push(Op::Not(a), self.width(a))
    }

    /// Bitwise and.
    pub fn and(&mut self, a: ValueId, b: ValueId) -> ValueId {
        self.push(Op::And(a, b), self.same_width(a, b))
    }

    /// Bitwise or.
    pub fn or(&mut self, a: ValueId, b: ValueId) -> ValueId {
        self.push(Op::Or(a, b), self.same_width(a, b))
    }

    /// Bitwise exclusive or.
    pub fn xor(&mut self, a: ValueId, b: ValueId) -> ValueId {
        self.push(Op::Xor(a, b), self.same_width(a, b))
    }

    /// The and of one-bit values; 1 for none.
    pub fn all(&mut self, bits: &[ValueId]) -> ValueId {
        match bits {
            [] => self.bit(true),
            [first, rest @ ..] => rest.iter().fold(*first, |acc, &next| self.and(acc, next)),
        }
    }

    /// The or of one-bit values; 0 for none.
    pub fn any(&mut self, bits: &[ValueId]) -> ValueId {
        match bits {
            [] => self.bit(false),
            [first, rest @ ..] => rest.iter().fold(*first, |acc, &next| self.or(acc, next)),
        }
    }

    /// Sum modulo 2^width.
    pub fn add(&mut self, a: ValueId, b: ValueId) -> ValueId {
        self.push(Op::Add(a, b), self.same_width(a, b))
    }

    /// Difference modulo 2^width.
    pub fn sub(&mut self, a: ValueId, b: ValueId) -> ValueId {
        self.push(Op::Sub(a, b), self.same_width(a, b))
    }

    /// Product modulo 2^width.
    pub fn mul(&mut self, a: ValueId, b: ValueId) -> ValueId {
        self.push(Op::Mul(a, b), self.same_width(a, b))
    }

    /// Two's-complement negation.
    pub fn negate(&mut self, a: ValueId) -> ValueId {
        let zero = self.constant(0, self.width(a));
        self.sub(zero, a)
    }

    /// Whether two words are equal.
    pub fn eq(&mut self, a: ValueId, b: ValueId) -> ValueId {
        self.same_width(a, b);
        self.push(Op::Eq(a, b), 1)
    }

    /// Whether a word equals a constant.
    pub fn is(&mut self, a: ValueId, value: u64) -> ValueId {
        let value = self.constant(value, self.width(a));
        self.eq(a, value)
    }

    /// Unsigned less-than.
    pub fn less(&mut self, a: ValueId, b: ValueId) -> ValueId {
        self.same_width(a, b);
        self.push(Op::LtU(a, b), 1)
    }

    /// Two's-complement less-than.
    pub fn less_signed(&mut self, a: ValueId, b: ValueId) -> ValueId {
        self.same_width(a, b);
        self.push(Op::LtS(a, b), 1)
    }

    /// Left shift by a value.
    pub fn shift_left(&mut self, a: ValueId, amount: ValueId) -> ValueId {
        self.push(Op::Shl(a, amount), self.width(a))
    }

    /// Logical right shift by a value.
    pub fn shift_right(&mut self, a: ValueId, amount: ValueId) -> ValueId {
        self.push(Op::ShrU(a, amount), self.width(a))
    }

    /// Arithmetic right shift by a value.
    pub fn shift_right_signed(&mut self, a: ValueId, amount: ValueId) -> ValueId {
        self.push(Op::ShrS(a, amount), self.width(a))
    }

    /// `when` (one bit) 1: `then`; 0: `otherwise`.
    pub fn mux(&mut self, when: ValueId, then: ValueId, otherwise: ValueId) -> ValueId {
        let when = self.bit_wide(when);
        self.push(Op::Mux(when, then, otherwise), self.same_width(then, otherwise))
    }

    /// The word when `open` (one bit) is 1, otherwise 0.
    pub fn gate(&mut self, open: ValueId, word: ValueId) -> ValueId {
        let zero = self.constant(0, self.width(word));
        self.mux(open, word, zero)
    }

    /// The bits `low .. low + width`.
    pub fn slice(&mut self, a: ValueId, low: u32, width: u32) -> ValueId {
        assert!(low + width <= self.width(a), "{}: slice beyond the word", self.description.name);
        if width == self.width(a) { a } else { self.push(Op::Slice(a, low), width) }
    }

    /// One bit of a word.
    pub fn pick(&mut self, a: ValueId, bit: u32) -> ValueId {
        self.slice(a, bit, 1)
    }

    /// The top bit of a word: the sign in two's or one's complement.
    pub fn sign(&mut self, a: ValueId) -> ValueId {
        self.pick(a, self.width(a) - 1)
    }

    /// `high` above `low`.
    pub fn concat(&mut self, high: ValueId, low: ValueId) -> ValueId {
        self.push(Op::Concat(high, low), self.width(high) + self.width(low))
    }

    /// All parts as one word, the first part lowest.
    ///
    /// # Panics
    /// When there is no part.
    pub fn join(&mut self, parts: &[ValueId]) -> ValueId {
        let [first, rest @ ..] = parts else { panic!("a word of no parts") };
        rest.iter().fold(*first, |low, &high| self.concat(high, low))
    }

    /// Widened with zeros to `width` bits; unchanged when it has them already.
    pub fn zero_extend(&mut self, a: ValueId, width: u32) -> ValueId {
        assert!(width >= self.width(a), "{}: extension to fewer bits", self.description.name);
        if width == self.width(a) { a } else { self.push(Op::ZeroExtend(a), width) }
    }

    /// Widened with the sign to `width` bits; unchanged when it has them already.
    pub fn sign_extend(&mut self, a: ValueId, width: u32) -> ValueId {
        assert!(width >= self.width(a), "{}: extension to fewer bits", self.description.name);
        if width == self.width(a) { a } else { self.push(Op::SignExtend(a), width) }
    }

    /// Whether all bits are 1.
    pub fn reduce_and(&mut self, a: ValueId) -> ValueId {
        self.push(Op::ReduceAnd(a), 1)
    }

    /// Whether a bit is 1.
    pub fn reduce_or(&mut self, a: ValueId) -> ValueId {
        self.push(Op::ReduceOr(a), 1)
    }

    /// Whether an odd number of bits is 1.
    pub fn reduce_xor(&mut self, a: ValueId) -> ValueId {
        self.push(Op::ReduceXor(a), 1)
    }

    /// The word of a read-only memory at `address`; 0 beyond its depth.
    pub fn rom(&mut self, image: MemoryImage, address: ValueId) -> ValueId {
        let width = image.width();
        self.body.graph.roms.push(Rom { image });
        let rom = RomId::new(self.body.graph.roms.len() - 1);
        self.push(Op::RomRead(rom, address), width)
    }

    /// The present word at `read` of a writable memory with one write port; 0 beyond its depth.
    pub fn ram(&mut self, image: MemoryImage, write: MemoryWrite, read: ValueId) -> ValueId {
        self.bit_wide(write.enable);
        let width = image.width();
        assert_eq!(self.width(write.data), width, "{}: width of the data", self.description.name);
        self.body.graph.rams.push(Ram { image, write });
        let ram = RamId::new(self.body.graph.rams.len() - 1);
        self.push(Op::RamRead(ram, read), width)
    }

    /// Declares a register with its power-on content, cut to `width` bits.
    pub fn hold(&mut self, width: u32, init: u64) -> Held {
        let id = RegisterId::new(self.body.graph.registers.len());
        let q = self.push(Op::Register(id), width);
        self.body.graph.registers.push(Register {
            width,
            init: init & mask(width),
            next: q,
            enable: None,
            clear: None,
        });
        Held { id, q }
    }

    /// Gives a register its inputs: `q(t+1) = clear ? init : enable ? next : q`. Returns the content.
    pub fn load(
        &mut self,
        held: Held,
        next: ValueId,
        enable: impl Into<Option<ValueId>>,
        clear: impl Into<Option<ValueId>>,
    ) -> ValueId {
        self.same_width(held.q, next);
        let (enable, clear) = (enable.into(), clear.into());
        for control in [enable, clear].into_iter().flatten() {
            self.bit_wide(control);
        }
        let register = &mut self.body.graph.registers[held.id.index()];
        (register.next, register.enable, register.clear) = (next, enable, clear);
        held.q
    }

    /// A word one tick later, 0 at power-on.
    pub fn delay(&mut self, a: ValueId) -> ValueId {
        let held = self.hold(self.width(a), 0);
        self.load(held, a, None, None)
    }
}

fn port_width(bits: i64, block: &str, port: &str) -> u32 {
    let width = u32::try_from(bits).ok().filter(|w| (1..=MAX_WIDTH).contains(w));
    width.unwrap_or_else(|| panic!("{block}: port {port} has {bits} bits"))
}
