//! `stepwright sweep` from outside: rows, order, resuming, refusals.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use crate::support::SCENARIO;

/// A folder with the scenario `frames.toml`.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("frames.toml"), SCENARIO).expect("a file");
    folder
}

fn sweep(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_stepwright"));
    command.current_dir(folder).args(["sweep", "frames.toml"]).args(arguments).output().expect("the program runs")
}

/// Standard output of a sweep that does well.
fn rows(folder: &Path, arguments: &[&str]) -> String {
    let output = sweep(folder, arguments);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("text")
}

const FRAMES: [&str; 4] = ["--over", "major_32=0..=40:2,7", "--over", "minor_34=0,3,1..=2"];

#[test]
fn table_1_of_the_patent_is_a_row() {
    let folder = folder();
    let text = rows(folder.path(), &["--over", "major_32=7..=8", "--over", "minor_34=3"]);
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let header = reader.headers().expect("a header").clone();
    let last = reader.records().last().expect("two rows").expect("a row");
    let of = |name: &str| &last[header.iter().position(|known| known == name).expect("a column")];
    assert_eq!((of("major_32"), of("minor_34"), of("stopped_by"), of("busy")), ("8", "3", "until", "0"));
    // X = 8, Y = 3 are five whole and four combined steps: table 1.
    assert_eq!((of("pulses.step_x_36"), of("pulses.step_y_37"), of("pulses.step_xy_38")), ("5", "0", "4"));
}

#[test]
fn rows_are_the_same_on_every_engine_and_any_number_of_threads() {
    let folder = folder();
    let with = |more: &[&str]| rows(folder.path(), &[&FRAMES[..], more].concat());
    let plain = with(&["--engine", "interpreter"]);
    assert_eq!(plain.lines().count(), 1 + 22 * 4);
    assert_eq!(plain.lines().nth(2).map(|line| line.starts_with("0,3,")), Some(true), "the last range varies fastest");
    for more in [&["--threads", "1"][..], &["--threads", "3"], &["--engine", "lanes"], &["--engine", "native"]] {
        assert_eq!(with(more), plain, "{more:?}");
    }
}

#[test]
fn rows_of_a_csv_file_are_those_of_the_same_ranges() {
    let folder = folder();
    fs::write(folder.path().join("in.csv"), "major_32, minor_34\n4,1\n4,0x2\n5,1\n5,2\n").expect("a file");
    let ranges = rows(folder.path(), &["--over", "major_32=4..6", "--over", "minor_34=1..=2"]);
    assert_eq!(rows(folder.path(), &["--from", "in.csv"]), ranges);
}

#[test]
fn json_lines_say_the_same_as_csv() {
    let folder = folder();
    let csv = rows(folder.path(), &FRAMES);
    rows(folder.path(), &[&FRAMES[..], &["--out", "out.jsonl"]].concat());
    let json = fs::read_to_string(folder.path().join("out.jsonl")).expect("a file");
    let mut reader = csv::Reader::from_reader(csv.as_bytes());
    let header = reader.headers().expect("a header").clone();
    let mut lines = json.lines();
    for record in reader.records() {
        let line: serde_json::Value = serde_json::from_str(lines.next().expect("as many rows")).expect("JSON");
        for (name, field) in header.iter().zip(&record.expect("a row")) {
            let value = match name.strip_prefix("pulses.") {
                Some(pulse) => &line["pulses"][pulse],
                None => [&line["inputs"][name], &line["outputs"][name], &line[name]]
                    .into_iter()
                    .find(|value| !value.is_null())
                    .unwrap_or(&line[name]),
            };
            assert_eq!(value.as_str().map_or_else(|| value.to_string(), str::to_owned), *field, "{name}");
        }
    }
    assert_eq!(lines.next(), None);
}

#[test]
fn a_file_cut_anywhere_is_resumed_to_the_same_bytes() {
    let folder = folder();
    for name in ["out.csv", "out.jsonl"] {
        let path = folder.path().join(name);
        rows(folder.path(), &[&FRAMES[..], &["--out", name]].concat());
        let whole = fs::read(&path).expect("a file");
        for left in [0, 5, whole.len() / 3, whole.len() / 2, whole.len() - 1, whole.len()] {
            fs::write(&path, &whole[..left]).expect("a file");
            rows(folder.path(), &[&FRAMES[..], &["--out", name, "--resume"]].concat());
            assert_eq!(fs::read(&path).expect("a file"), whole, "{name} cut after {left} bytes");
        }
    }
}

/// A scenario that stops within the limit for some stimuli only.
const LIMITED: [&str; 4] = ["--over", "major_32=60,1,2,3", "--limit", "100"];

#[test]
fn rows_from_before_count_for_the_status() {
    let folder = folder();
    let path = folder.path().join("out.csv");
    for name in ["out.csv", "out.jsonl"] {
        let path = path.with_file_name(name);
        let with = |more: &[&str]| sweep(folder.path(), &[&LIMITED[..], &["--out", name], more].concat());
        assert_eq!(with(&[]).status.code(), Some(1));
        let whole = fs::read_to_string(&path).expect("a file");
        for left in 0..=whole.lines().count() {
            let cut: String = whole.lines().take(left).flat_map(|line| [line, "\n"]).collect();
            fs::write(&path, cut).expect("a file");
            let resumed = with(&["--resume"]);
            assert_eq!(resumed.status.code(), Some(1), "{name} cut after {left} lines");
            assert!(String::from_utf8_lossy(&resumed.stderr).contains("1 of 4 rows reached the limit"));
            assert_eq!(fs::read_to_string(&path).expect("a file"), whole);
        }
    }
}

