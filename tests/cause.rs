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

fn git(folder: &Path, arguments: &[&str]) {
    let who = ["-c", "user.name=a", "-c", "user.email=a@example.org"];
    crate::outside::tools::run(folder, "git", &[&who, arguments].concat());
}

/// A repository with a shipped circuit, its scenario and its golden trace.
fn repository(name: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    for (below, ending) in [("circuits", "v"), ("circuits", "toml"), ("traces", "vcd")] {
        let file = Path::new(below).join(name).with_extension(ending);
        let there = folder.path().join(&file);
        fs::create_dir_all(there.parent().expect("a folder")).expect("a folder");
        fs::copy(Path::new(env!("CARGO_MANIFEST_DIR")).join(&file), there).expect("a copy");
    }
    git(folder.path(), &["init", "--quiet"]);
    git(folder.path(), &["add", "--all"]);
    git(folder.path(), &["commit", "--quiet", "--message", "good"]);
    folder
}

/// Breaks multiplier 270: it multiplies by K instead of L.
fn break_multiplier_270(folder: &Path) {
    let path = folder.join("circuits/us3809868/incremental_generator.v");
    let text = fs::read_to_string(&path).expect("text");
    let at = text.find("multiplier_270 (").expect("the multiplier");
    let broken = text[at..].replacen(".rate(magnitude_l)", ".rate(magnitude_k)", 1);
    assert_ne!(broken, text[at..]);
    fs::write(path, format!("{}{broken}", &text[..at])).expect("a file");
}

#[test]
fn a_multiplier_that_the_golden_trace_does_not_hold_is_named_with_an_older_netlist_and_not_guessed_without() {
    if !crate::outside::tools::present(&["git"]) {
        return;
    }
    let folder = repository("us3809868/incremental_generator");
    break_multiplier_270(folder.path());
    let went_wrong = |text: &str| text.lines().filter(|line| line.contains("first went wrong")).count();
    let (status, text) = check(folder.path(), &[]);
    assert_eq!((status, went_wrong(&text)), (Some(1), 1), "{text}");
    assert!(text.contains("its nearest traced drivers are right"), "{text}");
    assert!(text.contains("nets between that are not traced, of which one may be wrong: 32"), "{text}");
    assert!(text.contains("--since HEAD"), "{text}");
    let (status, text) = check(folder.path(), &["--since", "HEAD"]);
    assert_eq!((status, went_wrong(&text)), (Some(1), 1), "{text}");
    assert!(text.contains("multiplier_270.rate first went wrong, at tick 1"), "{text}");
    assert!(text.contains("(multiplier_270, a `binary_rate_multiplier` at circuits"), "{text}");
    assert!(text.contains("pulse_270 follows"), "{text}");
}

#[test]
fn a_cause_that_many_scenarios_show_is_told_once() {
    if !crate::outside::tools::present(&["git"]) {
        return;
    }
    let folder = repository("us3809868/incremental_generator");
    let place = |name: &str| folder.path().join(name);
    for (file, ending) in
        [("circuits/us3809868/incremental_generator", "toml"), ("traces/us3809868/incremental_generator", "vcd")]
    {
        let copy = file.replace("incremental_generator", "second");
        fs::copy(place(&format!("{file}.{ending}")), place(&format!("{copy}.{ending}"))).expect("a copy");
    }
    break_multiplier_270(folder.path());
    let (status, text) = check(folder.path(), &["--since", "HEAD"]);
    assert_eq!(status, Some(1), "{text}");
    assert!(text.contains("2 different"), "{text}");
    assert_eq!(text.matches("first went wrong").count(), 1, "{text}");
    let again = "went wrong, which is told at circuits/us3809868/incremental_generator.toml";
    assert_eq!(text.matches(again).count(), 1, "{text}");
}

#[test]
fn a_revision_that_git_does_not_know_is_refused_before_anything_runs() {
    if !crate::outside::tools::present(&["git"]) {
        return;
    }
    let folder = repository("us3809868/incremental_generator");
    let mut command = Command::new(env!("CARGO_BIN_EXE_stepwright"));
    let output = command.current_dir(folder.path()).args(["check", "--since", "nowhere"]).output().expect("it starts");
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!((output.status.code(), output.stdout.len()), (Some(2), 0), "{said}");
    assert!(said.contains("C010") && said.contains("nowhere"), "{said}");
}

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
