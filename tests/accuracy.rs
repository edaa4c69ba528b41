//! `stepwright accuracy` and the meter behind it, against the equations of the patent.

use std::ops::ControlFlow;
use std::process::{Command, Output};
use std::sync::atomic::AtomicBool;

use serde_json::Value;
use stepwright::accuracy::{Frame, Meter, Tally};
use stepwright::simulation::Session;
use tempfile::TempDir;

use crate::su1522157::oracle;

/// A step in quarters: along the major axis, along the minor one.
type Quarters = (i64, i64);

/// What a meter has to say of steps, by vectors in whole numbers.
fn expected(major: u64, minor: u64, steps: &[Quarters]) -> Frame {
    let mut nodes = vec![(0, 0)];
    for (along, across) in steps {
        let (p, q) = nodes[nodes.len() - 1];
        nodes.push((p + along, q + across));
    }
    let (x, y) = (major as i64, minor as i64);
    let end = nodes[nodes.len() - 1];
    let runs = steps.chunk_by(|a, b| a == b).map(<[_]>::len);
    Frame {
        major,
        minor,
        greatest: nodes.iter().map(|(p, q)| (p * y - q * x).unsigned_abs()).max().unwrap_or(0),
        left_major: 4 * x - end.0,
        left_minor: 4 * y - end.1,
        steps: steps.len() as u64,
        longest_run: runs.max().unwrap_or(0) as u64,
    }
}

fn of_the_device(major: u64, minor: u64) -> Vec<Quarters> {
    let steps = oracle::rows(major as i64, minor as i64);
    steps.iter().map(|step| if step.combined { (3, 3) } else { (4, 0) }).collect()
}

/// F in halves: F0 = 0.5 {(X - Y) - Y}.
fn of_the_prototype(major: u64, minor: u64) -> Vec<Quarters> {
    let (x, y) = (major as i64, minor as i64);
    let mut f = x - 2 * y;
    let step = |_| {
        let is_whole = f >= 0;
        f += if is_whole { -2 * y } else { 2 * (x - y) };
        (4, if is_whole { 0 } else { 4 })
    };
    (0..major).map(step).collect()
}

fn meter(circuit: &str, parameters: &[(&str, i64)]) -> Meter {
    let session = Session::open(circuit).and_then(Session::measured).unwrap_or_else(|report| panic!("{report}"));
    let session = parameters.iter().fold(session, |session, (name, value)| session.parameter(name, *value));
    Meter::of(session).unwrap_or_else(|report| panic!("{report}"))
}

fn frames(meter: &Meter, max: u64, skip: u64) -> Vec<Frame> {
    let mut frames = Vec::new();
    let sink = |frame, _, _| {
        frames.push(frame);
        ControlFlow::Continue(())
    };
    meter.run(max, skip, None, &AtomicBool::new(false), sink).unwrap_or_else(|report| panic!("{report}"));
    frames
}

#[test]
fn the_meters_say_of_every_segment_up_to_40_what_the_equations_make_of_it() {
    type Steps = fn(u64, u64) -> Vec<Quarters>;
    let machines: [(&str, Steps); 2] =
        [("su1522157/interpolator", of_the_device), ("su1522157/prototype", of_the_prototype)];
    for (circuit, steps) in machines {
        let seen = frames(&meter(circuit, &[]), 40, 1);
        let all = (1..=40).flat_map(|major| (0..=major).map(move |minor| (major, minor)));
        let expected: Vec<_> = all.map(|(major, minor)| expected(major, minor, &steps(major, minor))).collect();
        assert_eq!(seen, expected, "{circuit}");
    }
}

#[test]
fn with_minus_zero_and_other_times_the_law_holds_as_well() {
    for parameters in [[("MINUS_ZERO", 1), ("DELAY_13", 1)], [("CLOCK_PERIOD", 8), ("DELAY_13", 5)]] {
        let meter = meter("su1522157/interpolator", &parameters);
        let mut tally = Tally::default();
        frames(&meter, 64, 0).into_iter().for_each(|frame| tally.add(frame, &meter.claim()));
        assert_eq!((tally.violations, tally.end.end_error()), (0, 0.25), "{parameters:?}");
    }
}

