//! The circuits that are measured: the self-feeding interpolator, alone and many times in one netlist.

use std::fmt::Write;
use std::sync::Arc;

use stepwright::compile::{Observe, Program, compile};
use stepwright::simulation::{Circuit, shipped};

/// The text of the self-feeding interpolator.
pub fn single() -> String {
    shipped::text("bench/self_feeding_interpolator.v").expect("a shipped circuit").to_owned()
}

/// The text of a ring of `count` self-feeding interpolators, each with a seed of its own: the checksum of one is
/// folded into that of the next, bit by bit.
pub fn ring(count: usize) -> String {
    let mut text = "module ring (input wire clk, output wire [31:0] checksum);\n".to_owned();
    for i in 0..count {
        writeln!(text, "wire [31:0] sum_{i};").expect("a string");
    }
    for i in 0..count {
        let before = (i + count - 1) % count;
        let machine = format!("self_feeding_interpolator #(.SEED({})) machine_{i}", 0x1234_5677 + 7919 * i);
        writeln!(text, "{machine} (.clk(clk), .link(sum_{before}[31]), .checksum(sum_{i}));").expect("a string");
    }
    writeln!(text, "assign checksum = sum_{};\nendmodule", count - 1).expect("a string");
    text
}

/// The program of a circuit's text; only its outputs are observed.
pub fn program(text: &str) -> Arc<Program> {
    let netlist = Circuit::text("circuits/bench/bench.v", text).elaborate(&[]);
    let netlist = netlist.unwrap_or_else(|report| panic!("{}", report.render(false)));
    Arc::new(compile(&netlist, &Observe::OUTPUTS))
}
