//! Circuits and scenarios in a folder of one's own.

use std::fs;
use std::path::Path;

use super::{folder, refuses, stderr, stdout, stepwright_in, written};

const CIRCUIT: &str = "module brm3 (input wire clk, input wire pulse, output wire out);\n\
    binary_rate_multiplier #(.WIDTH(3)) brm (.clk(clk), .clear(1'b0), .pulse(pulse), .trailing(1'b1), .rate(3'd5),\n\
    .out(out), .overflow());\nendmodule\n";
const SCENARIO: &str = "title = \"Five of eight\"\ncircuit = \"brm3\"\n[inputs]\npulse = 1\n[stop]\nticks = 8\n";

/// `mine/brm3.v` and `mine/brm3.toml`, with a line more at the top.
fn mine(folder: &Path, line: &str) {
    fs::create_dir_all(folder.join("mine")).expect("a folder");
    written(folder, "mine/brm3.v", CIRCUIT);
    written(folder, "mine/brm3.toml", format!("{line}\n{SCENARIO}"));
}

fn says(folder: &Path, arguments: &[&str], status: i32) -> String {
    let output = stepwright_in(folder, arguments);
    assert_eq!(output.status.code(), Some(status), "{arguments:?}: {}{}", stdout(&output), stderr(&output));
    stdout(&output)
}

#[test]
fn the_golden_trace_is_beside_the_scenario_under_a_name_of_its_own() {
    let folder = folder();
    mine(folder.path(), "");
    written(folder.path(), "mine/brm3.vcd", "my own dump");
    assert!(says(folder.path(), &["check", "mine/brm3.toml"], 1).contains("check --bless mine/brm3.toml"));
    assert!(says(folder.path(), &["check", "--bless", "mine/brm3.toml"], 0).contains("mine/brm3.golden.vcd: new"));
    assert_eq!(fs::read_to_string(folder.path().join("mine/brm3.vcd")).unwrap(), "my own dump");
    // By its path, without the ending, by its folder, and from within.
    for named in ["mine/brm3.toml", "mine/brm3", "mine", "."] {
        assert!(says(folder.path(), &["check", named], 0).starts_with("ok"), "{named}");
    }
    assert!(says(&folder.path().join("mine"), &["check", "brm3"], 0).starts_with("ok"));
    written(folder.path(), "mine/brm3.v", CIRCUIT.replace("3'd5", "3'd4"));
    assert!(says(folder.path(), &["check", "mine"], 1).contains("brm3.brm.rate expected 0x5 "));
}

#[test]
fn the_golden_trace_is_where_the_scenario_says() {
    let folder = folder();
    mine(folder.path(), "golden = \"goldens/five.vcd\"");
    says(folder.path(), &["check", "--bless", "mine"], 0);
    assert!(folder.path().join("mine/goldens/five.vcd").is_file());
    assert!(says(&folder.path().join("mine"), &["check", "brm3.toml"], 0).starts_with("ok"));
}

#[test]
fn below_a_folder_circuits_it_stays_in_traces_from_wherever_it_is_checked() {
    let folder = folder();
    fs::create_dir(folder.path().join("circuits")).expect("a folder");
    mine(&folder.path().join("circuits"), "");
    says(folder.path(), &["check", "--bless"], 0);
    assert!(folder.path().join("traces/mine/brm3.vcd").is_file());
    for named in ["mine", "mine/brm3", "mine/brm3.toml", "circuits/mine/brm3.toml", "circuits"] {
        assert!(says(folder.path(), &["check", named], 0).starts_with("ok"), "{named}");
    }
    assert!(says(&folder.path().join("circuits/mine"), &["check", "brm3.toml"], 0).starts_with("ok"));
    for (command, said) in [("run", "8 ticks"), ("show", "circuit mine/brm3"), ("list", "mine/brm3")] {
        let name = if command == "list" { "mine" } else { "mine/brm3" };
        assert!(says(folder.path(), &[command, name], 0).contains(said), "{command}");
    }
}

#[test]
fn a_golden_trace_whose_scenario_is_gone_is_named() {
    let folder = folder();
    fs::create_dir(folder.path().join("circuits")).expect("a folder");
    mine(&folder.path().join("circuits"), "");
    says(folder.path(), &["check", "--bless"], 0);
    written(folder.path(), "traces/mine/brm4.vcd", "");
    assert!(says(folder.path(), &["check"], 1).contains("LOST     traces/mine/brm4.vcd"));
}

#[test]
fn list_names_what_is_in_a_folder() {
    let folder = folder();
    mine(folder.path(), "");
    written(folder.path(), "mine/frame.toml", "title = \"A frame\"\ncircuit = \"su1522157/interpolator\"\n");
    let listed = says(folder.path(), &["list", "mine"], 0);
    let words: Vec<Vec<_>> = listed.lines().map(|line| line.split_whitespace().collect()).collect();
    let expected = [
        vec!["mine/brm3"],
        vec!["mine/brm3", "Five", "of", "eight"],
        vec!["su1522157/interpolator"],
        vec!["mine/frame", "A", "frame"],
    ];
    assert_eq!(words, expected);
    let all = says(folder.path(), &["list", "su1522157"], 0);
    assert!(all.contains("su1522157/table1") && !all.contains("us3809868"), "{all}");
    refuses(&stepwright_in(folder.path(), &["list", "su1522158"]), &["C001", "did you mean `su1522157`?"]);
}

#[test]
fn a_scenario_that_cannot_be_read_does_not_hide_the_others() {
    let folder = folder();
    mine(folder.path(), "");
    written(folder.path(), "mine/bad.toml", "title = 7\n");
    let output = stepwright_in(folder.path(), &["list", "mine"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(stdout(&output).contains("Five of eight") && stderr(&output).contains("mine/bad.toml:1:9"));
}

#[test]
fn a_folder_cannot_be_run_but_tells_what_is_in_it() {
    let folder = folder();
    mine(folder.path(), "");
    refuses(&stepwright_in(folder.path(), &["run", "mine"]), &["C001", "mine/brm3.toml"]);
    refuses(&stepwright_in(folder.path(), &["check", "mine/brm4"]), &["C001", "mine/brm4"]);
    refuses(&stepwright_in(folder.path(), &["check", "su1522157/table1"]), &["show --source su1522157/table1.toml"]);
}
