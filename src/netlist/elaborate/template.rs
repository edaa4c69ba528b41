//! Templates: a module elaborated once for one set of parameters, with nets and cells numbered from 0.
//! However often it is instantiated, its text is read and its errors are told once.

use std::sync::Arc;

use super::constant::Const;
use crate::base::Span;
use crate::blocks::{Body, Direction};
use crate::netlist::checked::{CellKind, TopParameter};
use crate::netlist::syntax::Module;

crate::define_id!(
    /// A module with its parameters.
    TemplateId
);

/// A module for one set of parameters.
#[derive(Debug)]
pub(in crate::netlist) struct Template<'t> {
    pub(in crate::netlist) module: &'t Module,
    /// Parameters (not localparams) in order, with the values in force.
    pub(in crate::netlist) parameters: Vec<TopParameter>,
    /// The module itself, then its generate blocks; a block comes after the one around it.
    pub(in crate::netlist) scopes: Vec<LocalScope>,
    /// The ports in order of the header, then the other nets.
    pub(in crate::netlist) nets: Vec<LocalNet>,
    /// How many of the nets are ports.
    pub(in crate::netlist) ports: usize,
    pub(in crate::netlist) cells: Vec<LocalCell>,
    pub(in crate::netlist) instances: Vec<LocalInstance>,
}

/// The module itself (without a parent) or a turn of a generate loop.
#[derive(Debug)]
pub(in crate::netlist) struct LocalScope {
    pub(in crate::netlist) parent: Option<u32>,
    pub(in crate::netlist) name: String,
    pub(in crate::netlist) module: Arc<str>,
    pub(in crate::netlist) span: Span,
}

/// A net.
#[derive(Debug)]
pub(in crate::netlist) struct LocalNet {
    pub(in crate::netlist) scope: u32,
    pub(in crate::netlist) name: String,
    pub(in crate::netlist) width: u32,
    /// The index of its lowest bit.
    pub(in crate::netlist) lsb: i64,
    /// Whether it was declared with a range, so that bits of it can be selected.
    pub(in crate::netlist) is_vector: bool,
    pub(in crate::netlist) signed: bool,
    pub(in crate::netlist) fraction: Option<u32>,
    pub(in crate::netlist) port: Option<Direction>,
    pub(in crate::netlist) is_clock: bool,
    pub(in crate::netlist) drives: Vec<LocalDrive>,
    pub(in crate::netlist) span: Span,
}

impl LocalNet {
    /// The name of some of its bits, as the text would say it.
    pub(in crate::netlist) fn bits(&self, low: u32, width: u32) -> String {
        let at = |bit: u32| self.lsb.saturating_add(bit.into());
        match (self.is_vector, width) {
            (false, _) => self.name.clone(),
            (true, 1) => format!("{}[{}]", self.name, at(low)),
            (true, _) => format!("{}[{}:{}]", self.name, at(low + width - 1), at(low)),
        }
    }
}

/// What drives some bits of a net.
#[derive(Clone, Copy, Debug)]
pub(in crate::netlist) struct LocalDrive {
    pub(in crate::netlist) low: u32,
    pub(in crate::netlist) width: u32,
    pub(in crate::netlist) source: LocalSource,
    pub(in crate::netlist) span: Span,
}

/// Where bits come from.
#[derive(Clone, Copy, Debug)]
pub(in crate::netlist) enum LocalSource {
    /// Whoever instantiates the module.
    Outside,
    Cell {
        cell: u32,
        output: u32,
        low: u32,
    },
    /// A port of an instance.
    Instance {
        instance: u32,
        port: u32,
        low: u32,
    },
    Net {
        net: u32,
        low: u32,
    },
    Const(u64),
    /// Something whose error has been told.
    Wrong,
}

impl LocalSource {
    /// The same from `bits` further up.
    pub(in crate::netlist) fn above(self, bits: u32) -> Self {
        match self {
            Self::Outside | Self::Wrong => self,
            Self::Cell { cell, output, low } => Self::Cell { cell, output, low: low + bits },
            Self::Instance { instance, port, low } => Self::Instance { instance, port, low: low + bits },
            Self::Net { net, low } => Self::Net { net, low: low + bits },
            Self::Const(value) => Self::Const(value.checked_shr(bits).unwrap_or(0)),
        }
    }
}

/// Some bits that a connection names.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(in crate::netlist) enum Piece {
    Net { net: u32, low: u32, width: u32 },
    Const { value: u64, width: u32 },
}

impl Piece {
    pub(in crate::netlist) fn width(self) -> u32 {
        match self {
            Self::Net { width, .. } | Self::Const { width, .. } => width,
        }
    }
}

/// A block or gate.
#[derive(Debug)]
pub(in crate::netlist) struct LocalCell {
    pub(in crate::netlist) scope: u32,
    pub(in crate::netlist) name: String,
    pub(in crate::netlist) kind: CellKind,
    pub(in crate::netlist) inputs: Vec<Vec<Piece>>,
    pub(in crate::netlist) body: Arc<Body>,
    pub(in crate::netlist) span: Span,
}

/// An instance of a module.
#[derive(Debug)]
pub(in crate::netlist) struct LocalInstance {
    pub(in crate::netlist) scope: u32,
    pub(in crate::netlist) name: String,
    pub(in crate::netlist) template: TemplateId,
    /// For each port of the template, what drives it if it is an input, and where that is written.
    pub(in crate::netlist) inputs: Vec<(Vec<Piece>, Span)>,
    pub(in crate::netlist) span: Span,
}

/// A parameter of an instance, with the place of its value.
#[derive(Clone, Debug)]
pub(super) struct Override<'t> {
    pub(super) name: &'t str,
    pub(super) value: Const,
    pub(super) span: Option<Span>,
}

/// A port of a template, as its instances see it.
#[derive(Debug)]
pub(super) struct TemplatePort {
    pub(super) name: String,
    pub(super) kind: PortKind,
    pub(super) width: u32,
    pub(super) span: Span,
}

/// What a port is for.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum PortKind {
    Clock,
    Input,
    Output,
}

impl TemplatePort {
    pub(super) fn of(net: &LocalNet) -> Self {
        let kind = match net.port {
            _ if net.is_clock => PortKind::Clock,
            Some(Direction::Input) => PortKind::Input,
            _ => PortKind::Output,
        };
        TemplatePort { name: net.name.clone(), kind, width: net.width, span: net.span }
    }
}
