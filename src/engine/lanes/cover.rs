//! Cover: chooses machine operations for the gates of a segment and puts them in a straight line.
//!
//! Two instruction sets are covered. With two-operand logic (and, and-not, or, xor) every gate is one operation: a value
//! is kept complemented when that saves a complement. With three-operand tables (`vpternlogq`) small cones of gates,
//! found by enumerating cuts of up to three leaves, become one operation each: a full adder is two, a multiplexer one.

use std::collections::HashMap;

use super::gates::{Bit, Gate, Gates};
use super::segment::{ONES, Place, Segment};
use super::straight::{Cell, Function, Step, Straight};
use super::tables::{self, Cuts};

/// The operations to choose from.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Instructions {
    Pairs,
    Tables,
}

/// Covers a segment.
pub(super) fn cover(gates: &Gates, segment: &Segment, instructions: Instructions) -> Straight {
    let needed = needed(gates, segment);
    let cells = match instructions {
        Instructions::Pairs => pairs(gates, segment, &needed),
        Instructions::Tables => tables::cells(&Cuts::of(gates, segment, &needed), segment, gates.len()),
    };
    let mut line = Liner { cells, numbers: HashMap::new(), straight: Straight::default() };
    for &gate in needed.iter().filter(|&gate| segment.known.contains_key(gate)) {
        line.leaf(gate, segment.known[&gate]);
    }
    line.leaf(usize::MAX, Place::Fixed(ONES));
    line.straight.values = line.straight.leaves.len();
    for &(bit, place) in &segment.sinks {
        line.store(bit, place);
    }
    line.straight
}

/// The gates a segment needs, in order.
fn needed(gates: &Gates, segment: &Segment) -> Vec<usize> {
    let mut seen = vec![false; gates.len()];
    let mut stack: Vec<_> = segment.sinks.iter().map(|(bit, _)| bit.gate()).collect();
    while let Some(gate) = stack.pop() {
        if !std::mem::replace(&mut seen[gate], true)
            && !segment.known.contains_key(&gate)
            && let Gate::And(a, b) | Gate::Xor(a, b) = gates.gate(gate)
        {
            stack.extend([a.gate(), b.gate()]);
        }
    }
    (0..gates.len()).filter(|&gate| seen[gate]).collect()
}

/// One operation for each gate.
fn pairs(gates: &Gates, segment: &Segment, needed: &[usize]) -> Vec<Option<Cell>> {
    let mut cells: Vec<Option<Cell>> = vec![None; gates.len()];
    for &gate in needed.iter().filter(|gate| !segment.known.contains_key(gate)) {
        let kept = |bit: Bit| cells[bit.gate()].is_some_and(|cell| cell.complement) != bit.is_complement();
        cells[gate] = match gates.gate(gate) {
            Gate::False | Gate::Leaf => None,
            Gate::Xor(a, b) => Some(cell(Function::Xor, a, b, kept(a) != kept(b))),
            Gate::And(a, b) => Some(match (kept(a), kept(b)) {
                (false, false) => cell(Function::And, a, b, false),
                (true, false) => cell(Function::AndNot, a, b, false),
                (false, true) => cell(Function::AndNot, b, a, false),
                (true, true) => cell(Function::Or, a, b, true),
            }),
        };
    }
    cells
}

fn cell(function: Function, a: Bit, b: Bit, complement: bool) -> Cell {
    Cell { function, operands: [a.gate() as u32, b.gate() as u32, b.gate() as u32], complement }
}

/// Puts cells in a line, each after its operands and as late as its first use.
struct Liner {
    cells: Vec<Option<Cell>>,
    numbers: HashMap<usize, u32>,
    straight: Straight,
}

impl Liner {
    fn leaf(&mut self, gate: usize, place: Place) {
        self.numbers.insert(gate, self.straight.leaves.len() as u32);
        self.straight.leaves.push(place);
    }

    fn compute(&mut self, function: Function, operands: [u32; 3]) -> u32 {
        let result = self.straight.values as u32;
        self.straight.values += 1;
        self.straight.steps.push(Step::Compute { result, function, operands });
        result
    }

    fn store(&mut self, bit: Bit, place: Place) {
        self.place(bit.gate());
        let mut value = self.numbers[&bit.gate()];
        if self.cells[bit.gate()].is_some_and(|cell| cell.complement) != bit.is_complement() {
            let ones = self.numbers[&usize::MAX];
            value = self.compute(Function::Xor, [value, ones, ones]);
        }
        self.straight.steps.push(Step::Store { value, place });
    }

    /// Computes a gate after what it needs. An explicit stack: networks are deeper than the machine's.
    fn place(&mut self, root: usize) {
        let mut stack = vec![(root, false)];
        while let Some((gate, operands_done)) = stack.pop() {
            if self.numbers.contains_key(&gate) {
                continue;
            }
            let cell = self.cells[gate].expect("a needed gate is known or covered");
            let operands = &cell.operands[..cell.function.arity()];
            if operands_done {
                let number = |i: usize| self.numbers[&(cell.operands[i.min(operands.len() - 1)] as usize)];
                let numbers = [number(0), number(1), number(2)];
                let result = self.compute(cell.function, numbers);
                self.numbers.insert(gate, result);
            } else {
                stack.push((gate, true));
                stack.extend(operands.iter().rev().map(|&operand| (operand as usize, false)));
            }
        }
    }
}
