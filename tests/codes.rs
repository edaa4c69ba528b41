//! Diagnostics that no other test raises by their code, each through the command line.

use std::fs;
use std::process::Command;

use stepwright::simulation::Circuit;
use stepwright::trace::{Coordinate, Path};

/// Runs the binary in a folder with a scenario `a.toml` of the text, and returns what it says on standard error.
fn said(scenario: &str, arguments: &[&str], variables: &[(&str, &str)]) -> String {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("a.toml"), scenario).expect("a file");
    let mut command = Command::new(env!("CARGO_BIN_EXE_stepwright"));
    command.current_dir(folder.path()).args(arguments).env_remove("CI").env_remove("STEPWRIGHT_BLESS");
    let output = command.envs(variables.iter().copied()).output().expect("the binary starts");
    assert_eq!(output.status.code(), Some(2), "{arguments:?}");
    String::from_utf8(output.stderr).expect("text")
}

fn raises(code: &str, scenario: &str, arguments: &[&str]) {
    let said = said(scenario, arguments, &[]);
    assert!(said.contains(&format!("error[{code}]")), "{code} is not in:\n{said}");
    assert!(said.contains("help:") || said.contains("a.toml:"), "nothing says how to mend it:\n{said}");
}

const FRAME: &str = "circuit = \"su1522157/interpolator\"\n";

#[test]
fn what_is_wrong_on_the_command_line_has_its_code() {
    raises("C001", "", &["run", "su1522157/interpolatr"]);
    raises("C008", "", &["run", "su1522157/table1", "--vcd", "a.vcd", "--from", "9", "--to", "2"]);
    let wide = "module a (input wire [63:0] x, input wire [63:0] z, output wire y); and g (y, x[0], z[0]); endmodule";
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("wide.v");
    fs::write(&path, wide).expect("a file");
    let all = ["--over", "x=0..0xFFFFFFFFFFFFFFFF", "--over", "z=0..0xFFFFFFFFFFFFFFFF"];
    raises("C064", "", &[&["sweep", path.to_str().expect("text")][..], &all].concat());
    let threads = ["--over", "minor_34=1..3", "--engine", "native", "--threads", "2"];
    raises("C067", "", &[&["sweep", "su1522157/interpolator", "-s", "major_32=3"][..], &threads].concat());
    raises("W005", "", &["run", "su1522157/table1", "--wave", "a.png"]);
    let blessed = said(FRAME, &["check", "--bless", "a.toml"], &[("CI", "true")]);
    assert!(blessed.contains("error[C005]"), "{blessed}");
}

#[test]
fn what_is_wrong_in_a_scenario_has_its_code() {
    raises("S003", &format!("{FRAME}title = 7\n"), &["run", "a.toml"]);
    raises("S004", "title = \"no circuit\"\n", &["run", "a.toml"]);
    raises(
        "S005",
        &format!("{FRAME}{}", (0..30).map(|i| format!("key_{i} = 1\n")).collect::<String>()),
        &["run", "a.toml"],
    );
    raises("S013", FRAME, &["run", "a.toml", "--ticks", "0"]);
    raises("S015", FRAME, &["run", "a.toml", "--until", "clk"]);
}

#[test]
fn a_program_that_draws_what_is_no_signal_gets_its_code() {
    let mut path = Path::new(["busy", "nowhere"].map(|name| Coordinate::Signal(name.to_owned())), None);
    let mut run = Circuit::shipped("su1522157/interpolator").expect("it is shipped").session().start().expect("a run");
    let report = run.record(&mut path).expect_err("no such signal").to_string();
    assert!(report.contains("error[S014]") && report.contains("`nowhere`"), "{report}");
}
