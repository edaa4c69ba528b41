//! Tables and pictures of `run`, and what it says of a run that was changed by hand.

use std::fs;

use super::{folder, refuses, stderr, stdout, stepwright, stepwright_in, succeeds, written};

/// The lines of the picture: those before the first blank one.
fn picture(arguments: &[&str]) -> Vec<String> {
    let text = succeeds(arguments);
    text.lines().take_while(|line| !line.is_empty()).map(str::to_owned).collect()
}

#[test]
fn a_path_begins_where_the_counters_stand_at_the_start() {
    let drawn = picture(&["run", "us3809868/fig09_function_generator", "-s", "x0=300", "-s", "y0=-100"]);
    // The stroke of the default scenario is 200 to the right and 120 up; the labels are the ends of what was drawn.
    assert_eq!(drawn.first().unwrap().split_whitespace().last(), Some("20"));
    assert_eq!(drawn[drawn.len() - 2].split_whitespace().last(), Some("-100"));
    assert_eq!(drawn.last().unwrap().split_whitespace().collect::<Vec<_>>(), ["300", "500"]);
    assert!(drawn.iter().all(|line| line.trim_end() == line), "no blanks at line ends");
    let run = succeeds(&["run", "us3809868/signs_1", "--plot", "--json"]);
    let object: serde_json::Value = serde_json::from_str(&run).unwrap();
    let scenario = succeeds(&["show", "us3809868/signs_1", "--json"]);
    let scenario: serde_json::Value = serde_json::from_str(&scenario).unwrap();
    let start = ["x0", "y0"].map(|name| scenario["keys"]["inputs"][name].as_f64().unwrap_or(0.0));
    assert_eq!(object["path"][0][0], serde_json::json!(start));
}

#[test]
fn a_pen_that_is_up_draws_nothing() {
    let folder = folder();
    let text = |pen: &str| {
        format!(
            "circuit = \"su1522157/interpolator\"\n[inputs]\nmajor_32 = 8\n[[at]]\ntick = 1\nset = {{ start_33 = 1 }}\n\
             [[at]]\ntick = 2\nset = {{ start_33 = 0 }}\n[stop]\nuntil = \"!busy\"\nlimit = 1000\n\
             [plot]\nx = {{ step_y_37 = 1 }}\ny = {{ step_y_37 = 1 }}\npen = \"{pen}\"\n"
        )
    };
    let strokes = |pen: &str| {
        written(folder.path(), "pen.toml", text(pen));
        let output = stepwright_in(folder.path(), &["run", "pen.toml", "--plot", "--json"]);
        let object: serde_json::Value = serde_json::from_str(&stdout(&output)).expect("one JSON object");
        object["path"].as_array().expect("strokes").len()
    };
    assert_eq!((strokes("busy"), strokes("step_x_36")), (1, 0));
}

#[test]
fn title_and_expectations_are_those_of_the_scenario_as_written() {
    assert!(succeeds(&["run", "su1522157/table1"]).contains("Table 1 of the patent"));
    for change in [&["-s", "major_32=127"][..], &["-p", "WIDTH=9"], &["--limit", "3000"]] {
        let text = succeeds(&[&["run", "su1522157/table1"], change].concat());
        assert!(!text.contains("Table 1") && text.contains("su1522157/interpolator\n"), "{change:?}: {text}");
    }
}

#[test]
fn expectations_may_be_about_inner_nets() {
    let folder = folder();
    let frame = stdout(&stepwright(&["show", "--source", "su1522157/table1"]));
    let with = |line: &str| {
        written(folder.path(), "frame.toml", frame.replace("stopped_by = \"until\"", line));
        stepwright_in(folder.path(), &["run", "frame.toml"])
    };
    assert!(with("outputs = { mode_4 = 0, counter_14.count = 0 }").status.code() == Some(2), "a dotted key is a table");
    assert!(with("outputs = { mode_4 = 0, \"accumulator_1.sign\" = 0 }").status.success());
    let output = with("outputs = { mode_4 = 1 }");
    assert_eq!(output.status.code(), Some(1));
    assert!(stderr(&output).contains("expected mode_4 1, got 0"), "{}", stderr(&output));
}

#[test]
fn columns_and_rows_of_a_table_can_be_chosen() {
    let table =
        succeeds(&["run", "su1522157/table1", "--table", "--columns", "step_x_36,step_xy_38", "--when", "step_xy_38"]);
    let rows: Vec<Vec<_>> = table.lines().take(5).map(|line| line.split_whitespace().collect()).collect();
    assert_eq!(rows[0], ["tick", "step_x_36", "step_xy_38"]);
    assert!(rows[1..].iter().all(|row| row[1..] == [".", "1"]), "{table}");
    let csv = succeeds(&["run", "su1522157/table1", "--csv", "-", "--columns", "step_xy_38", "--when", "step_xy_38"]);
    assert_eq!(csv.lines().collect::<Vec<_>>(), ["tick,step_xy_38", "24,1", "32,1", "40,1", "48,1"]);
    refuses(&stepwright(&["run", "su1522157/table1", "--table", "--columns", "f_2"]), &["W003", "did you mean `f_1`?"]);
}

#[test]
fn a_waveform_goes_to_standard_output_or_where_its_ending_says() {
    let output = stepwright(&["run", "su1522157/table1", "--vcd", "-"]);
    let vcd = stdout(&output);
    assert!(vcd.starts_with('$') && vcd.ends_with("#57\n"), "only the waveform is there");
    assert!(stderr(&output).contains("57 ticks"), "the result is told elsewhere");
    let folder = folder();
    let output = stepwright_in(folder.path(), &["run", "su1522157/table1", "--wave", "a.vcd", "--wave", "b.fst"]);
    assert!(output.status.success());
    assert_eq!(fs::read_to_string(folder.path().join("a.vcd")).unwrap(), vcd);
    assert!(fs::read(folder.path().join("b.fst")).unwrap().len() > 100);
}

#[test]
fn the_default_limit_covers_the_longest_frame() {
    let text = succeeds(&["run", "su1522157/interpolator", "-s", "major_32=4095", "-s", "minor_34=0"]);
    assert!(text.contains("stopped by until") && text.contains("4095 pulses"), "{text}");
}
