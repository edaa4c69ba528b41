//! `check` names the net that first went wrong, not one of those that follow from it.

use std::fs;
use std::path::Path;
use std::process::Command;

const CIRCUIT: &str = "module chain (input wire a, input wire b, output wire y, output wire z);
    wire m;
    and gate_1 (m, a, b);
    not gate_2 (y, m);
    not gate_3 (z, y);
endmodule
";

const SCENARIO: &str = "circuit = \"chain.v\"
[inputs]
a = 1
b = 1
[[at]]
tick = 3
set = { b = 0 }
[stop]
ticks = 6
";

fn check(folder: &Path, arguments: &[&str]) -> (Option<i32>, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_stepwright"));
    command.current_dir(folder).arg("check").args(arguments).env_remove("CI").env_remove("STEPWRIGHT_BLESS");
    let output = command.output().expect("the binary starts");
    (output.status.code(), String::from_utf8(output.stdout).expect("text"))
}

#[test]
fn the_gate_that_was_broken_is_named_with_its_tick_and_none_of_those_behind_it() {
    let folder = tempfile::tempdir().expect("a folder");
    let circuits = folder.path().join("circuits");
    fs::create_dir(&circuits).expect("a folder");
    fs::write(circuits.join("chain.v"), CIRCUIT).expect("a file");
    fs::write(circuits.join("chain.toml"), SCENARIO).expect("a file");
    let (status, text) = check(folder.path(), &["--bless"]);
    assert_eq!(status, Some(0), "{text}");
    // Both gates give 1 for 1 and 1; from tick 3 on the second input is 0.
    fs::write(circuits.join("chain.v"), CIRCUIT.replace("and gate_1", "or gate_1")).expect("a file");
    let (status, text) = check(folder.path(), &[]);
    assert_eq!(status, Some(1), "{text}");
    let causes: Vec<_> = text.lines().filter(|line| line.contains("first went wrong")).collect();
    assert_eq!(causes.len(), 1, "{text}");
    let expected = "chain.m first went wrong, at tick 3: expected 0, got 1 while its drivers are right (gate_1";
    assert!(causes[0].trim_start().starts_with(expected), "{text}");
}
