//! What a tracer may see of a circuit: named values with a width and a way to read them.

use super::graph::ValueId;

/// An input or output of the top module.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Port {
    /// Its name in the circuit file.
    pub name: String,
    /// Width in bits.
    pub width: u32,
    /// Whether its word is two's complement.
    pub signed: bool,
    /// Fraction bits of a fixed-point word (attribute `(* fraction = N *)`).
    pub fraction: Option<u32>,
    /// Where its value is.
    pub value: ValueId,
}

/// A net, or a named value inside a block, that can be traced.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Signal {
    /// Scopes from the top module inwards, then the net: `["interpolator", "counter_14", "count"]`.
    pub path: Vec<String>,
    /// Width in bits.
    pub width: u32,
    /// Whether its word is two's complement.
    pub signed: bool,
    /// Fraction bits of a fixed-point word.
    pub fraction: Option<u32>,
    /// Where its value is. Aliases share one value.
    pub value: ValueId,
}

impl Signal {
    /// The path below the top module, with dots: `counter_14.count`.
    #[must_use]
    pub fn name(&self) -> String {
        self.path[1..].join(".")
    }
}

/// A rising edge on a line of one bit.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Edge {
    /// The first tick in which the line is high.
    pub tick: u32,
    /// Which of the lines that are looked at.
    pub pulse: u32,
}
