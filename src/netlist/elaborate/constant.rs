//! Constants: a word with the width and sign that Verilog's rules give it (IEEE 1364-2005, 5.4 and 5.5).

use crate::base::word::{decode, encode, mask};
use crate::netlist::syntax::Binary;

/// Width and sign of a constant or a constant expression.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(super) struct Shape {
    /// 1 to 64.
    pub(super) width: u32,
    pub(super) signed: bool,
    /// Whether the width is written, and not just the 32 bits of a number without one.
    pub(super) sized: bool,
}

impl Shape {
    /// A whole number without a size.
    pub(super) const INTEGER: Shape = Shape { width: 32, signed: true, sized: false };

    /// An unsigned word of a written width.
    pub(super) fn bits(width: u32) -> Self {
        Shape { width, signed: false, sized: true }
    }

    /// What two operands that must agree are both brought to.
    pub(super) fn with(self, other: Shape) -> Shape {
        Shape {
            width: self.width.max(other.width),
            signed: self.signed && other.signed,
            sized: self.sized && other.sized,
        }
    }
}

/// A constant.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(super) struct Const {
    /// No bits above the width.
    pub(super) word: u64,
    pub(super) shape: Shape,
}

impl Const {
    /// A whole number: of 32 bits without a size when that holds it, else of 64.
    pub(super) fn integer(value: i64) -> Self {
        let small = i32::try_from(value).is_ok();
        let shape = if small { Shape::INTEGER } else { Shape { width: 64, signed: true, sized: true } };
        Const { word: value as u64 & mask(shape.width), shape }
    }

    /// One bit.
    pub(super) fn bit(value: bool) -> Self {
        Const { word: value.into(), shape: Shape::bits(1) }
    }

    /// The number it stands for.
    pub(super) fn number(self) -> i128 {
        decode(self.word, self.shape.width, self.shape.signed)
    }

    /// The same number in another shape, if that can hold it.
    pub(super) fn fitted(self, shape: Shape) -> Option<Self> {
        encode(self.number(), shape.width, shape.signed).map(|word| Const { word, shape })
    }

    /// Widened to an operand of an expression of `shape`: by its sign only if the whole is signed.
    pub(super) fn widened(self, shape: Shape) -> Self {
        let word = decode(self.word, self.shape.width, shape.signed) as u64 & mask(shape.width);
        Const { word, shape }
    }
}

/// Why an operation has no value.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Undefined {
    DivisionByZero,
    /// A result beyond its bits.
    Overflow,
}

/// An arithmetic or bitwise operation; both operands have the shape of the result.
pub(super) fn combine(op: Binary, a: Const, b: Const) -> Result<Const, Undefined> {
    let shape = a.shape;
    let word = match op {
        Binary::And => a.word & b.word,
        Binary::Or => a.word | b.word,
        Binary::Xor => a.word ^ b.word,
        Binary::Xnor => !(a.word ^ b.word) & mask(shape.width),
        _ => return arithmetic(op, a.number(), b.number()).and_then(|value| wrap(value, shape)),
    };
    Ok(Const { word, shape })
}

fn arithmetic(op: Binary, a: i128, b: i128) -> Result<i128, Undefined> {
    match op {
        Binary::Divide | Binary::Modulo if b == 0 => Err(Undefined::DivisionByZero),
        Binary::Divide => Ok(a / b),
        Binary::Modulo => Ok(a % b),
        Binary::Subtract => Ok(a - b),
        Binary::Multiply => a.checked_mul(b).ok_or(Undefined::Overflow),
        _ => Ok(a + b),
    }
}

/// A number in a shape that can hold it. Tools disagree on whether a result is cut or grows when it cannot.
fn wrap(value: i128, shape: Shape) -> Result<Const, Undefined> {
    encode(value, shape.width, shape.signed).map(|word| Const { word, shape }).ok_or(Undefined::Overflow)
}

/// The negative in two's complement, which an unsigned word has too.
pub(super) fn negate(a: Const) -> Result<Const, Undefined> {
    let shape = a.shape;
    if shape.signed {
        wrap(-a.number(), shape)
    } else {
        Ok(Const { word: a.word.wrapping_neg() & mask(shape.width), shape })
    }
}

/// `base ** exponent` (IEEE 1364-2005, table 5-6) in the shape of the base.
pub(super) fn power(base: Const, exponent: i128) -> Result<Const, Undefined> {
    let (number, shape) = (base.number(), base.shape);
    let value = match (number, exponent) {
        (0, ..0) => return Err(Undefined::DivisionByZero),
        (_, 0) | (1, _) => 1,
        (-1, _) if exponent % 2 == 0 => 1,
        (-1, _) => -1,
        (_, ..0) | (0, _) => 0,
        _ => {
            let exact = u32::try_from(exponent).ok().and_then(|exponent| number.checked_pow(exponent));
            exact.ok_or(Undefined::Overflow)?
        }
    };
    wrap(value, shape)
}

/// A shift of `a` by `amount` bits.
pub(super) fn shift(op: Binary, a: Const, amount: u64) -> Result<Const, Undefined> {
    let (number, shape) = (a.number(), a.shape);
    let places = amount.min(64) as u32;
    match op {
        Binary::ShiftLeft => wrap(number << places, shape),
        Binary::ShiftRightSigned => wrap(number >> places, shape),
        _ => Ok(Const { word: a.word.checked_shr(places).unwrap_or(0), shape }),
    }
}

/// A comparison; both operands have one shape.
pub(super) fn compare(op: Binary, a: Const, b: Const) -> bool {
    let (a, b) = (a.number(), b.number());
    match op {
        Binary::Less => a < b,
        Binary::LessEqual => a <= b,
        Binary::Greater => a > b,
        Binary::GreaterEqual => a >= b,
        Binary::NotEqual => a != b,
        _ => a == b,
    }
}
