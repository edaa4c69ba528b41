//! Circuits as text: what is read, what is refused, and that nothing breaks the reader.

mod bad_input;
mod constants;
mod constructs;
mod limits;
mod properties;

use stepwright::netlist::{Netlist, Part, Source};

use crate::support::load_text;

/// Loads a text that must be right.
fn good(text: &str) -> Netlist {
    load_text(text).unwrap_or_else(|report| panic!("{report}"))
}

/// The codes of a text that must be wrong, in order of place.
fn codes(text: &str) -> Vec<&'static str> {
    load_text(text).expect_err("an error").diagnostics.iter().map(|diagnostic| diagnostic.code).collect()
}

/// The parameters of the top module with their values.
fn values(netlist: &Netlist) -> Vec<(String, i64)> {
    netlist.parameters.iter().map(|one| (one.name.clone(), one.value)).collect()
}

/// What drives a net, highest bits first, as Verilog would write it.
fn roots(netlist: &Netlist, net: &str) -> String {
    let net = netlist.nets.iter().zip(0..).find(|(_, place)| netlist.net_name(net_id(*place)) == net);
    let (net, _) = net.unwrap_or_else(|| panic!("no such net"));
    let root = |drive: &stepwright::netlist::Drive| {
        let bits = |low: u32| match drive.width {
            1 => format!("[{low}]"),
            width => format!("[{}:{low}]", low + width - 1),
        };
        match drive.source {
            Source::Input { input, low } => {
                format!("{}{}", netlist.nets[netlist.inputs[input as usize].index()].name, bits(low))
            }
            Source::Cell { cell, low, .. } => format!("{}{}", netlist.cells[cell.index()].name, bits(low)),
            Source::Const(value) => format!("{}'d{value}", drive.width),
            Source::Net { .. } => "a net".to_owned(),
        }
    };
    net.roots.iter().rev().map(root).collect::<Vec<_>>().join(" ")
}

fn net_id(place: usize) -> stepwright::netlist::NetId {
    stepwright::netlist::NetId::new(place)
}

/// The nets that a cell's input reads, highest first.
fn read_by(netlist: &Netlist, cell: &str, input: usize) -> Vec<String> {
    let cell = netlist.cells.iter().find(|known| known.name == cell).expect("a cell");
    let name = |part: &Part| match *part {
        Part::Net { net, low, width } => format!("{}[{}:{low}]", netlist.net_name(net), low + width - 1),
        Part::Const { value, width } => format!("{width}'d{value}"),
    };
    cell.inputs[input].iter().rev().map(name).collect()
}
