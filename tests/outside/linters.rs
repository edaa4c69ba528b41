//! Verilator and Yosys accept the circuits and what we print beside them, without a warning.

use std::path::Path;

use rayon::prelude::*;
use stepwright::blocks::{Block, Parameters, REGISTRY};
use stepwright::export;
use stepwright::simulation::{Circuit, shipped};

use super::duts::Duts;
use super::tools;

fn write(folder: &Path, name: &str, text: &str) {
    std::fs::write(folder.join(name), text).expect("a file");
}

fn lint(folder: &Path, top: &str, files: &[&str]) {
    // An output that nobody reads is left out of a connection list; an input our reader would miss.
    // SystemVerilog has words that a port of ours is called by: `inside`.
    let verilator = ["--lint-only", "--language", "1364-2005", "-Wno-PINMISSING", "--top-module", top];
    tools::run(folder, "verilator", &[&verilator, files].concat());
    // Deferred, because no block stands for its default parameters unless they are in use; -e: warnings are errors.
    let files = files.join(" ");
    let script = format!("read_verilog -defer {files}; hierarchy -check -top {top}; proc; check -assert");
    tools::run(folder, "yosys", &["-q", "-e", ".*", "-p", &script]);
}

#[test]
fn verilator_and_yosys_accept_every_block_without_a_warning() {
    if !tools::present(&["verilator", "yosys"]) {
        return;
    }
    let defaults = REGISTRY.iter().map(|block| (*block, Parameters::defaults(block.description())));
    let duts = Duts::new(defaults.collect::<Vec<(&'static Block, _)>>());
    let folder = tempfile::tempdir().expect("a folder");
    write(folder.path(), "blocks.v", &export::verilog([&duts.netlist]));
    write(folder.path(), "duts.v", &duts.text);
    lint(folder.path(), "duts", &["blocks.v", "duts.v"]);
}

#[test]
fn verilator_and_yosys_accept_every_circuit_without_a_warning() {
    if !tools::present(&["verilator", "yosys"]) {
        return;
    }
    let circuits: Vec<_> = shipped::names("v").collect();
    assert!(!circuits.is_empty());
    circuits.par_iter().for_each(|circuit| {
        let session = Circuit::shipped(circuit).expect("a shipped circuit").session();
        let design = session.elaborate().unwrap_or_else(|report| panic!("{report}"));
        let files = export::files(design.netlist(), design.stimulus(), 1);
        let folder = tempfile::tempdir().expect("a folder");
        files.iter().for_each(|file| write(folder.path(), &file.name, &file.text));
        let names: Vec<_> = files
            .iter()
            .map(|file| file.name.as_str())
            .filter(|name| name.ends_with(".v") && *name != "bench.v")
            .collect();
        lint(folder.path(), &design.netlist().scopes[0].module, &names);
    });
}
