//! The command line as scripts see it: output, exit status, messages, files.

mod completions;
mod differences;
mod json;
mod mistakes;
mod options;
mod own_folder;
mod parts;
mod pictures;
mod requirements;
mod shown;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

const ROOT: &str = env!("CARGO_MANIFEST_DIR");

/// Runs the binary in a folder.
fn stepwright_in(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_stepwright"));
    command.current_dir(folder).args(arguments).env_remove("CI").env_remove("STEPWRIGHT_BLESS");
    command.output().expect("the binary starts")
}

fn stepwright(arguments: &[&str]) -> Output {
    stepwright_in(Path::new(ROOT), arguments)
}

fn stdout(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).expect("text")
}

fn stderr(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).expect("text")
}

fn succeeds(arguments: &[&str]) -> String {
    let output = stepwright(arguments);
    assert!(output.status.success(), "{arguments:?}: {}", stderr(&output));
    stdout(&output)
}

/// Asserts exit status 2, no result, and a message with all of `parts`.
fn refuses(output: &Output, parts: &[&str]) {
    let message = stderr(output);
    assert_eq!(output.status.code(), Some(2), "{message}");
    assert_eq!(stdout(output), "");
    for part in parts {
        assert!(message.contains(part), "`{part}` is not in:\n{message}");
    }
}

fn folder() -> tempfile::TempDir {
    tempfile::tempdir().expect("a temporary folder")
}

fn written(folder: &Path, name: &str, text: impl AsRef<[u8]>) -> PathBuf {
    let path = folder.join(name);
    fs::write(&path, text).expect("a file");
    path
}

#[test]
fn run_prints_one_json_object_with_the_numbers_of_table_1() {
    let text = succeeds(&["run", "su1522157/table1", "--json"]);
    let object: serde_json::Value = serde_json::from_str(&text).expect("one JSON object");
    assert_eq!(object["circuit"], "su1522157/interpolator");
    assert_eq!(object["stopped_by"], "until");
    assert_eq!(object["parameters"]["WIDTH"], 12);
    // Table 1 of the patent: five unit steps along X, four combined ones.
    assert_eq!(object["pulses"]["step_x_36"], 5);
    assert_eq!(object["pulses"]["step_y_37"], 0);
    assert_eq!(object["pulses"]["step_xy_38"], 4);
    assert_eq!(object["outputs"]["busy"], 0);
}

#[test]
fn every_engine_tells_the_same() {
    let of = |engine| {
        succeeds(&[
            "run",
            "su1522157/interpolator",
            "-s",
            "major_32=127",
            "-s",
            "minor_34=43",
            "--json",
            "--engine",
            engine,
        ])
    };
    let expected = of("interpreter");
    for engine in ["native", "lanes", "auto"] {
        assert_eq!(of(engine), expected, "{engine}");
    }
}

#[test]
fn numbers_may_be_decimal_hexadecimal_or_binary() {
    let run = |major: &str| succeeds(&["run", "su1522157/interpolator", "-s", major, "--json"]);
    assert_eq!(run("major_32=0x1f"), run("major_32=31"));
    assert_eq!(run("major_32=0b11111"), run("major_32=31"));
}

#[test]
fn a_value_that_does_not_fit_its_port_is_refused() {
    refuses(
        &stepwright(&["run", "su1522157/interpolator", "-p", "WIDTH=12", "--set", "major_32=5000"]),
        &["S011", "5000", "12 unsigned bits", "0 to 4095"],
    );
}

#[test]
fn a_slip_in_a_name_is_answered_with_the_nearest_name() {
    refuses(&stepwright(&["run", "su1522157/interpolatr"]), &["did you mean `su1522157/interpolator`?"]);
    refuses(&stepwright(&["run", "su1522157/interpolator", "-s", "major_33=1"]), &["S010", "did you mean `major_32`?"]);
    refuses(&stepwright(&["run", "su1522157/interpolator", "-p", "WIDHT=1"]), &["did you mean `WIDTH`?"]);
    refuses(&stepwright(&["run", "su1522157/interpolator", "--until", "busi"]), &["S012", "did you mean `busy`?"]);
    refuses(&stepwright(&["show", "sumer"]), &["did you mean `summer`?"]);
    refuses(&stepwright(&["show", "interpolator"]), &["did you mean `su1522157/interpolator`?"]);
    refuses(&stepwright(&["run", "su1522157/interpolator", "--engine", "nativ"]), &["native"]);
}

