//! Verilog's gate primitives: one-bit gates with any number of inputs.

use super::body::Body;
use crate::base::{Graph, Op};

/// A gate primitive.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Gate {
    /// All inputs 1.
    And,
    /// Any input 1.
    Or,
    /// An odd number of inputs 1.
    Xor,
    /// Not all inputs 1.
    Nand,
    /// No input 1.
    Nor,
    /// An even number of inputs 1.
    Xnor,
    /// The input.
    Buf,
    /// The complement of the input.
    Not,
}

impl Gate {
    /// The gate of a Verilog keyword.
    #[must_use]
    pub fn from_keyword(keyword: &str) -> Option<Gate> {
        let all = [Gate::And, Gate::Or, Gate::Xor, Gate::Nand, Gate::Nor, Gate::Xnor, Gate::Buf, Gate::Not];
        all.into_iter().find(|gate| gate.keyword() == keyword)
    }

    /// Its Verilog keyword.
    #[must_use]
    pub fn keyword(self) -> &'static str {
        match self {
            Gate::And => "and",
            Gate::Or => "or",
            Gate::Xor => "xor",
            Gate::Nand => "nand",
            Gate::Nor => "nor",
            Gate::Xnor => "xnor",
            Gate::Buf => "buf",
            Gate::Not => "not",
        }
    }

    /// The gate with so many inputs (at least one; `buf` and `not` take just one), made of ops.
    #[must_use]
    pub fn body(self, inputs: usize) -> Body {
        let mut graph = Graph::default();
        let mut result = graph.push(Op::Input(0), 1);
        for input in 1..inputs {
            let next = graph.push(Op::Input(input as u32), 1);
            let op = match self {
                Gate::And | Gate::Nand => Op::And(result, next),
                Gate::Or | Gate::Nor => Op::Or(result, next),
                Gate::Xor | Gate::Xnor | Gate::Buf | Gate::Not => Op::Xor(result, next),
            };
            result = graph.push(op, 1);
        }
        if matches!(self, Gate::Nand | Gate::Nor | Gate::Xnor | Gate::Not) {
            result = graph.push(Op::Not(result), 1);
        }
        Body { graph, inputs: vec![1; inputs], outputs: vec![result], signals: Vec::new() }
    }
}
