//! The instances of a module and what they connect, read off a netlist.

use std::collections::HashMap;

use crate::blocks::Direction;
use crate::netlist::{Cell, CellId, CellKind, Drive, NetId, Netlist, Part, PortOf, ScopeId, Source};

/// An instance of a module, block or gate, or a turn of a generate loop.
pub(super) struct Instance {
    /// Its name in the module it stands in.
    pub name: String,
    /// What it is an instance of.
    pub of: String,
    /// A block's parameters with the values in force; a netlist does not keep those of a module.
    pub parameters: Vec<(String, i64)>,
    /// Its ports, without the clock.
    pub ports: Vec<Port>,
    /// File, line and column.
    pub place: String,
}

/// A port of an instance.
pub(super) struct Port {
    pub name: String,
    pub direction: Direction,
    pub width: u32,
    pub signed: bool,
    /// The nets it is connected to; of an output that is used in pieces, each.
    pub nets: String,
}

/// A scope or cell that has been found by its path.
#[derive(Clone, Copy)]
pub(super) enum Found {
    Scope(ScopeId),
    Cell(CellId),
}

/// The instance of a dotted path below the top module.
pub(super) fn find(netlist: &Netlist, path: &str) -> Option<Found> {
    let dotted = |scope: ScopeId, name: &str| {
        let mut whole = netlist.path(scope);
        whole.push(name.to_owned());
        whole[1..].join(".")
    };
    let scopes = (1..netlist.scopes.len()).map(ScopeId::new);
    let mut scopes = scopes.filter(|id| netlist.path(*id)[1..].join(".") == path);
    let cells = || (0..netlist.cells.len()).map(CellId::new);
    let is_it = |id: &CellId| {
        let cell = &netlist.cells[id.index()];
        dotted(cell.scope, &cell.name) == path
    };
    scopes.next().map(Found::Scope).or_else(|| cells().find(is_it).map(Found::Cell))
}

/// The paths of all instances.
pub(in crate::cli) fn paths(netlist: &Netlist) -> Vec<String> {
    let scopes = (1..netlist.scopes.len()).map(|scope| netlist.path(ScopeId::new(scope)));
    let cells = netlist.cells.iter().map(|cell| {
        let mut path = netlist.path(cell.scope);
        path.push(cell.name.clone());
        path
    });
    scopes.chain(cells).map(|path| path[1..].join(".")).collect()
}

/// What gives its value to bits of nets.
#[derive(PartialEq, Eq, Hash)]
enum Giver {
    Cell(CellId, u32),
    Net(NetId),
}

/// A netlist, and the bits that each cell and net drives.
pub(super) struct Wiring<'n> {
    netlist: &'n Netlist,
    driven: HashMap<Giver, Vec<(NetId, u32, u32)>>,
}

impl<'n> Wiring<'n> {
    pub fn of(netlist: &'n Netlist) -> Self {
        let mut driven: HashMap<_, Vec<_>> = HashMap::new();
        for (id, net) in netlist.nets.iter().enumerate() {
            for drive in &net.drives {
                let giver = match drive.source {
                    Source::Cell { cell, output, .. } => Giver::Cell(cell, output),
                    Source::Net { net, .. } => Giver::Net(net),
                    Source::Input { .. } | Source::Const(_) => continue,
                };
                driven.entry(giver).or_default().push((NetId::new(id), drive.low, drive.width));
            }
        }
        Self { netlist, driven }
    }

    /// The instances in a module, in the order of its text.
    pub fn instances(&self, scope: ScopeId) -> Vec<Instance> {
        let Netlist { scopes, cells, .. } = self.netlist;
        let inner = (0..scopes.len()).filter(|&id| scopes[id].parent == Some(scope));
        let mut all: Vec<_> = inner.map(|id| (scopes[id].span, Found::Scope(ScopeId::new(id)))).collect();
        let cells_of = (0..cells.len()).filter(|&id| cells[id].scope == scope);
        all.extend(cells_of.map(|id| (cells[id].span, Found::Cell(CellId::new(id)))));
        all.sort_by_key(|(span, _)| *span);
        all.into_iter().map(|(_, found)| self.instance(found)).collect()
    }