#[test]
fn a_scenario_with_an_unknown_key_is_refused_with_its_place() {
    let folder = folder();
    let path = written(folder.path(), "bad.toml", "circuit = \"su1522157/interpolator\"\n[stop]\ntick = 3\n");
    refuses(&stepwright(&["run", path.to_str().unwrap()]), &["bad.toml:3:1", "`tick`", "did you mean `ticks`?"]);
}

#[test]
fn a_circuit_file_that_is_none_is_refused() {
    let folder = folder();
    let at = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    written(folder.path(), "binary.v", [0u8, 159, 146, 150, 255]);
    written(folder.path(), "empty.v", "");
    written(folder.path(), "brackets.v", "(".repeat(50 << 20));
    fs::create_dir(folder.path().join("folder.v")).expect("a folder");
    refuses(&stepwright(&["run", &at("binary.v")]), &["is not text"]);
    refuses(&stepwright(&["run", &at("empty.v")]), &["empty.v", "is empty"]);
    refuses(&stepwright(&["run", &at("brackets.v")]), &["error[N"]);
    refuses(&stepwright(&["run", &at("folder.v")]), &["is a directory"]);
    refuses(&stepwright(&["run", &at("missing.v")]), &["there is no such file"]);
}

#[test]
fn an_output_that_cannot_be_written_is_refused_and_nothing_is_left_behind() {
    let folder = folder();
    let nowhere = folder.path().join("nowhere/out.vcd");
    refuses(&stepwright(&["run", "su1522157/table1", "--vcd", nowhere.to_str().unwrap()]), &["C003", "out.vcd"]);
    refuses(
        &stepwright(&["run", "su1522157/table1", "--vcd", folder.path().to_str().unwrap()]),
        &["C003", "directory"],
    );
    assert_eq!(fs::read_dir(folder.path()).expect("the folder").count(), 0);
}

#[test]
fn the_limit_is_reported_and_ends_with_status_1() {
    let output = stepwright(&["run", "su1522157/interpolator", "-s", "major_32=4000", "--limit", "100"]);
    assert_eq!(output.status.code(), Some(1));
    assert!(stderr(&output).contains("limit of 100 ticks"));
}

#[test]
fn a_number_of_ticks_may_come_with_a_limit_but_not_a_smaller_one() {
    let run = |limit| stepwright(&["run", "su1522157/table1", "--ticks", "20", "--limit", limit, "--json"]);
    assert!(stdout(&run("30")).contains("\"stopped_by\":\"ticks\",\"ticks\":20"));
    refuses(&run("10"), &["C007", "--limit 10", "--ticks 20"]);
}

#[test]
fn waveforms_are_written_and_a_save_file_beside_them() {
    let folder = folder();
    let output = stepwright_in(
        folder.path(),
        &["run", "su1522157/table1", "--vcd", "a.vcd", "--fst", "a.fst", "--gtkw", "a.gtkw"],
    );
    assert!(output.status.success(), "{}", stderr(&output));
    let mut names: Vec<_> = fs::read_dir(folder.path()).unwrap().map(|entry| entry.unwrap().file_name()).collect();
    names.sort();
    assert_eq!(names, ["a.fst", "a.gtkw", "a.vcd"]);
    assert!(fs::read_to_string(folder.path().join("a.gtkw")).unwrap().contains("a.vcd"));
}

#[test]
fn a_traced_window_holds_only_its_ticks() {
    let folder = folder();
    let output = stepwright_in(
        folder.path(),
        &["run", "su1522157/table1", "--vcd", "a.vcd", "--trace", "tap_*", "--from", "5", "--to", "9"],
    );
    assert!(output.status.success(), "{}", stderr(&output));
    let text = fs::read_to_string(folder.path().join("a.vcd")).unwrap();
    let times: Vec<u64> = text.lines().filter_map(|line| line.strip_prefix('#')).map(|t| t.parse().unwrap()).collect();
    assert_eq!((times.first(), times.last()), (Some(&5), Some(&10)), "the closing time is one past the last tick");
    assert_eq!(text.matches("$var").count(), 9, "nine taps");
}

#[test]
fn a_glob_that_matches_nothing_is_refused() {
    refuses(&stepwright(&["run", "su1522157/table1", "--vcd", "/dev/null", "--trace", "tapp_23"]), &["W002", "tap_23"]);
    assert!(Path::new("/dev/null").metadata().is_ok_and(|about| !about.is_file()), "/dev/null is still a device");
}

