//! The builder: how a block puts itself together out of ops and other blocks.

mod state;

use std::cmp::Ordering;

pub use state::Held;

use super::body::{Body, InnerSignal};
use super::describe::{Description, Direction, Parameters};
use super::{Block, find};
use crate::base::word::{MAX_WIDTH, mask};
use crate::base::{MemoryImage, Op, ValueId};

/// Builds one block for one set of parameters.
///
/// What cannot be (a word beyond 64 bits, operands of unequal width) is noted, once, and stood in for by a zero, so
/// that a block's file reads as if nothing could fail; [`Builder::build`] then tells why there is no body.
#[derive(Debug)]
pub struct Builder {
    description: &'static Description,
    /// The first thing that cannot be.
    failure: Option<String>,
    parameters: Parameters,
    body: Body,
    outputs: Vec<Option<ValueId>>,
    scope: Vec<String>,
}

impl Builder {
    /// Builds `block`; `parameters` must be in range and accepted by its check.
    ///
    /// # Errors
    /// What stands in the way, for a message that names the block.
    pub fn build(block: &Block, parameters: &Parameters) -> Result<Body, String> {
        let description = block.description();
        let mut b = Builder {
            description,
            failure: None,
            parameters: parameters.clone(),
            body: Body::default(),
            outputs: vec![None; description.ports_of(Direction::Output).count()],
            scope: Vec::new(),
        };
        for (i, port) in description.ports_of(Direction::Input).enumerate() {
            let width = b.fitting(port.width.bits(parameters));
            b.body.inputs.push(width);
            b.body.graph.push(Op::Input(i as u32), width);
        }
        block.build(&mut b);
        for (value, port) in b.outputs.iter().zip(description.ports_of(Direction::Output)) {
            match value {
                Some(value) => b.body.outputs.push(*value),
                None => return Err(b.failure.unwrap_or_else(|| format!("its output `{}` gets no value", port.name))),
            }
        }
        b.failure.map_or(Ok(b.body), Err)
    }

    /// Notes that something cannot be.
    fn fail(&mut self, why: impl Into<String>) {
        self.failure.get_or_insert_with(|| why.into());
    }

    /// A width that a word can have: this one, or the nearest after noting that it cannot be.
    fn fitting(&mut self, bits: i64) -> u32 {
        let nearest = bits.clamp(1, MAX_WIDTH.into());
        if nearest != bits {
            self.fail(format!("a word of {bits} bits is needed, and 1 to {MAX_WIDTH} are possible"));
        }
        nearest as u32
    }

    /// A zero of as nearly so many bits as can be, for what cannot be built.
    fn stand_in(&mut self, bits: i64) -> ValueId {
        let width = self.fitting(bits);
        self.body.graph.push(Op::Const(0), width)
    }

    /// A parameter's value.
    #[must_use]
    pub fn param(&self, name: &str) -> i64 {
        self.parameters.get(name)
    }