    /// An instance with its connections.
    pub fn instance(&self, found: Found) -> Instance {
        let netlist = self.netlist;
        match found {
            Found::Scope(id) => {
                let scope = &netlist.scopes[id.index()];
                Instance {
                    name: scope.name.clone(),
                    of: scope.module.to_string(),
                    parameters: Vec::new(),
                    ports: self.ports_of_scope(id),
                    place: netlist.sources.place(scope.span),
                }
            }
            Found::Cell(id) => {
                let cell = &netlist.cells[id.index()];
                let parameters = match &cell.kind {
                    CellKind::Block { parameters, .. } => parameters.iter().map(|(n, v)| (n.to_owned(), v)).collect(),
                    CellKind::Gate(_) => Vec::new(),
                };
                Instance {
                    name: cell.name.clone(),
                    of: cell.module().to_owned(),
                    parameters,
                    ports: self.ports_of_cell(id, cell),
                    place: netlist.sources.place(cell.span),
                }
            }
        }
    }

    fn ports_of_cell(&self, id: CellId, cell: &Cell) -> Vec<Port> {
        let near = Near { netlist: self.netlist, scope: cell.scope };
        let port = |port: PortOf, direction, width, nets| {
            let PortOf { name, signed } = port;
            Port { name, direction, width, signed, nets }
        };
        let inputs = cell.ports(Direction::Input).into_iter().zip(&cell.body.inputs).zip(&cell.inputs);
        let inputs = inputs.map(|((of, &width), parts)| port(of, Direction::Input, width, near.parts(parts)));
        let outputs = cell.ports(Direction::Output).into_iter().zip(&cell.body.outputs).zip(0..);
        let outputs = outputs.map(|((of, &value), place)| {
            let nets = self.driven(&near, Giver::Cell(id, place));
            port(of, Direction::Output, cell.body.graph.width(value), nets)
        });
        inputs.chain(outputs).collect()
    }

    fn ports_of_scope(&self, id: ScopeId) -> Vec<Port> {
        let netlist = self.netlist;
        let near = Near { netlist, scope: netlist.scopes[id.index()].parent.unwrap_or(id) };
        let nets = netlist.nets.iter().enumerate().filter(|(_, net)| net.scope == id && !net.is_clock);
        let ports = nets.filter_map(|(place, net)| Some((NetId::new(place), net, net.port?)));
        let with_nets = ports.map(|(place, net, direction)| Port {
            name: net.name.clone(),
            direction,
            width: net.width,
            signed: net.signed,
            nets: match direction {
                Direction::Input => near.drives(&net.drives),
                Direction::Output => self.driven(&near, Giver::Net(place)),
            },
        });
        with_nets.collect()
    }

    /// The nets that something drives.
    fn driven(&self, near: &Near<'_>, by: Giver) -> String {
        let bits = self.driven.get(&by).into_iter().flatten();
        bits.map(|&(net, low, width)| near.name(net, low, width)).collect::<Vec<_>>().join(", ")
    }
}

/// Names of nets as they are read in a module.
struct Near<'n> {
    netlist: &'n Netlist,
    scope: ScopeId,
}

impl Near<'_> {
    /// The name of a net, in Verilog's way when it is not the whole of it.
    fn name(&self, id: NetId, low: u32, width: u32) -> String {
        let net = &self.netlist.nets[id.index()];
        let name = if net.scope == self.scope { net.name.clone() } else { self.netlist.net_name(id) };
        match (width == net.width, width) {
            (true, _) => name,
            (false, 1) => format!("{name}[{low}]"),
            (false, _) => format!("{name}[{}:{low}]", low + width - 1),
        }
    }

    fn parts(&self, parts: &[Part]) -> String {
        joined(parts.iter().map(|part| match *part {
            Part::Net { net, low, width } => self.name(net, low, width),
            Part::Const { value, width } => format!("{width}'d{value}"),
        }))
    }

    fn drives(&self, drives: &[Drive]) -> String {
        joined(drives.iter().map(|drive| match drive.source {
            Source::Net { net, low } => self.name(net, low, drive.width),
            Source::Const(value) => format!("{}'d{value}", drive.width),
            Source::Cell { cell, .. } => self.netlist.cells[cell.index()].name.clone(),
            Source::Input { input, low } => self.name(self.netlist.inputs[input as usize], low, drive.width),
        }))
    }
}

/// Pieces, low ones first, as a Verilog concatenation.
fn joined(pieces: impl Iterator<Item = String>) -> String {
    let mut pieces: Vec<_> = pieces.collect();
    pieces.reverse();
    match pieces.as_slice() {
        [one] => one.clone(),
        all => format!("{{{}}}", all.join(", ")),
    }
}
