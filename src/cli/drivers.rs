//! Who drives whom in a netlist, by the names of its waveform: for walking back from a difference to its cause.

use std::collections::HashMap;

use crate::blocks::Direction;
use crate::compile;
use crate::golden::{Driven, Driver, Drivers};
use crate::netlist::{Cell, CellKind, Net, NetId, Netlist, Part, Source};

/// The drivers of every net, of every port of a block, and of what is inside it, which is as good as its inputs.
pub(super) fn drivers(netlist: &Netlist) -> Drivers {
    let (mut all, mut insides) = (Drivers::new(), HashMap::new());
    for net in netlist.nets.iter().filter(|net| !net.is_clock) {
        let (by, place) = (net_drivers(netlist, net), net_place(netlist, net));
        all.insert(name_of(netlist, net), Driven { by, place, is_net: true });
    }
    for cell in netlist.cells.iter().filter(|cell| matches!(cell.kind, CellKind::Block { .. })) {
        all.extend(port_drivers(netlist, cell));
        insides.insert(port_path(netlist, cell), inside(netlist, cell));
    }
    for signal in compile::signals(netlist) {
        let cell = (1..signal.path.len()).rev().find_map(|length| insides.get(&signal.path[..length]));
        if let Some(driven) = cell {
            all.entry(signal.path.join(".")).or_insert_with(|| driven.clone());
        }
    }
    all
}

/// What a value inside a block is driven by: the inputs, now or before.
fn inside(netlist: &Netlist, cell: &Cell) -> Driven {
    let inputs = cell.ports(Direction::Input);
    let names = inputs.iter().map(|port| port_name(netlist, cell, &port.name));
    let by = names.flat_map(|net| [false, true].map(|delayed| Driver { net: net.clone(), delayed }));
    Driven { by: by.collect(), place: cell_place(netlist, cell), is_net: false }
}

fn name_of(netlist: &Netlist, net: &Net) -> String {
    let mut path = netlist.path(net.scope);
    path.push(net.name.clone());
    path.join(".")
}

fn port_path(netlist: &Netlist, cell: &Cell) -> Vec<String> {
    let mut path = netlist.path(cell.scope);
    path.push(cell.name.clone());
    path
}

fn port_name(netlist: &Netlist, cell: &Cell, port: &str) -> String {
    format!("{}.{port}", port_path(netlist, cell).join("."))
}

fn at_once(net: String) -> Driver {
    Driver { net, delayed: false }
}

fn net_drivers(netlist: &Netlist, net: &Net) -> Vec<Driver> {
    let mut by = Vec::new();
    for drive in &net.drives {
        match drive.source {
            Source::Net { net, .. } => by.push(at_once(name_of(netlist, &netlist.nets[net.index()]))),
            Source::Cell { cell, output, .. } => {
                let cell = &netlist.cells[cell.index()];
                match cell.kind {
                    CellKind::Block { .. } => {
                        let port = &cell.ports(Direction::Output)[output as usize];
                        by.push(at_once(port_name(netlist, cell, &port.name)));
                    }
                    CellKind::Gate(_) => by.extend(cell.inputs.iter().flat_map(|parts| read_by(netlist, parts))),
                }
            }
            Source::Input { .. } | Source::Const(_) => {}
        }
    }
    by
}

fn read_by<'n>(netlist: &'n Netlist, parts: &'n [Part]) -> impl Iterator<Item = Driver> + 'n {
    parts.iter().filter_map(|part| match part {
        Part::Net { net, .. } => Some(at_once(name_of(netlist, &netlist.nets[NetId::index(*net)]))),
        Part::Const { .. } => None,
    })
}

fn net_place(netlist: &Netlist, net: &Net) -> String {
    let gate = net.drives.iter().find_map(|drive| match drive.source {
        Source::Cell { cell, .. } => Some(&netlist.cells[cell.index()]),
        _ => None,
    });
    match gate {
        Some(cell) => cell_place(netlist, cell),
        None => netlist.sources.place(net.span),
    }
}

/// Instance, block, where it stands, and the figure it comes from.
fn cell_place(netlist: &Netlist, cell: &Cell) -> String {
    let place = netlist.sources.place(cell.span);
    match &cell.kind {
        CellKind::Block { block, .. } => {
            let block = block.description();
            format!("{}, a `{}` at {place} ({})", cell.name, block.name, block.source)
        }
        CellKind::Gate(gate) => format!("{}, an `{}` gate at {place}", cell.name, gate.keyword()),
    }
}

fn port_drivers(netlist: &Netlist, cell: &Cell) -> Vec<(String, Driven)> {
    let inputs = cell.ports(Direction::Input);
    let place = cell_place(netlist, cell);
    let mut all = Vec::new();
    for (port, parts) in inputs.iter().zip(&cell.inputs) {
        let by = read_by(netlist, parts).collect();
        all.push((port_name(netlist, cell, &port.name), Driven { by, place: place.clone(), is_net: false }));
    }
    let has_state = !cell.body.graph.registers.is_empty() || !cell.body.graph.rams.is_empty();
    for (port, edges) in cell.ports(Direction::Output).iter().zip(cell.body.combinational_edges()) {
        let mut by = Vec::new();
        for (input, combinational) in inputs.iter().zip(edges) {
            let net = port_name(netlist, cell, &input.name);
            by.extend(combinational.then(|| at_once(net.clone())));
            by.extend(has_state.then_some(Driver { net, delayed: true }));
        }
        all.push((port_name(netlist, cell, &port.name), Driven { by, place: place.clone(), is_net: false }));
    }
    all
}
