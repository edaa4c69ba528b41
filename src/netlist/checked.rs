//! The checked netlist: the flat form that everything after it trusts.
//!
//! Invariants (numbered; the checks of this room establish them, nothing later tests them again):
//!
//! 1. Every bit of every net that is not a clock is driven exactly once (`Net::drives` cover `0..width`, low first).
//! 2. Widths agree: a connection has just the bits of its port.
//! 3. No combinational loop, judged by [`Body::combinational_edges`] and by the bits that nets route.
//! 4. Every cell's parameters are in range and accepted by its block; words are 1 to 64 bits.
//! 5. `clk` nets reach only `clk` ports.
//! 6. Scope 0 is the top module; a scope comes after its parent, and stands at most 64 deep.
//! 7. `Net::roots` are `Net::drives` with nets that only pass bits on followed to their end: none is a [`Source::Net`].

use std::sync::Arc;

use crate::base::{Sources, Span};
use crate::blocks::{Block, Body, Direction, Gate, Parameters};

crate::define_id!(
    /// A module instance.
    ScopeId
);
crate::define_id!(
    /// A net of one module instance.
    NetId
);
crate::define_id!(
    /// A block or gate instance.
    CellId
);

/// A checked netlist.
#[derive(Clone, Debug)]
pub struct Netlist {
    /// The circuit's texts, for messages that come later.
    pub sources: Arc<Sources>,
    /// Module instances.
    pub scopes: Vec<Scope>,
    /// Nets, those of a scope in the order of its text.
    pub nets: Vec<Net>,
    /// Blocks and gates, in the order of the text.
    pub cells: Vec<Cell>,
    /// Parameters of the top module, with the values in force.
    pub parameters: Vec<TopParameter>,
    /// Those of them that were given and not left at their defaults.
    pub given: Vec<(String, i64)>,
    /// Input nets of the top module in order of its header, without the clock.
    pub inputs: Vec<NetId>,
    /// Output nets of the top module in order of its header.
    pub outputs: Vec<NetId>,
}

/// A parameter of the top module.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct TopParameter {
    /// Its name.
    pub name: String,
    /// The value in force.
    pub value: i64,
    /// The least value that its module states.
    pub least: Option<i64>,
    /// The greatest value that its module states.
    pub most: Option<i64>,
}

/// A module instance, or a turn of a generate loop in one.
#[derive(Clone, Debug)]
pub struct Scope {
    /// Instance name; for the top, the module's name; for a turn of a loop, `label[2]`.
    pub name: String,
    /// Enclosing instance; `None` for the top.
    pub parent: Option<ScopeId>,
    /// Module name; for a turn of a loop, that of the module around it, a dot and the label. Shared by all such scopes.
    pub module: Arc<str>,
    /// Where it is instantiated.
    pub span: Span,
}

/// A net.
#[derive(Clone, Debug)]
pub struct Net {
    /// Module instance it belongs to.
    pub scope: ScopeId,
    /// Name in its module.
    pub name: String,
    /// Bits.
    pub width: u32,
    /// Whether its word is two's complement.
    pub signed: bool,
    /// Fraction bits, from the attribute `(* fraction = N *)`.
    pub fraction: Option<u32>,
    /// Whether it is a port of its module, and which way it goes.
    pub port: Option<Direction>,
    /// The clock: driven by nobody, traced by nobody.
    pub is_clock: bool,
    /// What drives it, low bits first (empty for a clock).
    pub drives: Vec<Drive>,
    /// The same, followed through other nets to an input, a cell or a constant.
    pub roots: Vec<Drive>,
    /// Where it is declared.
    pub span: Span,
}

/// What drives some bits of a net.
#[derive(Clone, Debug)]
pub struct Drive {
    /// First bit driven.
    pub low: u32,
    /// How many bits.
    pub width: u32,
    /// By what.
    pub source: Source,
    /// Where that is written.
    pub span: Span,
}

