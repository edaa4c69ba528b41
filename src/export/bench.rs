//! A bench: a Verilog module that drives a circuit like a scenario does, and writes a waveform.

use super::expression::{literal, range};
use super::module::number;
use super::page::Page;
use crate::base::Stimulus;
use crate::netlist::{Net, NetId, Netlist};

/// The module name of the bench of a circuit: one that stands nowhere in its texts.
#[must_use]
pub fn bench_name(netlist: &Netlist) -> String {
    let name = format!("{}_bench", netlist.scopes[0].module);
    free(name, |name| netlist.sources.iter().any(|(_, text)| text.contains(name)))
}

/// A name, with underscores after it until it is not taken.
fn free(mut name: String, is_taken: impl Fn(&str) -> bool) -> String {
    while is_taken(&name) {
        name.push('_');
    }
    name
}

/// The text of a Verilog-2005 file with a bench module that drives the top module of `netlist` through `ticks` ticks
/// (at least 1) of `stimulus`, whatever that says of stopping, and writes `bench.vcd`.
///
/// The clock rises at 1, 2, 3 ... ns: what our waveforms show of tick t at t ns, this one shows from t to t + 1 ns.
#[must_use]
pub fn bench(netlist: &Netlist, stimulus: &Stimulus, ticks: u64) -> String {
    let top = &netlist.scopes[0].module;
    let name = bench_name(netlist);
    let mut page = Page::default();
    page.line(format!("// A bench for `{top}`. Tick t is to be seen from t to t + 1 ns. With Icarus:"));
    page.line("//");
    page.line(format!("//     iverilog -g2005 -s {name} -o bench.vvp *.v && vvp -n bench.vvp && gtkwave bench.vcd"));
    page.line("`timescale 1ns / 100ps");
    page.line("`default_nettype none");
    page.line("");
    page.block(format!("module {name};"), "endmodule", |page| {
        declarations(page, netlist);
        page.line("");
        instance(page, netlist);
        page.line("");
        page.block("initial begin", "end", clock);
        page.line("");
        page.block("initial begin", "end", |page| {
            page.line("$dumpfile(\"bench.vcd\");");
            page.line(format!("$dumpvars(0, {top});"));
            drive(page, netlist, stimulus, ticks);
        });
    });
    page.finish()
}

fn net(netlist: &Netlist, id: NetId) -> &Net {
    &netlist.nets[id.index()]
}

/// The top module's port for the clock, if it has one.
fn clock_port(netlist: &Netlist) -> Option<&Net> {
    netlist.nets.iter().find(|net| net.scope.index() == 0 && net.is_clock && net.port.is_some())
}

/// The bench's own name for what it connects to a port: the port's, unless the instance has it.
fn word_name(netlist: &Netlist, port: &Net) -> String {
    if port.name != *netlist.scopes[0].module {
        return port.name.clone();
    }
    let ports = || netlist.inputs.iter().chain(&netlist.outputs).map(|&id| &net(netlist, id).name);
    free(format!("{}_", port.name), |name| ports().any(|other| other == name))
}

fn declarations(page: &mut Page, netlist: &Netlist) {
    page.line("reg clk;");
    for (kind, ports) in [("reg", &netlist.inputs), ("wire", &netlist.outputs)] {
        for port in ports.iter().map(|&id| net(netlist, id)) {
            let sign = if port.signed { "signed " } else { "" };
            page.line(format!("{kind} {sign}{}{};", range(port.width), word_name(netlist, port)));
        }
    }
}

/// The circuit. Only given parameters are given on: a default has a width and a sign of its own in the circuit's text.
fn instance(page: &mut Page, netlist: &Netlist) {
    let top = &netlist.scopes[0].module;
    let parameters = netlist.given.iter().map(|(name, value)| format!(".{name}({})", number(*value)));
    let parameters = parameters.collect::<Vec<_>>().join(", ");
    let overrides = if parameters.is_empty() { String::new() } else { format!("#({parameters}) ") };
    let clock = clock_port(netlist).map(|port| format!(".{}(clk)", port.name));
    let ports = netlist.inputs.iter().chain(&netlist.outputs).map(|&id| net(netlist, id));
    let ports = ports.map(|port| format!(".{}({})", port.name, word_name(netlist, port)));
    let connections: Vec<_> = clock.into_iter().chain(ports).collect();
    page.line(format!("{top} {overrides}{top} ({});", connections.join(", ")));
}

fn clock(page: &mut Page) {
    page.line("clk = 1'b0;");
    page.line("#1;");
    page.block("forever begin", "end", |page| {
        page.line("clk = 1'b1;");
        page.line("#0.5 clk = 1'b0;");
        page.line("#0.5;");
    });
}

/// Inputs change together with the registers, by assignments that take effect after every register has read.
fn drive(page: &mut Page, netlist: &Netlist, stimulus: &Stimulus, ticks: u64) {
    let inputs = netlist.inputs.iter().map(|&id| net(netlist, id));
    let inputs: Vec<_> = inputs.map(|port| (word_name(netlist, port), port.width)).collect();
    let set = |input: usize, word: u64, operator| {
        let (name, width) = &inputs[input];
        format!("{name} {operator} {};", literal(word, *width))
    };
    stimulus.initial.iter().enumerate().for_each(|(input, &word)| page.line(set(input, word, "=")));
    let (mut now, last) = (0, ticks.saturating_sub(1));
    for change in stimulus.changes.iter().take_while(|change| change.tick <= last) {
        wait(page, change.tick - now);
        now = change.tick;
        page.line(set(change.input, change.word, if now == 0 { "=" } else { "<=" }));
    }
    wait(page, last - now);
    page.line("#0.5 $finish(0);");
}

fn wait(page: &mut Page, ticks: u64) {
    match ticks {
        0 => {}
        1 => page.line("@(posedge clk);"),
        _ => page.line(format!("repeat (64'd{ticks}) @(posedge clk);")),
    }
}