#[test]
fn a_sweep_with_anything_else_than_before_is_not_gone_on_with() {
    let folder = folder();
    let path = folder.path().join("out.csv");
    rows(folder.path(), &[&FRAMES[..], &["--out", "out.csv"]].concat());
    let whole = fs::read(&path).expect("a file");
    fs::write(&path, &whole[..whole.len() / 2]).expect("a file");
    let with = |more: &[&str], wanted: &[&str]| {
        let said = refusal(folder.path(), &[&FRAMES[..], &["--out", "out.csv", "--resume"], more].concat());
        wanted.iter().for_each(|part| assert!(said.contains(part), "`{part}` is not in:\n{said}"));
    };
    with(&["--ticks", "50"], &["C066", "stop", "until !busy, limit 10000", "ticks 50"]);
    with(&["--until", "busy"], &["until busy"]);
    with(&["--limit", "400"], &["limit 400"]);
    with(&["-p", "WIDTH=13"], &["parameters.WIDTH: 12 in the file, 13 now"]);
    with(&["-s", "x_is_major_35=0"], &["inputs.x_is_major_35"]);
    fs::write(folder.path().join("frames.toml"), SCENARIO.replace("tick = 1", "tick = 2")).expect("a file");
    with(&[], &["changes"]);
    let circuit = stepwright::simulation::shipped::text("su1522157/interpolator.v").expect("a circuit");
    fs::write(folder.path().join("interpolator.v"), format!("{circuit}\n// changed\n")).expect("a file");
    fs::write(folder.path().join("frames.toml"), SCENARIO.replace("su1522157/interpolator", "interpolator.v"))
        .expect("a file");
    with(&[], &["circuit.sha256"]);
    fs::write(folder.path().join("frames.toml"), SCENARIO).expect("a file");
    fs::remove_file(folder.path().join("out.csv.sweep")).expect("a file");
    with(&[], &["C066", "out.csv.sweep"]);
}

/// What a sweep that is refused says.
fn refusal(folder: &Path, arguments: &[&str]) -> String {
    let output = sweep(folder, arguments);
    assert_eq!(output.status.code(), Some(2));
    assert!(output.stdout.is_empty(), "nothing is written");
    String::from_utf8(output.stderr).expect("text")
}

#[test]
fn a_file_of_another_sweep_is_not_gone_on_with() {
    let folder = folder();
    let path = folder.path().join("out.csv");
    rows(folder.path(), &["--over", "major_32=9,8", "--out", "out.csv"]);
    let before = fs::read(&path).expect("a file");
    for other in [&["--over", "minor_34=0..5"][..], &["--over", "major_32=9,7"], &["--over", "major_32=9"]] {
        let said = refusal(folder.path(), &[other, &["--out", "out.csv", "--resume"]].concat());
        assert!(said.contains("C066"), "{said}");
        assert_eq!(fs::read(&path).expect("a file"), before);
    }
}

#[test]
fn wrong_values_are_told_before_anything_is_written() {
    let folder = folder();
    let write = |text: &str| fs::write(folder.path().join("in.csv"), text).expect("a file");
    write("major_32,minor_34\n1,2\n5000,1\nx,-1\n");
    let said = refusal(folder.path(), &["--from", "in.csv", "--out", "out.csv"]);
    assert!(said.contains("in.csv:3: major_32") && said.contains("in.csv:4: minor_34"), "{said}");
    for (arguments, wanted) in [
        (&["--over", "major_32=4000..=4096"][..], "C063"),
        (&["--over", "major_23=1"], "did you mean `major_32`?"),
        (&["--over", "major_32=1", "--over", "major_32=2"], "C062"),
        (&["--over", "start_33=0,1"], "C061"),
        (&["--over", "major_32=3..3"], "empty"),
        (&["--from", "missing.csv"], "C002"),
        (&["--from", "."], "directory"),
    ] {
        let said = refusal(folder.path(), &[arguments, &["--out", "out.csv"]].concat());
        assert!(said.contains(wanted), "{arguments:?}: {said}");
    }
    write("");
    assert!(refusal(folder.path(), &["--from", "in.csv", "--out", "out.csv"]).contains("C065"));
    write("major_32\n1\n2,3\n");
    assert!(refusal(folder.path(), &["--from", "in.csv", "--out", "out.csv"]).contains("C065"));
    assert!(!folder.path().join("out.csv").exists());
}

#[test]
fn errors_of_a_header_beyond_the_hundredth_are_counted_as_those_of_rows_are() {
    let folder = folder();
    let told = |text: String| {
        fs::write(folder.path().join("many.csv"), text).expect("a file");
        let output = sweep(folder.path(), &["--from", "many.csv"]);
        assert_eq!(output.status.code(), Some(2));
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        (said.matches("error[").count(), said)
    };
    let names: Vec<_> = (0..131).map(|i| format!("nobody_{i}")).collect();
    let (errors, said) = told(names.join(",") + "\n");
    assert!(errors == 101 && said.contains("many.csv: 31 more errors"), "{said}");
    let (errors, said) = told("major_32\n".to_owned() + &"no\n".repeat(120));
    assert!(errors == 101 && said.contains("many.csv: 20 more errors"), "{said}");
    // All the same, which is told once; and each is looked up at once.
    let (errors, said) = told("major_32,".repeat(300_000) + "minor_34\n");
    assert!(errors == 2 && said.contains("many.csv: 299899 more errors"), "{said}");
}
