//! Sweeps over parameters, and their columns that are measured.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use crate::su1522157::oracle;

fn sweep(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_stepwright"));
    command.current_dir(folder).args(["sweep", "su1522157/interpolator"]).args(arguments).output().expect("it starts")
}

/// Header and rows of a sweep that does well.
fn rows(folder: &Path, arguments: &[&str]) -> (Vec<String>, Vec<Vec<String>>) {
    let output = sweep(folder, arguments);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let mut reader = csv::Reader::from_reader(output.stdout.as_slice());
    let fields = |record: &csv::StringRecord| record.iter().map(str::to_owned).collect::<Vec<_>>();
    let header = fields(reader.headers().expect("a header"));
    (header, reader.records().map(|record| fields(&record.expect("a row"))).collect())
}

fn refused(folder: &Path, arguments: &[&str], code: &str) {
    let output = sweep(folder, arguments);
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.code() == Some(2) && said.contains(&format!("error[{code}]")), "{arguments:?}: {said}");
}

const OVER: [&str; 8] =
    ["--over", "minor_34=1,2", "--over", "p:DELAY_13=3,1", "--over", "major_32=2..=4", "--over", "p:TAP_SPACING=1..=2"];

#[test]
fn parameters_stand_first_vary_slowest_and_give_the_rows_of_a_sweep_with_each_of_them() {
    let folder = tempfile::tempdir().expect("a folder");
    let (header, all) = rows(folder.path(), &OVER);
    assert_eq!(header[..4], ["p:DELAY_13", "p:TAP_SPACING", "minor_34", "major_32"]);
    let mut expected = Vec::new();
    for delay in ["3", "1"] {
        for spacing in ["1", "2"] {
            let parameters =
                ["-p", &format!("DELAY_13={delay}"), "-p", &format!("TAP_SPACING={spacing}")].map(str::to_owned);
            let parameters: Vec<_> = parameters.iter().map(String::as_str).collect();
            let alone = rows(
                folder.path(),
                &[&parameters[..], &["--over", "minor_34=1,2", "--over", "major_32=2..=4"]].concat(),
            );
            let with = |row: Vec<String>| [vec![delay.to_owned(), spacing.to_owned()], row].concat();
            expected.extend(alone.1.into_iter().map(with));
        }
    }
    assert_eq!(all, expected);
}

#[test]
fn a_sweep_of_parameters_cut_anywhere_is_resumed_to_the_same_bytes() {
    let folder = tempfile::tempdir().expect("a folder");
    let arguments = [&OVER[..], &["--measure", "deviation,steps", "--out"]].concat();
    for name in ["out.csv", "out.jsonl"] {
        let with = |more: &[&str]| sweep(folder.path(), &[&arguments[..], &[name], more].concat()).status.code();
        assert_eq!(with(&[]), Some(0));
        let path = folder.path().join(name);
        let whole = fs::read(&path).expect("a file");
        for left in (0..whole.len()).step_by(whole.len() / 7) {
            fs::write(&path, &whole[..left]).expect("a file");
            assert_eq!(with(&["--resume"]), Some(0));
            assert_eq!(fs::read(&path).expect("a file"), whole, "{name} cut after {left} bytes");
        }
    }
    let other = ["--over", "minor_34=1,2", "--over", "p:DELAY_13=1..=2", "--out", "out.csv", "--resume"];
    refused(folder.path(), &other, "C066");
}