    /// A parameter's value as a width or a count; its range holds such values only.
    ///
    /// # Panics
    /// When the range of the block's own parameter holds others, which the registry tests find.
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
    /// When the block's own description has no such input, which the registry tests find.
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
    /// When the block's own description has no such output, which the registry tests find.
    pub fn output(&mut self, name: &str, value: ValueId) {
        let mut ports = self.description.ports_of(Direction::Output).enumerate();
        let (i, port) = ports.find(|(_, port)| port.name == name).unwrap_or_else(|| panic!("no output {name}"));
        let (given, wanted) = (self.width(value), port.width.bits(&self.parameters));
        if i64::from(given) != wanted {
            self.fail(format!("its output `{name}` of {wanted} bits gets {given}"));
        }
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
    /// When there is no such block, parameter or input, or an input is left open, which the registry tests find.
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
        let Some(inner) = self.inner(block, &values) else {
            let outputs = description.ports_of(Direction::Output).map(|port| port.width.bits(&values));
            return outputs.map(|bits| self.stand_in(bits)).collect();
        };
        let connected: Vec<ValueId> = description
            .ports_of(Direction::Input)
            .map(|port| {
                let found = inputs.iter().find(|(name, _)| *name == port.name);
                found.unwrap_or_else(|| panic!("{}: input {} is open", description.name, port.name)).1
            })
            .collect();
        for (&value, &wanted) in connected.iter().zip(&inner.inputs) {
            let given = self.width(value);
            if given != wanted {
                self.fail(format!("`{}` inside it gets {given} bits for an input of {wanted}", description.name));
            }
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

    /// The body of a block inside this one; `None` after noting why there is none.
    fn inner(&mut self, block: &Block, parameters: &Parameters) -> Option<Body> {
        let description = block.description();
        let outside = description.parameters.iter().find(|p| !(p.min..=p.max).contains(&parameters.get(p.name)));
        let accepted = match outside {
            Some(p) => Err(format!("{} is {}, but is {} to {}", p.name, parameters.get(p.name), p.min, p.max)),
            None => block.check(parameters),
        };
        let built = accepted.and_then(|()| Builder::build(block, parameters));
        built.map_err(|why| self.fail(format!("`{}` inside it: {why}", description.name))).ok()
    }

    /// The width of a value in bits.
    #[must_use]
    pub fn width(&self, value: ValueId) -> u32 {
        self.body.graph.width(value)
    }

    fn push(&mut self, op: Op, width: u32) -> ValueId {
        let width = self.fitting(width.into());
        self.body.graph.push(op, width)
    }

    fn same_width(&mut self, a: ValueId, b: ValueId) -> u32 {
        let (width, other) = (self.width(a), self.width(b));
        if width != other {
            self.fail(format!("operands of {width} and {other} bits meet"));
        }
        width
    }

    fn bit_wide(&mut self, value: ValueId) {
        let width = self.width(value);
        if width != 1 {
            self.fail(format!("{width} bits stand where one is wanted"));
        }
    }

    /// An op on two operands of one width, which is the result's.
    fn pair(&mut self, op: Op, a: ValueId, b: ValueId) -> ValueId {
        let width = self.same_width(a, b);
        self.push(op, width)
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
        self.pair(Op::And(a, b), a, b)
    }

    /// Bitwise or.
    pub fn or(&mut self, a: ValueId, b: ValueId) -> ValueId {
        self.pair(Op::Or(a, b), a, b)
    }

    /// Bitwise exclusive or.
    pub fn xor(&mut self, a: ValueId, b: ValueId) -> ValueId {
        self.pair(Op::Xor(a, b), a, b)
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
        self.pair(Op::Add(a, b), a, b)
    }

    /// Difference modulo 2^width.
    pub fn sub(&mut self, a: ValueId, b: ValueId) -> ValueId {
        self.pair(Op::Sub(a, b), a, b)
    }

    /// Product modulo 2^width.
    pub fn mul(&mut self, a: ValueId, b: ValueId) -> ValueId {
        self.pair(Op::Mul(a, b), a, b)
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
        self.bit_wide(when);
        self.pair(Op::Mux(when, then, otherwise), then, otherwise)
    }

    /// The word when `open` (one bit) is 1, otherwise 0.
    pub fn gate(&mut self, open: ValueId, word: ValueId) -> ValueId {
        let zero = self.constant(0, self.width(word));
        self.mux(open, word, zero)
    }

    /// The bits `low .. low + width`.
    pub fn slice(&mut self, a: ValueId, low: u32, width: u32) -> ValueId {
        let whole = self.width(a);
        if u64::from(low) + u64::from(width) > whole.into() {
            self.fail(format!("{width} bits from bit {low} on are wanted of a word of {whole}"));
            return self.stand_in(width.into());
        }
        if width == whole { a } else { self.push(Op::Slice(a, low), width) }
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
    /// When there is no part, which the registry tests find.
    pub fn join(&mut self, parts: &[ValueId]) -> ValueId {
        let [first, rest @ ..] = parts else { panic!("a word of no parts") };
        rest.iter().fold(*first, |low, &high| self.concat(high, low))
    }

    /// Widened with zeros to `width` bits; unchanged when it has them already.
    pub fn zero_extend(&mut self, a: ValueId, width: u32) -> ValueId {
        self.extend(Op::ZeroExtend(a), a, width)
    }

    /// Widened with the sign to `width` bits; unchanged when it has them already.
    pub fn sign_extend(&mut self, a: ValueId, width: u32) -> ValueId {
        self.extend(Op::SignExtend(a), a, width)
    }

    fn extend(&mut self, op: Op, a: ValueId, width: u32) -> ValueId {
        match self.width(a).cmp(&width) {
            Ordering::Less => self.push(op, width),
            Ordering::Equal => a,
            Ordering::Greater => {
                self.fail(format!("a word of {} bits is to be widened to {width}", self.width(a)));
                self.stand_in(width.into())
            }
        }
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
}
