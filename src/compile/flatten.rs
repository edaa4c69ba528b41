//! Flatten: every cell's ops into one graph, connections resolved bit by bit to who drives them.

use std::collections::HashMap;
use std::sync::Arc;

use super::{Observe, Owner, OwnerId, Program};
use crate::base::{Graph, Op, Port, Signal, ValueId};
use crate::blocks::Direction;
use crate::netlist::{Cell, CellKind, NetId, Netlist, Part, Source};

/// The program of a netlist, unordered and with copies.
pub(super) fn flatten(netlist: &Netlist, observe: &Observe<'_>) -> Program {
    let mut flat = Flattener {
        netlist,
        graph: Graph::default(),
        owner: Vec::new(),
        inputs: Vec::new(),
        cells: Vec::new(),
        known: HashMap::new(),
    };
    flat.place_inputs();
    flat.place_cells();
    flat.connect_cells();
    let inputs = netlist.inputs.iter().map(|&net| flat.port(net)).collect();
    let outputs = netlist.outputs.iter().map(|&net| flat.port(net)).collect();
    let signals = flat.signals(observe);
    let one_bit = |&output: &usize| observe.pulses && netlist.nets[netlist.outputs[output].index()].width == 1;
    let pulses = (0..netlist.outputs.len()).filter(one_bit).collect();
    let owners = netlist.scopes.iter().map(|scope| Owner {
        parent: scope.parent.map(|parent| OwnerId::new(parent.index())),
        module: Arc::clone(&scope.module),
    });
    let mut program = Program {
        owners: owners.collect(),
        inputs,
        outputs,
        pulses,
        signals,
        stop: None,
        graph: Graph::default(),
        owner: Vec::new(),
    };
    program.stop = observe.until.map(|until| {
        let value = flat.net(until.net);
        let high = flat.push(Op::ReduceOr(value), 1, OwnerId::new(0));
        if until.high { high } else { flat.push(Op::Not(high), 1, OwnerId::new(0)) }
    });
    (program.graph, program.owner) = (flat.graph, flat.owner);
    program
}

struct Flattener<'a> {
    netlist: &'a Netlist,
    graph: Graph,
    owner: Vec<OwnerId>,
    inputs: Vec<ValueId>,
    cells: Vec<PlacedCell>,
    known: HashMap<(NetId, u32, u32), ValueId>,
}

/// Where a cell's values are.
struct PlacedCell {
    wires: Vec<ValueId>,
    outputs: Vec<ValueId>,
    inner: Vec<ValueId>,
}

