//! `diff` holds our own waveform against those that Icarus and Verilator write themselves.

use std::path::Path;
use std::process::Command;

use serde_json::Value;

use super::tools::{self, run};

const BINARY: &str = env!("CARGO_BIN_EXE_stepwright");

/// Our waveform of table 1 as `ours.vcd`, and its Verilog in `out`.
fn exported() -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    run(folder.path(), BINARY, &["run", "su1522157/table1", "--vcd", "ours.vcd"]);
    run(folder.path(), BINARY, &["export", "su1522157/table1", "--verilog", "out"]);
    folder
}

/// What `diff` says of ours and another file, and how it ends.
fn diff(folder: &Path, other: &str, options: &[&str]) -> (Option<i32>, Value) {
    let arguments = [&["diff", "ours.vcd", other, "--circuit", "su1522157/table1", "--json"], options].concat();
    let output = Command::new(BINARY).current_dir(folder).args(arguments).output().expect("it starts");
    (output.status.code(), serde_json::from_slice(&output.stdout).expect("one JSON object"))
}

/// Every net of ours is compared, and equal; none is only ours.
fn is_equal(folder: &Path, other: &str, options: &[&str]) {
    let (status, found) = diff(folder, other, options);
    assert_eq!(status, Some(0), "{other}: {}", found["first"]);
    // As many as table 1 has signals: its golden trace holds them all.
    let golden = std::fs::read_to_string(folder.join("ours.vcd")).expect("text");
    assert_eq!(found["compared"], golden.matches("$var").count(), "{other}");
    assert_eq!(found["only_a"], serde_json::json!([]), "{other}");
}

#[test]
fn our_waveform_is_equal_to_that_of_icarus_at_every_change_and_at_the_clock() {
    if !tools::present(&["iverilog", "vvp"]) {
        return;
    }
    let folder = exported();
    tools::icarus(&folder.path().join("out"), "interpolator_bench");
    is_equal(folder.path(), "out/bench.vcd", &[]);
    is_equal(folder.path(), "out/bench.vcd", &["--at", "clk"]);
    // A bit that Icarus has otherwise is found: its waveform of another segment.
    run(folder.path(), BINARY, &["run", "su1522157/table1", "-s", "minor_34=4", "--ticks", "57", "--vcd", "ours.vcd"]);
    let (status, found) = diff(folder.path(), "out/bench.vcd", &["--at", "clk"]);
    assert_eq!((status, &found["cause"]["net"]), (Some(1), &"interpolator.minor_34".into()));
}

/// Drives table 1 tick by tick: inputs change with the falling clock, the circuit with the rising one.
const MAIN: &str = r#"
#include "Vinterpolator.h"
#include "verilated_vcd_c.h"
int main() {
    Verilated::traceEverOn(true);
    Vinterpolator dut;
    VerilatedVcdC vcd;
    dut.trace(&vcd, 99);
    vcd.open("verilator.vcd");
    for (int tick = 0; tick < 57; ++tick) {
        dut.major_32 = 8;
        dut.minor_34 = 3;
        dut.x_is_major_35 = 1;
        dut.start_33 = tick == 0;
        for (int clk = 0; clk < 2; ++clk) {
            dut.clk = clk;
            dut.eval();
            vcd.dump(2 * tick + clk);
        }
    }
    vcd.close();
}
"#;

#[test]
fn our_waveform_is_equal_to_that_of_verilator_at_the_clock() {
    if !tools::present(&["verilator", "g++", "make"]) {
        return;
    }
    let folder = exported();
    std::fs::write(folder.path().join("main.cpp"), MAIN).expect("a file");
    let build = ["--cc", "--exe", "--build", "--trace", "-Wno-fatal", "--top-module", "interpolator", "main.cpp"];
    let files = ["out/interpolator.v", "out/blocks.v"];
    run(folder.path(), "verilator", &[&build[..], &files].concat());
    run(folder.path(), "obj_dir/Vinterpolator", &[]);
    is_equal(folder.path(), "verilator.vcd", &["--at", "clk"]);
}
