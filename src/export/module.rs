//! Modules: each block in use as a Verilog module, with a branch for each set of parameters in use.

use std::collections::HashSet;
use std::sync::Arc;

use super::body::body;
use super::page::Page;
use crate::blocks::{Block, Body, Description, Direction, Parameters, PortDescription, Width};
use crate::netlist::{CellKind, Netlist};

/// The name of the `generate` branch that a block with parameters has its inside in: one more scope in the waveforms
/// of other simulators than in ours.
pub const BRANCH: &str = "specialised";

/// A block for one set of parameters.
#[derive(Clone, Debug)]
pub struct Specialisation {
    /// The block.
    pub block: &'static dyn Block,
    /// The parameters.
    pub parameters: Parameters,
    /// It, made of ops for them.
    pub body: Arc<Body>,
}

/// Every block and set of parameters that the netlists use, each once, in order of first use.
#[must_use]
pub fn specialisations<'a>(netlists: impl IntoIterator<Item = &'a Netlist>) -> Vec<Specialisation> {
    let mut all: Vec<Specialisation> = Vec::new();
    let mut seen = HashSet::new();
    for cell in netlists.into_iter().flat_map(|netlist| &netlist.cells) {
        if let CellKind::Block { block, parameters } = &cell.kind
            && seen.insert((block.description().name, parameters.clone()))
        {
            all.push(Specialisation { block: *block, parameters: parameters.clone(), body: Arc::clone(&cell.body) });
        }
    }
    all
}

/// The text of a Verilog-2005 file with a module for every block that the netlists use. Beside it the circuit files
/// of these netlists, with the parameters they were read with, compile unchanged.
#[must_use]
pub fn verilog<'a>(netlists: impl IntoIterator<Item = &'a Netlist>) -> String {
    print(&specialisations(netlists))
}

/// The text of a Verilog-2005 file with a module for every block among `specialisations`, in order of first use.
#[must_use]
pub fn print(specialisations: &[Specialisation]) -> String {
    let mut page = Page::default();
    page.line("// The blocks of a Stepwright circuit, printed from their ops.");
    page.line("// A word named _op, _in or _state is an op, an input or a register of its block.");
    page.line("`default_nettype none");
    let mut printed = HashSet::new();
    for description in specialisations.iter().map(|s| s.block.description()) {
        if printed.insert(description.name) {
            let of_block = specialisations.iter().filter(|s| s.block.description().name == description.name);
            page.line("");
            module(&mut page, description, &of_block.collect::<Vec<_>>());
        }
    }
    page.finish()
}

fn module(page: &mut Page, description: &Description, specialisations: &[&Specialisation]) {
    page.line(format!("// {}", description.summary));
    page.line(format!("// Source: {}", description.source));
    let parameters = description.parameters.iter().map(|p| format!("parameter {} = {}", p.name, number(p.default)));
    let parameters: Vec<_> = parameters.collect();
    if parameters.is_empty() {
        page.line(format!("module {} (", description.name));
    } else {
        page.block(format!("module {} #(", description.name), ") (", |page| list(page, &parameters));
    }
    let clock = description.clocked.then(|| "input wire clk".to_owned());
    let ports: Vec<_> = clock.into_iter().chain(description.ports.iter().map(port)).collect();
    page.rest(");", |page| list(page, &ports));
    page.rest("endmodule", |page| match specialisations {
        [only] if parameters.is_empty() => body(page, description, &only.body),
        _ => branches(page, description, specialisations),
    });
}

fn list(page: &mut Page, items: &[String]) {
    for (i, item) in items.iter().enumerate() {
        let comma = if i + 1 < items.len() { "," } else { "" };
        page.line(format!("{item}{comma}"));
    }
}

fn port(port: &PortDescription) -> String {
    let direction = match port.direction {
        Direction::Input => "input",
        Direction::Output => "output",
    };
    let sign = if port.signed { " signed" } else { "" };
    let range = match port.width {
        Width::Fixed(1) => String::new(),
        Width::Fixed(width) => format!(" [{}:0]", width - 1),
        width => format!(" [{width} - 1:0]"),
    };
    format!("{direction} wire{sign}{range} {}", port.name)
}

/// One branch for each set of parameters. The last one names a module that does not exist: no simulator elaborates
/// it in silence, and the message carries its name.
fn branches(page: &mut Page, description: &Description, specialisations: &[&Specialisation]) {
    page.block("generate", "endgenerate", |page| {
        let mut otherwise = "";
        for specialisation in specialisations {
            let equal = specialisation.parameters.iter().map(|(name, value)| format!("{name} == {}", number(value)));
            let condition = equal.collect::<Vec<_>>().join(" && ");
            page.block(format!("{otherwise}if ({condition}) begin : {BRANCH}"), "end", |page| {
                body(page, description, &specialisation.body);
            });
            otherwise = "else ";
        }
        page.block(format!("else begin : {BRANCH}"), "end", |page| {
            page.line(format!("{}_was_not_exported_with_these_parameters other_parameters ();", description.name));
        });
    });
}

/// A parameter's value; Verilog's unsized numbers may have no more than 32 bits.
pub(super) fn number(value: i64) -> String {
    match i32::try_from(value) {
        Ok(value) => value.to_string(),
        Err(_) if value < 0 => format!("-64'sd{}", value.unsigned_abs()),
        Err(_) => format!("64'sd{value}"),
    }
}
