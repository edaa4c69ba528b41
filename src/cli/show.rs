//! `stepwright show`: ports, parameters, figure and documentation of a circuit or block.

use std::fmt::Write as _;

use super::{Ending, print};
use crate::base::{Diagnostic, Report};
use crate::blocks::{self, Description, Direction, REGISTRY};
use crate::netlist::Net;
use crate::simulation::{Design, Session, shipped};

pub(super) fn show(name: &str) -> Result<Ending, Report> {
    let text = match blocks::find(name) {
        Some(block) => block_text(block.description()),
        None => circuit_text(name)?,
    };
    print(&text)?;
    Ok(Ending::Done)
}

fn block_text(block: &Description) -> String {
    let mut text = format!(
        "block {} ({})\n{}\n\n{}\n\nsource: {}\n",
        block.name, block.kind, block.summary, block.doc, block.source
    );
    if !block.parameters.is_empty() {
        text.push_str("\nparameters\n");
    }
    for p in block.parameters {
        let range = format!("{} to {}, default {}", p.min, p.max, p.default);
        let _ = writeln!(text, "    {:20} {range:28} {}", p.name, p.doc);
    }
    text.push_str("\nports\n");
    if block.clocked {
        let _ = writeln!(text, "    {:7} {:20} {:28} the global tick", "input", "clk", "1 bit");
    }
    for port in block.ports {
        let direction = match port.direction {
            Direction::Input => "input",
            Direction::Output => "output",
        };
        let width = match port.width.to_string() {
            width if width == "1" => "1 bit".to_owned(),
            width => format!("{width} bits{}", if port.signed { ", signed" } else { "" }),
        };
        let _ = writeln!(text, "    {direction:7} {:20} {width:28} {}", port.name, port.doc);
    }
    text
}

fn circuit_text(name: &str) -> Result<String, Report> {
    let design = Session::open(name).map_err(|report| unknown(name, report))?.elaborate()?;
    let (netlist, title) = (design.netlist(), &design.scenario().title);
    let mut text = format!("circuit {}\n", design.circuit().name());
    if !title.is_empty() {
        let _ = writeln!(text, "scenario: {title}");
    }
    let _ = writeln!(text, "\n{}", header_comment(design.circuit().source()));
    if !netlist.parameters.is_empty() {
        text.push_str("parameters\n");
    }
    for (name, value) in &netlist.parameters {
        let _ = writeln!(text, "    {name:20} {value}");
    }
    text.push_str("ports\n");
    ports(&design, &mut text);
    let _ = writeln!(
        text,
        "{} blocks and gates, {} nets, {} modules",
        netlist.cells.len(),
        netlist.nets.len(),
        netlist.scopes.len()
    );
    Ok(text)
}

/// The name may have been meant for a block.
fn unknown(name: &str, mut report: Report) -> Report {
    let names = REGISTRY.iter().map(|block| block.description().name).chain(shipped::names("v"));
    if let [diagnostic @ Diagnostic { code: "C001", .. }] = report.diagnostics.as_mut_slice() {
        *diagnostic = Diagnostic::new("C001", format!("there is no circuit or block `{name}`"))
            .nearest(name, names)
            .help("`stepwright list` and `stepwright list blocks` name them");
    }
    report
}

/// The comment that a circuit file opens with, after its compiler directives.
fn header_comment(text: &str) -> String {
    let lines = text.lines().skip_while(|line| line.starts_with('`') || line.trim().is_empty());
    let comment = lines.map_while(|line| line.strip_prefix("//"));
    comment.map(|line| line.strip_prefix(' ').unwrap_or(line).to_owned() + "\n").collect()
}

fn ports(design: &Design, text: &mut String) {
    let inputs = design.inputs().map(|net| ("input", net));
    for (direction, net) in inputs.chain(design.outputs().map(|net| ("output", net))) {
        let Net { name, width, .. } = net;
        let signed = if net.signed { ", signed" } else { "" };
        let fraction = net.fraction.map_or_else(String::new, |bits| format!(", {bits} of them fraction"));
        let bits = if *width == 1 { "1 bit".to_owned() } else { format!("{width} bits{signed}{fraction}") };
        let _ = writeln!(text, "    {direction:7} {name:20} {bits}");
    }
}
