//! Straight-line code over planes: what every way of running it starts from.

use super::segment::Place;

/// What an operation does with its operands, bit by bit.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Function {
    And,
    /// The complement of the first and the second.
    AndNot,
    Or,
    Xor,
    /// Bit `4a + 2b + c` of the table.
    Table(u8),
}

impl Function {
    pub(super) fn arity(self) -> usize {
        if matches!(self, Function::Table(_)) { 3 } else { 2 }
    }
}

/// A step of straight-line code over numbered values.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Step {
    Compute { result: u32, function: Function, operands: [u32; 3] },
    Store { value: u32, place: Place },
}

/// Straight-line code: the first values are read from places, each other one is the result of one step.
#[derive(Clone, Debug, Default)]
pub(super) struct Straight {
    pub(super) leaves: Vec<Place>,
    pub(super) steps: Vec<Step>,
    /// How many values there are.
    pub(super) values: usize,
}

/// The operation chosen for a gate.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cell {
    pub(super) function: Function,
    /// Gates; only the first [`Function::arity`] count.
    pub(super) operands: [u32; 3],
    /// Whether the value is kept complemented.
    pub(super) complement: bool,
}
