//! Verilator and Yosys accept what we print, without a warning.

use stepwright::blocks::{Block, Parameters, REGISTRY};
use stepwright::export;

use super::duts::Duts;
use super::tools;

#[test]
fn verilator_and_yosys_accept_every_block_without_a_warning() {
    if !tools::present(&["verilator", "yosys"]) {
        return;
    }
    let defaults = REGISTRY.iter().map(|block| (*block, Parameters::defaults(block.description())));
    let duts = Duts::new(defaults.collect::<Vec<(&'static dyn Block, _)>>());
    let folder = tempfile::tempdir().expect("a folder");
    for (name, text) in [("blocks.v", &export::verilog([&duts.netlist])), ("duts.v", &duts.text)] {
        std::fs::write(folder.path().join(name), text).expect("a file");
    }
    tools::run(folder.path(), "verilator", &["--lint-only", "--top-module", "duts", "blocks.v", "duts.v"]);
    // Deferred, because no block stands for its default parameters unless they are in use; -e: warnings are errors.
    let script = "read_verilog -defer blocks.v duts.v; hierarchy -check -top duts; proc; check -assert";
    tools::run(folder.path(), "yosys", &["-q", "-e", ".*", "-p", script]);
}
