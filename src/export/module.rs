//! Modules: each block in use as a Verilog module, with a branch for each set of parameters in use.

use std::collections::HashSet;

use super::body::body;
use super::page::Page;
use crate::blocks::{Body, Description, Direction, Parameters, PortDescription, Width};
use crate::netlist::{CellKind, Netlist};

/// The name of the `generate` branch that a block with parameters has its inside in: one more scope in the waveforms
/// of other simulators than in ours.
pub const BRANCH: &str = "specialised";

/// A block for one set of parameters.
struct Specialisation<'n> {
    description: &'static Description,
    parameters: &'n Parameters,
    body: &'n Body,
}

/// Every block and set of parameters that the netlists use, each once, in order of first use.
fn specialisations<'n>(netlists: impl IntoIterator<Item = &'n Netlist>) -> Vec<Specialisation<'n>> {
    let mut seen = HashSet::new();
    let cells = netlists.into_iter().flat_map(|netlist| &netlist.cells);
    let used = cells.filter_map(|cell| match &cell.kind {
        CellKind::Block { block, parameters } => {
            Some(Specialisation { description: block.description(), parameters, body: &cell.body })
        }
        CellKind::Gate(_) => None,
    });
    used.filter(|used| seen.insert((used.description.name, used.parameters))).collect()
}

/// The text of a Verilog-2005 file with a module for every block that the netlists use, in order of first use. Beside
/// it the circuit files of these netlists, with the parameters they were read with, compile unchanged.
///
/// ```
/// use std::sync::Arc;
/// use stepwright::base::Report;
/// use stepwright::{export, netlist};
///
/// struct Nowhere;
/// impl netlist::Library for Nowhere {
///     fn find(&self, _: &str) -> Option<Result<(String, Arc<str>), Report>> {
///         None
///     }
/// }
///
/// let circuit = "module top (input wire clk, input wire pulse, output wire later);
///     delay_element #(.DELAY(3)) delay_13 (.clk(clk), .pulse_in(pulse), .pulse_out(later));
/// endmodule";
/// let netlist = netlist::load("top.v", circuit, None, &Nowhere, &[])?;
/// let text = export::verilog([&netlist]);
/// assert!(text.contains("module delay_element #("));
/// assert!(text.contains("if (DELAY == 3) begin"));
/// # Ok::<(), stepwright::base::Report>(())
/// ```
#[must_use]
pub fn verilog<'n>(netlists: impl IntoIterator<Item = &'n Netlist>) -> String {
    let mut page = Page::default();
    page.line("// The blocks of a Stepwright circuit, printed from their ops.");
    page.line("// A word named _op, _in or _state is an op, an input or a register of its block.");
    page.line("`default_nettype none");
    let all = specialisations(netlists);
    let mut printed = HashSet::new();
    for description in all.iter().map(|used| used.description) {
        if printed.insert(description.name) {
            let of_block: Vec<_> = all.iter().filter(|used| used.description.name == description.name).collect();
            page.line("");
            module(&mut page, description, &of_block);
        }
    }
    page.finish()
}

/// A block alone, for one set of parameters, as a Verilog-2005 module.
#[must_use]
pub fn block(description: &'static Description, parameters: &Parameters, body: &Body) -> String {
    let mut page = Page::default();
    module(&mut page, description, &[&Specialisation { description, parameters, body }]);
    page.finish()
}

fn module(page: &mut Page, description: &Description, specialisations: &[&Specialisation<'_>]) {
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
        [only] if parameters.is_empty() => body(page, description, only.body),
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
fn branches(page: &mut Page, description: &Description, specialisations: &[&Specialisation<'_>]) {
    page.block("generate", "endgenerate", |page| {
        let mut otherwise = "";
        for specialisation in specialisations {
            let equal = specialisation.parameters.iter().map(|(name, value)| format!("{name} == {}", compared(value)));
            let condition = equal.collect::<Vec<_>>().join(" && ");
            page.block(format!("{otherwise}if ({condition}) begin : {BRANCH}"), "end", |page| {
                body(page, description, specialisation.body);
            });
            otherwise = "else ";
        }
        page.block(format!("else begin : {BRANCH}"), "end", |page| {
            page.line(format!("{}_was_not_exported_with_these_parameters other_parameters ();", description.name));
        });
    });
}

/// A parameter's value to be compared with; a name as the string that it is given as, so that widths agree.
fn compared(value: i64) -> String {
    let letters: Vec<u8> = value.to_be_bytes().into_iter().skip_while(|&byte| byte == 0).collect();
    let is_name = letters.len() > 4 && letters.iter().all(|byte| byte.is_ascii_alphanumeric() || *byte == b'_');
    match String::from_utf8(letters) {
        Ok(name) if is_name => format!("\"{name}\""),
        _ => number(value),
    }
}

/// A parameter's value; Verilog's unsized numbers may have no more than 32 bits.
pub(super) fn number(value: i64) -> String {
    match i32::try_from(value) {
        Ok(value) => value.to_string(),
        Err(_) if value < 0 => format!("-64'sd{}", value.unsigned_abs()),
        Err(_) => format!("64'sd{value}"),
    }
}