fn accuracy(folder: &TempDir, arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_stepwright"));
    command.current_dir(folder.path()).arg("accuracy").args(arguments).output().expect("the program starts")
}

fn folder() -> TempDir {
    tempfile::tempdir().expect("a folder")
}

fn json(output: &Output) -> Value {
    let text = String::from_utf8_lossy(&output.stdout);
    serde_json::from_str(&text)
        .unwrap_or_else(|error| panic!("{error}: {text}{}", String::from_utf8_lossy(&output.stderr)))
}

fn assert_refused(output: &Output, code: &str) {
    let text = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.code() == Some(2) && text.contains(code), "{code}: {:?} {text}", output.status);
    assert!(output.stdout.is_empty());
}

#[test]
fn the_patents_numbers_come_out_of_the_netlist() {
    let output = accuracy(&folder(), &["su1522157/interpolator", "--max", "128", "--json"]);
    let object = json(&output);
    assert_eq!(output.status.code(), Some(0));
    assert_eq!((&object["segments"], &object["violations"]), (&8385.into(), &0.into()));
    // The reading has 0.39528 at (127, 43) as the worst up to 128.
    let worst = &object["worst"][0];
    assert_eq!((&worst["inputs"]["major_32"], &worst["inputs"]["minor_34"]), (&127.into(), &43.into()));
    let deviation = object["max_deviation"].as_f64().expect("a number");
    assert!((deviation - 0.395_28).abs() < 5e-6 && worst["deviation"] == object["max_deviation"]);
    assert_eq!(object["end_error"], 0.25);
    // A spurious step of a frame without length goes a whole step along the major axis.
    assert_eq!(object["no_length"], serde_json::json!({ "steps": 1, "end_error": 1.0 }));
    // All steps are whole ones on an axis, all combined ones on the diagonal.
    let feed = |end: &str| object["feed"][end].as_f64().expect("a number");
    assert!(feed("max") <= 0.75 * 2_f64.sqrt() + 1e-12 && feed("max") > 1.06 && feed("min") > 0.9);
}

#[test]
fn the_prototype_and_bresenham_reach_half_a_step_and_end_on_the_point() {
    for circuit in ["su1522157/prototype", "reference/bresenham"] {
        let object = json(&accuracy(&folder(), &[circuit, "--max", "128", "--json"]));
        let deviation = object["max_deviation"].as_f64().expect("a number");
        assert!(deviation > 0.4999 && deviation < 0.5, "{circuit}: {deviation}");
        assert_eq!((&object["violations"], &object["end_error"]), (&0.into(), &0.0.into()), "{circuit}");
    }
}

#[test]
fn a_machine_with_too_long_a_delay_goes_astray_in_as_many_frames_as_the_reading_has_and_the_exit_status_tells() {
    let arguments = ["su1522157/interpolator", "--max", "32", "-p", "DELAY_13=3", "--json"];
    let output = accuracy(&folder(), &arguments);
    let object = json(&output);
    // 84 of the 560 frames with a length get a step too many.
    assert_eq!((&object["segments"], &object["astray"]), (&561.into(), &84.into()));
    assert_eq!(output.status.code(), Some(1));
}

#[test]
fn a_table_over_parameters_has_the_rows_of_each_measurement() {
    let folder = folder();
    let arguments = ["su1522157/interpolator", "--max", "32", "--over", "p:DELAY_13=1..=3", "--over", "p:DELAY_22=1,4"];
    let object = json(&accuracy(&folder, &[&arguments[..], &["--json"]].concat()));
    let rows = object["rows"].as_array().expect("rows");
    let seen: Vec<_> = rows
        .iter()
        .map(|row| ["DELAY_13", "DELAY_22", "astray"].map(|name| row[name].as_u64().expect("a number")))
        .collect();
    assert_eq!(seen, [[1, 1, 0], [1, 4, 0], [2, 1, 0], [2, 4, 0], [3, 1, 84], [3, 4, 84]]);
    let output = accuracy(&folder, &[&arguments[..], &["--csv", "table.csv"]].concat());
    assert_eq!(output.status.code(), Some(1));
    assert_eq!(std::fs::read_to_string(folder.path().join("table.csv")).expect("a file").lines().count(), 7);
    assert_refused(&accuracy(&folder, &["su1522157/interpolator", "--over", "major_32=1"]), "C008");
}