#[test]
fn diff_finds_the_first_divergence() {
    let golden = format!("{ROOT}/traces/su1522157/table1.vcd");
    assert!(stepwright(&["diff", &golden, &golden]).status.success());
    let folder = folder();
    let output = stepwright_in(folder.path(), &["run", "su1522157/table1", "-s", "minor_34=4", "--vcd", "b.vcd"]);
    assert!(output.status.success());
    let output = stepwright_in(folder.path(), &["diff", &golden, "b.vcd"]);
    assert_eq!(output.status.code(), Some(1));
    assert!(stdout(&output).contains("minor_34"), "{}", stdout(&output));
}

#[test]
fn check_with_nothing_to_check_ends_with_status_3() {
    let output = stepwright_in(folder().path(), &["check"]);
    assert_eq!(output.status.code(), Some(3), "{}", stderr(&output));
}

#[test]
fn check_finds_a_changed_bit_and_names_tick_net_values_and_cause() {
    let folder = folder();
    let place = |below: &str| folder.path().join(below);
    fs::create_dir_all(place("circuits/su1522157")).unwrap();
    fs::create_dir_all(place("traces/su1522157")).unwrap();
    let scenario = format!("{ROOT}/circuits/su1522157/table1.toml");
    fs::copy(scenario, place("circuits/su1522157/table1.toml")).unwrap();
    let golden = fs::read_to_string(format!("{ROOT}/traces/su1522157/table1.vcd")).unwrap();
    // The step output 36 rises once more than it should: its identifier in the header, then a change.
    let line =
        golden.lines().find(|line| line.contains("$var") && line.contains(" step_x_36 ")).expect("a declaration");
    let id = line.split_whitespace().nth(3).expect("an identifier");
    let changed = golden.replacen(&format!("\n0{id}\n"), &format!("\n1{id}\n"), 1);
    assert_ne!(changed, golden);
    fs::write(place("traces/su1522157/table1.vcd"), changed).unwrap();
    let output = stepwright_in(folder.path(), &["check"]);
    assert_eq!(output.status.code(), Some(1), "{}", stderr(&output));
    let text = stdout(&output);
    for part in ["tick 0", "step_x_36", "expected 1", "got 0", "--bless", "gtkwave"] {
        assert!(text.contains(part), "`{part}` is not in:\n{text}");
    }
}

#[test]
fn check_refuses_to_bless_in_ci() {
    let output = Command::new(env!("CARGO_BIN_EXE_stepwright"))
        .current_dir(folder().path())
        .args(["check", "--bless"])
        .env("CI", "true")
        .output()
        .expect("the binary starts");
    refuses(&output, &["C005"]);
}

#[test]
fn a_golden_that_is_cut_short_is_refused() {
    let folder = folder();
    let golden = fs::read(format!("{ROOT}/traces/su1522157/table1.vcd")).unwrap();
    let cut = written(folder.path(), "cut.vcd", &golden[..golden.len() / 3]);
    let whole = format!("{ROOT}/traces/su1522157/table1.vcd");
    refuses(&stepwright(&["diff", &whole, cut.to_str().unwrap()]), &["W011", "cut.vcd", "the file ends in the middle"]);
}

#[test]
fn every_shipped_circuit_and_block_can_be_shown() {
    let circuits = succeeds(&["list"]);
    let circuits = circuits.lines().filter(|line| !line.starts_with(' '));
    assert!(circuits.clone().count() >= 10);
    for circuit in circuits {
        assert!(succeeds(&["show", circuit]).contains("ports"), "{circuit}");
    }
    let blocks = succeeds(&["list", "blocks"]);
    for block in blocks.lines().filter_map(|line| line.strip_prefix("    ")) {
        let name = block.split_whitespace().next().expect("a name");
        assert!(succeeds(&["show", name]).contains("source:"), "{name}");
    }
}

#[test]
fn no_colours_go_into_a_pipe() {
    assert!(!stderr(&stepwright(&["run", "nothing"])).contains('\u{1b}'));
}

#[test]
fn help_has_examples_and_completions_are_printed() {
    for command in [&["--help"][..], &["run", "--help"], &["check", "--help"], &["export", "--help"]] {
        assert!(succeeds(command).contains("Example"), "{command:?}");
    }
    assert!(succeeds(&["completions", "bash"]).contains("stepwright"));
}

#[test]
fn wrong_usage_ends_with_status_2() {
    for arguments in [
        &["run"][..],
        &["frobnicate"],
        &["run", "su1522157/table1", "-s", "major_32"],
        &["run", "su1522157/table1", "-s", "major_32=many"],
    ] {
        assert_eq!(stepwright(arguments).status.code(), Some(2), "{arguments:?}");
    }
}
