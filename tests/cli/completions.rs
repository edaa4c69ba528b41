//! What the completion script of a shell gets as an answer.

use std::path::Path;
use std::process::Command;

use super::{ROOT, succeeds};

/// What bash is offered for the last of the words.
fn offered(folder: &Path, words: &[&str]) -> Vec<String> {
    let output = Command::new(env!("CARGO_BIN_EXE_stepwright"))
        .current_dir(folder)
        .args(["--", "stepwright"])
        .args(words)
        .env("STEPWRIGHT_COMPLETE", "bash")
        .env("_CLAP_COMPLETE_INDEX", words.len().to_string())
        .env("_CLAP_IFS", "\n")
        .output()
        .expect("the binary starts");
    String::from_utf8(output.stdout).expect("text").lines().map(str::to_owned).collect()
}

#[test]
fn names_of_all_kinds_are_completed() {
    let root = Path::new(ROOT);
    for (words, wanted) in [
        (&["ru"][..], &["run"][..]),
        (&["run", "su1522157/tabl"], &["su1522157/table1"]),
        (&["check", "su1522157/tie"], &["su1522157/tie_7_3", "su1522157/tie_7_3_minus_zero"]),
        (&["show", "binary_r"], &["binary_rate_multiplier"]),
        (&["show", "su1522157/interpolator.counter"], &["su1522157/interpolator.counter_14"]),
        (&["run", "su1522157/interpolator", "-s", "m"], &["major_32=", "minor_34="]),
        (&["run", "su1522157/interpolator", "-p", "DELAY"], &["DELAY_13=", "DELAY_22="]),
        (&["run", "su1522157/interpolator", "--until", "!bus"], &["!busy"]),
        (&["run", "su1522157/interpolator", "--table", "--columns", "f_1,r_"], &["f_1,r_14"]),
        (
            &["run", "us3809868/fig09_function_generator", "--trace", "generator_16.magnitude_k"],
            &["generator_16.magnitude_k"],
        ),
    ] {
        assert_eq!(offered(root, words), wanted, "{words:?}");
    }
}

#[test]
fn files_of_ones_own_are_completed_with_their_inputs() {
    let folder = super::folder();
    let text = "module mine (input wire clk, input wire pulse, output wire later);\n\
        delay_element #(.DELAY(3)) delay_13 (.clk(clk), .pulse_in(pulse), .pulse_out(later), .active());\nendmodule\n";
    super::written(folder.path(), "mine.v", text);
    super::written(folder.path(), "notes.txt", "");
    assert_eq!(offered(folder.path(), &["run", "mi"]), ["mine.v"]);
    assert_eq!(offered(folder.path(), &["run", "no"]), [""; 0]);
    assert_eq!(offered(folder.path(), &["run", "./mine.v", "-s", ""]), ["pulse="]);
}

#[test]
fn every_shell_gets_a_script_that_asks() {
    for shell in ["bash", "elvish", "fish", "powershell", "zsh"] {
        assert!(succeeds(&["completions", shell]).contains("STEPWRIGHT_COMPLETE"), "{shell}");
    }
}