/// Where bits come from.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Source {
    /// From outside: bits of an input of the top module, from `low` on.
    Input {
        /// Which of [`Netlist::inputs`].
        input: u32,
        /// First bit of the input.
        low: u32,
    },
    /// From a cell's output, bits from `low` on.
    Cell {
        /// The cell.
        cell: CellId,
        /// Which of its outputs.
        output: u32,
        /// First bit of the output.
        low: u32,
    },
    /// From bits of another net (an `assign`, or a port connection).
    Net {
        /// The net.
        net: NetId,
        /// Its first bit.
        low: u32,
    },
    /// A constant.
    Const(u64),
}

/// Some bits of a net, or a constant, read by a cell.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Part {
    /// Bits of a net.
    Net {
        /// The net.
        net: NetId,
        /// Its first bit.
        low: u32,
        /// How many bits.
        width: u32,
    },
    /// A constant.
    Const {
        /// Its value.
        value: u64,
        /// How many bits.
        width: u32,
    },
}

/// A block or gate instance.
#[derive(Clone, Debug)]
pub struct Cell {
    /// Module instance it stands in.
    pub scope: ScopeId,
    /// Instance name.
    pub name: String,
    /// What it is.
    pub kind: CellKind,
    /// For each input port in order: its bits, low first.
    pub inputs: Vec<Vec<Part>>,
    /// It, made of ops. Shared by all cells of equal kind and parameters.
    pub body: Arc<Body>,
    /// Where it is instantiated.
    pub span: Span,
}

/// What a cell is.
#[derive(Clone, Debug)]
pub enum CellKind {
    /// A block of the registry.
    Block {
        /// The block.
        block: &'static Block,
        /// Its parameters.
        parameters: Parameters,
    },
    /// A gate primitive.
    Gate(Gate),
}

/// A port of a cell, for messages and waveforms.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct PortOf {
    /// Its name; a gate's are `out`, `in0`, `in1`, ...
    pub name: String,
    /// Whether its word is two's complement.
    pub signed: bool,
}

impl Netlist {
    /// A scope's instance names from the top down.
    #[must_use]
    pub fn path(&self, scope: ScopeId) -> Vec<String> {
        let scope = &self.scopes[scope.index()];
        let mut path = scope.parent.map_or_else(Vec::new, |parent| self.path(parent));
        path.push(scope.name.clone());
        path
    }

    /// The name of a net below the top module, with dots.
    #[must_use]
    pub fn net_name(&self, net: NetId) -> String {
        let net = &self.nets[net.index()];
        let mut path = self.path(net.scope);
        path.push(net.name.clone());
        path[1..].join(".")
    }

    /// A net of the top module.
    #[must_use]
    pub fn top_net(&self, name: &str) -> Option<NetId> {
        self.nets.iter().position(|net| net.scope.index() == 0 && net.name == name).map(NetId::new)
    }
}

impl Cell {
    /// The ports of one direction, in the order of [`Body::inputs`] or [`Body::outputs`].
    #[must_use]
    pub fn ports(&self, direction: Direction) -> Vec<PortOf> {
        match &self.kind {
            CellKind::Block { block, .. } => {
                let ports = block.description().ports_of(direction);
                ports.map(|port| PortOf { name: port.name.to_owned(), signed: port.signed }).collect()
            }
            CellKind::Gate(_) if direction == Direction::Output => vec![PortOf { name: "out".into(), signed: false }],
            CellKind::Gate(_) => {
                let names = (0..self.inputs.len()).map(|i| format!("in{i}"));
                names.map(|name| PortOf { name, signed: false }).collect()
            }
        }
    }

    /// The module name: the block's, or the gate's keyword.
    #[must_use]
    pub fn module(&self) -> &'static str {
        match &self.kind {
            CellKind::Block { block, .. } => block.description().name,
            CellKind::Gate(gate) => gate.keyword(),
        }
    }
}