impl Flattener<'_> {
    fn push(&mut self, op: Op, width: u32, owner: OwnerId) -> ValueId {
        self.owner.push(owner);
        self.graph.push(op, width)
    }

    fn place_inputs(&mut self) {
        for (i, net) in self.netlist.inputs.iter().enumerate() {
            let width = self.netlist.nets[net.index()].width;
            let value = self.push(Op::Input(i as u32), width, OwnerId::new(0));
            self.inputs.push(value);
        }
    }

    /// Places every cell with wires for its inputs that are not connected yet, because a cell may read a later one.
    fn place_cells(&mut self) {
        for cell in &self.netlist.cells {
            let owner = OwnerId::new(cell.scope.index());
            let wires: Vec<_> = cell.body.inputs.iter().map(|&width| self.push(Op::Const(0), width, owner)).collect();
            let place = self.graph.append(&cell.body.graph, &wires);
            self.owner.resize(self.graph.nodes.len(), owner);
            let outputs = cell.body.outputs.iter().map(|&output| place(output)).collect();
            let inner = cell.body.signals.iter().map(|signal| place(signal.value)).collect();
            self.cells.push(PlacedCell { wires, outputs, inner });
        }
    }

    fn connect_cells(&mut self) {
        for (index, cell) in self.netlist.cells.iter().enumerate() {
            let owner = OwnerId::new(cell.scope.index());
            for (input, parts) in cell.inputs.iter().enumerate() {
                let values: Vec<_> = parts.iter().map(|part| self.part(*part, owner)).collect();
                let value = self.join(&values, owner);
                let wire = self.cells[index].wires[input];
                self.graph.nodes[wire.index()].op = Op::Copy(value);
            }
        }
    }

    fn part(&mut self, part: Part, owner: OwnerId) -> ValueId {
        match part {
            Part::Net { net, low, width } => self.bits(net, low, width),
            Part::Const { value, width } => self.push(Op::Const(value), width, owner),
        }
    }

    fn join(&mut self, parts: &[ValueId], owner: OwnerId) -> ValueId {
        let rest = parts[1..].iter();
        rest.fold(parts[0], |low, &high| {
            let width = self.graph.width(low) + self.graph.width(high);
            self.push(Op::Concat(high, low), width, owner)
        })
    }

    fn net(&mut self, net: NetId) -> ValueId {
        self.bits(net, 0, self.netlist.nets[net.index()].width)
    }

    /// The bits `low .. low + width` of a net, read only from those who drive just these bits, so that a vector
    /// whose bits depend on each other in order (a ripple carry) makes no loop.
    fn bits(&mut self, net: NetId, low: u32, width: u32) -> ValueId {
        if let Some(&value) = self.known.get(&(net, low, width)) {
            return value;
        }
        let netlist = self.netlist;
        let owner = OwnerId::new(netlist.nets[net.index()].scope.index());
        let mut parts = Vec::new();
        for drive in &netlist.nets[net.index()].roots {
            let first = low.max(drive.low);
            let end = (low + width).min(drive.low + drive.width);
            if first < end {
                parts.push(self.source(drive.source, first - drive.low, end - first, owner));
            }
        }
        let value = self.join(&parts, owner);
        self.known.insert((net, low, width), value);
        value
    }

    fn source(&mut self, source: Source, offset: u32, width: u32, owner: OwnerId) -> ValueId {
        match source {
            Source::Input { input, low } => self.slice(self.inputs[input as usize], low + offset, width, owner),
            Source::Cell { cell, output, low } => {
                let value = self.cells[cell.index()].outputs[output as usize];
                self.slice(value, low + offset, width, owner)
            }
            // Never in a root (invariant 7 of the netlist).
            Source::Net { net, low } => self.bits(net, low + offset, width),
            Source::Const(value) => {
                let bits = value.checked_shr(offset).unwrap_or(0) & crate::base::word::mask(width);
                self.push(Op::Const(bits), width, owner)
            }
        }
    }

    fn slice(&mut self, value: ValueId, low: u32, width: u32, owner: OwnerId) -> ValueId {
        if self.graph.width(value) == width { value } else { self.push(Op::Slice(value, low), width, owner) }
    }

    fn port(&mut self, net: NetId) -> Port {
        let value = self.net(net);
        let net = &self.netlist.nets[net.index()];
        Port { name: net.name.clone(), width: net.width, signed: net.signed, fraction: net.fraction, value }
    }

    /// The observed signals in the order of the text: a scope's nets, then what stands inside it.
    fn signals(&mut self, observe: &Observe<'_>) -> Vec<Signal> {
        let netlist = self.netlist;
        let mut all = Vec::new();
        let paths: Vec<Vec<String>> =
            (0..netlist.scopes.len()).map(|i| netlist.path(crate::netlist::ScopeId::new(i))).collect();
        let wanted = |path: &[String]| (observe.signals)(&path[1..].join("."));
        for (i, net) in netlist.nets.iter().enumerate() {
            let path: Vec<_> = paths[net.scope.index()].iter().cloned().chain([net.name.clone()]).collect();
            if !net.is_clock && wanted(&path) {
                let value = self.net(NetId::new(i));
                all.push(Signal { path, width: net.width, signed: net.signed, fraction: net.fraction, value });
            }
        }
        for (i, cell) in netlist.cells.iter().enumerate() {
            if let CellKind::Block { .. } = cell.kind {
                for (name, signed, value) in cell_signals(cell, &self.cells[i]) {
                    let prefix = paths[cell.scope.index()].iter().cloned().chain([cell.name.clone()]);
                    let path: Vec<_> = prefix.chain(name).collect();
                    if wanted(&path) {
                        let width = self.graph.width(value);
                        all.push(Signal { path, width, signed, fraction: None, value });
                    }
                }
            }
        }
        all
    }
}

/// Ports and inner signals of a block instance. An inner signal that has a port's name adds nothing.
fn cell_signals(cell: &Cell, placed: &PlacedCell) -> Vec<(Vec<String>, bool, ValueId)> {
    let mut all = Vec::new();
    for (direction, values) in [(Direction::Input, &placed.wires), (Direction::Output, &placed.outputs)] {
        for (port, &value) in cell.ports(direction).into_iter().zip(values) {
            all.push((vec![port.name], port.signed, value));
        }
    }
    for (signal, &value) in cell.body.signals.iter().zip(&placed.inner) {
        all.push((signal.path.clone(), signal.signed, value));
    }
    all
}