#[test]
fn strokes_of_figure_9_end_where_they_began_and_guard_stages_bring_them_to_the_ellipse() {
    let folder = folder();
    let arguments = ["us3809868/fig09_function_generator", "--max", "511", "--over", "p:GUARD=0,3", "--json"];
    let output = accuracy(&folder, &arguments);
    let object = json(&output);
    let of = |row: usize, name: &str| object["rows"][row][name].as_f64().expect("a number");
    // The reading's model of another sample of strokes of this range: 3.0 counts without, 0.96 with three guard stages.
    assert!((1.5..4.0).contains(&of(0, "max_deviation")) && (0.7..1.2).contains(&of(1, "max_deviation")), "{object}");
    assert_eq!((of(0, "end_error"), of(1, "end_error"), output.status.code()), (0.0, 0.0, Some(0)));
    assert!(of(0, "reversals") > 50.0, "steps of J and K that oppose each other: {object}");
    assert_refused(&accuracy(&folder, &["us3809868/fig09_function_generator", "--max", "4096"]), "A002");
    assert_refused(&accuracy(&folder, &["us3809868/fig09_function_generator", "--checkpoint", "x"]), "C008");
}

#[test]
fn the_csv_has_a_row_for_each_degree_and_no_deviation_in_it_is_beyond_the_law() {
    let folder = folder();
    assert_eq!(
        accuracy(&folder, &["su1522157/interpolator", "--max", "255", "--csv", "slopes.csv"]).status.code(),
        Some(0)
    );
    let mut reader = csv::Reader::from_path(folder.path().join("slopes.csv")).expect("the file");
    let rows: Vec<Vec<f64>> = reader
        .records()
        .map(|row| row.expect("a row").iter().map(|field| field.parse().expect("a number")).collect())
        .collect();
    assert_eq!(rows.len(), 45);
    for row in &rows {
        let [from, to, _, major, minor, deviation, law, printed] = row[..] else { panic!("{row:?}") };
        let angle = minor.atan2(major);
        assert!((from..=to).contains(&angle.to_degrees()), "{row:?}");
        // The law as the text has it: 0.3953 sin(71 degrees 35 minutes + a).
        let text = 0.3953 * (angle + (71.0_f64 + 35.0 / 60.0).to_radians()).sin();
        assert!((printed - text).abs() < 1e-9 && (law - text).abs() < 1e-4 && deviation <= law + 1e-12, "{row:?}");
    }
}

#[test]
fn what_accuracy_does_not_know_is_told_with_what_it_knows() {
    let folder = folder();
    let unknown = accuracy(&folder, &["su1522157/multiplexer_21"]);
    assert_refused(&unknown, "A001");
    for known in ["su1522157/interpolator", "su1522157/prototype", "reference/koren_dda"] {
        assert!(String::from_utf8_lossy(&unknown.stderr).contains(known), "{known}");
    }
    assert_refused(&accuracy(&folder, &["su1522157/interpolater"]), "C001");
}

#[test]
fn a_projection_beyond_the_word_is_refused() {
    let folder = folder();
    assert_refused(&accuracy(&folder, &["su1522157/interpolator", "--max", "4096"]), "A002");
    assert_refused(&accuracy(&folder, &["su1522157/prototype", "--max", "16", "-p", "WIDTH=4"]), "A002");
    assert_refused(&accuracy(&folder, &["reference/bresenham", "--max", "65536"]), "A002");
}

#[test]
fn options_that_do_nothing_are_refused() {
    let folder = folder();
    assert_refused(&accuracy(&folder, &["reference/bresenham", "--checkpoint", "x"]), "C008");
    assert_refused(&accuracy(&folder, &["su1522157/interpolator", "-p", "WIDTH=4", "-p", "WIDTH=5"]), "C007");
    assert_refused(&accuracy(&folder, &["su1522157/interpolator", "--csv", "a", "--checkpoint", "a"]), "C030");
}