#[test]
fn measured_columns_are_what_the_equations_make_of_each_row() {
    let folder = tempfile::tempdir().expect("a folder");
    let measure = ["--measure", "deviation,end,steps,run,feed"];
    let (header, all) =
        rows(folder.path(), &[&["--over", "major_32=7..=16", "--over", "minor_34=0..=7"], &measure[..]].concat());
    let of = |row: &[String], name: &str| -> f64 {
        row[header.iter().position(|known| known == name).expect("a column")].parse().expect("a number")
    };
    for row in &all {
        let (major, minor) = (of(row, "major_32"), of(row, "minor_34"));
        let letters = oracle::letters(major as i64, minor as i64);
        let length = major.hypot(minor);
        let (mut node, mut deviation) = ([0.0, 0.0], 0.0_f64);
        for letter in letters.chars() {
            let by = if letter == 'U' { [1.0, 0.0] } else { [0.75, 0.75] };
            node = [node[0] + by[0], node[1] + by[1]];
            deviation = deviation.max((node[0] * minor - node[1] * major).abs() / length);
        }
        let end = f64::max((node[0] - major).abs(), (node[1] - minor).abs());
        let longest = (1..=30).rev().find(|&n| letters.contains(&"U".repeat(n)) || letters.contains(&"D".repeat(n)));
        let steps = letters.len() as f64;
        let expected = [deviation, end, steps, longest.expect("a run") as f64, node[0].hypot(node[1]) / steps];
        for (name, expected) in measure[1].split(',').zip(expected) {
            assert!((of(row, name) - expected).abs() < 1e-12, "{name} of ({major}, {minor})");
        }
    }
    assert_eq!(all.len(), 80);
}

#[test]
fn what_cannot_be_swept_or_measured_is_refused_before_anything_is_written() {
    let folder = tempfile::tempdir().expect("a folder");
    let refused = |arguments: &[&str], code: &str| {
        refused(folder.path(), &[arguments, &["--out", "out.csv"]].concat(), code);
    };
    refused(&["--over", "p:DELAY_31=1"], "N014");
    refused(&["--over", "p:DELAY_13=0..=2"], "N015");
    refused(&["--over", "p:DELAY_13=1", "-p", "DELAY_13=2"], "C062");
    refused(&["--over", "p:DELAY_13=1", "--over", "p:DELAY_13=2"], "C062");
    refused(&["--over", "p:DELAY_13=1.5"], "C063");
    refused(&["--over", "p:DELAY_13=1..=1024", "--over", "p:DELAY_22=1..=2"], "C069");
    let mut command = Command::new(env!("CARGO_BIN_EXE_stepwright"));
    let arguments = ["sweep", "su1522157/multiplexer_21", "--over", "a=0,1", "--measure", "end"];
    let output = command.args(arguments).output().expect("it starts");
    assert!(String::from_utf8_lossy(&output.stderr).contains("error[A001]"));
    assert!(!folder.path().join("out.csv").exists());
}

#[test]
fn a_heat_map_has_a_cell_for_each_row() {
    let folder = tempfile::tempdir().expect("a folder");
    let over = ["--over", "p:DELAY_13=1..=3", "--over", "p:CLOCK_PERIOD=2..=5", "-s", "major_32=1", "-s", "minor_34=1"];
    let (_, plain) = rows(folder.path(), &[&over[..], &["--measure", "steps"]].concat());
    for (name, more) in [("a.svg", ["--measure", "steps"]), ("b.svg", ["--column", "ticks"])] {
        rows(folder.path(), &[&over[..], &more, &["--heatmap", name]].concat());
        let svg = fs::read_to_string(folder.path().join(name)).expect("a file");
        // A white sheet and a scale of 64 steps stand beside the cells.
        assert_eq!(svg.matches("<rect").count(), plain.len() + 64 + 1, "{name}");
        for text in [
            "p:DELAY_13",
            "p:CLOCK_PERIOD",
            more[1],
            "stepwright sweep su1522157/interpolator --over p:DELAY_13=1..=3:1",
        ] {
            assert!(svg.contains(text), "{name}: {text}");
        }
    }
}

#[test]
fn a_heat_map_that_cannot_be_is_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let two = ["--over", "major_32=1..=3", "--over", "minor_34=0..=1", "--heatmap", "a.svg"];
    refused(folder.path(), &two, "C008");
    refused(folder.path(), &[&two[..2], &two[4..], &["--column", "ticks"]].concat(), "C008");
    refused(folder.path(), &[&two[..], &["--column", "tick"]].concat(), "C070");
    let many = ["--over", "major_32=0..=4095", "--over", "minor_34=0..=255", "--heatmap", "a.svg", "--column", "ticks"];
    refused(folder.path(), &many, "C071");
    let unwritable = [&two[..4], &["--heatmap", "nowhere/a.svg", "--column", "ticks"]].concat();
    refused(folder.path(), &unwritable, "C003");
    assert!(!folder.path().join("a.svg").exists());
}