#[test]
fn a_measuring_scenario_of_ones_own_is_taken_and_a_wrong_one_is_told() {
    let folder = folder();
    let scenario = |combined: &str| {
        format!(
            "circuit = \"su1522157/measured_interpolator\"\n[inputs]\nx_is_major_35 = 1\n[[at]]\ntick = 0\nset = {{ start_33 = 1 }}\n\
             [[at]]\ntick = 1\nset = {{ start_33 = 0 }}\n[stop]\nuntil = \"!busy\"\nlimit = 1000\n[measure]\nof = \"mine\"\n\
             major = \"major_32\"\nminor = \"minor_34\"\ncombined = {combined}\nlaw = {{ sin = 0.1, cos = 0.1 }}\nend = 0.25\n"
        )
    };
    let path = folder.path().join("mine.toml");
    std::fs::write(&path, scenario("0.75")).expect("a file");
    let output = accuracy(&folder, &["mine.toml", "--max", "20", "--json"]);
    assert!(
        json(&output)["violations"].as_u64() > Some(0) && output.status.code() == Some(1),
        "so small a law is broken"
    );
    std::fs::write(&path, scenario("0.7")).expect("a file");
    assert_refused(&accuracy(&folder, &["mine.toml"]), "A003");
}

#[test]
fn a_measurement_goes_on_from_its_checkpoint_and_from_no_other() {
    let folder = folder();
    let whole = json(&accuracy(&folder, &["su1522157/interpolator", "--max", "60", "--json", "--checkpoint", "whole"]));

    let path = folder.path().join("whole");
    let mut kept: Value = serde_json::from_str(&std::fs::read_to_string(&path).expect("the file")).expect("JSON");
    for (name, value) in [("segments", 1891), ("violations", 0)] {
        assert_eq!(kept["tally"][name], value, "{name}");
    }
    let arguments = ["su1522157/interpolator", "--max", "60", "--json", "--checkpoint", "whole", "--resume"];
    assert_eq!(json(&accuracy(&folder, &arguments)), whole, "nothing is left to do");
    kept["of"]["max"] = 61.into();
    std::fs::write(&path, kept.to_string()).expect("a file");
    assert_refused(&accuracy(&folder, &arguments), "C066");
    std::fs::write(&path, "{}").expect("a file");
    assert_refused(&accuracy(&folder, &arguments), "C066");
}

#[test]
#[cfg(target_os = "linux")]
fn an_interrupted_measurement_goes_on_and_comes_to_the_same() {
    let folder = folder();
    let arguments = ["su1522157/interpolator", "--max", "1023", "--json", "--checkpoint", "kept"];
    let mut command = Command::new(env!("CARGO_BIN_EXE_stepwright"));
    let started =
        command.current_dir(folder.path()).arg("accuracy").args(arguments).stderr(std::process::Stdio::piped()).spawn();
    let child = started.expect("the program starts");
    std::thread::sleep(std::time::Duration::from_millis(200));
    let killed = Command::new("kill").args(["-INT", &child.id().to_string()]).status().expect("kill");
    assert!(killed.success());
    let output = child.wait_with_output().expect("it ends");
    let text = String::from_utf8_lossy(&output.stderr);
    assert!(
        output.status.code() == Some(1) && text.contains("--resume") && text.contains("of 524800 segments"),
        "{text}"
    );
    let resumed = accuracy(&folder, &[&arguments[..], &["--resume"]].concat());
    assert_eq!(json(&resumed), json(&accuracy(&folder, &arguments[..4])));
}

#[test]
fn the_picture_shows_the_law_and_the_measured_points_and_an_unwritable_one_is_refused_before_anything_runs() {
    let folder = folder();
    assert_eq!(
        accuracy(&folder, &["su1522157/prototype", "--max", "100", "--svg", "a.svg", "--png", "a.png"]).status.code(),
        Some(0)
    );
    let svg = std::fs::read_to_string(folder.path().join("a.svg")).expect("a file");
    let png = std::fs::read(folder.path().join("a.png")).expect("a file");
    assert!(png.starts_with(b"\x89PNG") && png.len() > 10_000);
    // A point for each degree of slope.
    assert_eq!(svg.matches("<circle").count(), 45);
    for text in ["law", "X up to 100", "degrees", "whole steps", "stepwright accuracy su1522157/prototype --max 100"] {
        assert!(svg.contains(text), "{text}");
    }
    assert_refused(&accuracy(&folder, &["su1522157/prototype", "--max", "4095", "--svg", "nowhere/a.svg"]), "C003");
}
