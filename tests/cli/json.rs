//! The JSON objects of the commands.

use serde_json::{Value, json};

use super::{ROOT, folder, stdout, stepwright, stepwright_in, succeeds};

fn object(text: &str) -> Value {
    serde_json::from_str(text).expect("one JSON object")
}

#[test]
fn every_object_tells_its_form_and_its_command() {
    let golden = format!("{ROOT}/traces/su1522157/table1.vcd");
    for arguments in [
        &["run", "su1522157/table1", "--json"][..],
        &["list", "--json"],
        &["list", "blocks", "--json"],
        &["show", "su1522157/interpolator", "--json"],
        &["show", "su1522157/table1", "--json"],
        &["show", "summer", "--json"],
        &["show", "su1522157/interpolator.counter_14", "--json"],
        &["check", "su1522157/table1", "--json"],
        &["diff", &golden, &golden, "--json"],
    ] {
        let object = object(&succeeds(arguments));
        assert_eq!((&object["format"], &object["command"]), (&json!(1), &json!(arguments[0])), "{arguments:?}");
    }
}

#[test]
fn run_holds_the_table_and_the_path_when_they_are_asked_for() {
    let run = |more: &[&str]| object(&succeeds(&[&["run", "su1522157/table1", "--json"], more].concat()));
    let plain = run(&[]);
    assert!(plain.get("table").is_none() && plain.get("path").is_none());
    let asked = run(&["--table", "--plot", "--columns", "step_x_36,step_xy_38"]);
    assert_eq!(asked["table"]["columns"], json!(["tick", "step_x_36", "step_xy_38"]));
    // Table 1 of the patent: nine steps by turns, whole ones first; then the overflow.
    let steps: Vec<_> =
        asked["table"]["rows"].as_array().unwrap().iter().map(|row| (row[1].clone(), row[2].clone())).collect();
    let expected: Vec<_> =
        (0..9).map(|step| (json!(1 - step % 2), json!(step % 2))).chain([(json!(0), json!(0))]).collect();
    assert_eq!(steps, expected);
    let path = asked["path"][0].as_array().unwrap();
    assert_eq!((path.first(), path.last()), (Some(&json!([0.0, 0.0])), Some(&json!([8.0, 3.0]))));
}

#[test]
fn list_names_circuits_scenarios_and_blocks() {
    let listed = object(&succeeds(&["list", "--json"]));
    let circuits = listed["circuits"].as_array().unwrap();
    let circuit = circuits.iter().find(|circuit| circuit["name"] == "su1522157/interpolator").expect("it is shipped");
    let scenarios = circuit["scenarios"].as_array().unwrap();
    assert!(scenarios.contains(&json!({ "name": "su1522157/tie_7_3", "title": "A tie, F0 = 0: X = 7, Y = 3" })));
    let blocks = object(&succeeds(&["list", "blocks", "--json"]));
    let names: Vec<_> = blocks["blocks"].as_array().unwrap().iter().map(|block| &block["name"]).collect();
    assert!(names.contains(&&json!("binary_rate_multiplier")) && names.len() > 40, "{names:?}");
}

#[test]
fn show_tells_ports_parameters_and_connections() {
    let circuit = object(&succeeds(&["show", "su1522157/interpolator", "--json"]));
    assert_eq!(circuit["kind"], "circuit");
    assert_eq!(circuit["parameters"]["WIDTH"], 12);
    let port = json!({ "name": "major_32", "direction": "input", "width": 12, "signed": false, "fraction": null });
    assert_eq!(circuit["ports"][0], port);
    let counter = object(&succeeds(&["show", "su1522157/interpolator.counter_14", "--json"]));
    assert_eq!(
        circuit["instances"].as_array().unwrap().iter().find(|one| one["name"] == "counter_14").unwrap()["of"],
        counter["of"]
    );
    assert_eq!(counter["block"]["name"], "subtracting_counter");
    let nets =
        |port: &str| counter["ports"].as_array().unwrap().iter().find(|p| p["name"] == port).unwrap()["nets"].clone();
    assert_eq!(
        (nets("word"), nets("count"), nets("overflow")),
        (json!("major_32"), json!("r_14"), json!("overflow_14"))
    );
    let scenario = object(&succeeds(&["show", "su1522157/table1", "--json"]));
    assert_eq!(scenario["keys"]["inputs"], json!({ "major_32": 8, "minor_34": 3, "x_is_major_35": 1 }));
    assert!(scenario["notes"].as_str().unwrap().starts_with("One row for each step"));
}

#[test]
fn diff_tells_the_first_difference_and_how_many_samples_differ() {
    let folder = folder();
    let run = |name: &str, minor: &str| {
        stepwright_in(folder.path(), &["run", "su1522157/table1", "-s", minor, "--vcd", name, "--trace", "minor_34"])
    };
    assert!(run("a.vcd", "minor_34=3").status.success() && run("b.vcd", "minor_34=4").status.success());
    let output = stepwright_in(folder.path(), &["diff", "a.vcd", "b.vcd", "--json"]);
    assert_eq!(output.status.code(), Some(1));
    let diff = object(&stdout(&output));
    assert_eq!(diff["equal"], false);
    assert_eq!(diff["first"], json!({ "tick": 0, "net": "interpolator.minor_34", "a": 3, "b": 4 }));
    // An input that is held differs in every one of the 57 ticks of either frame.
    assert_eq!(diff["differing"], json!({ "interpolator.minor_34": 57 }));
    assert_eq!((&diff["only_a"], &diff["only_b"]), (&json!([]), &json!([])));
}

#[test]
fn check_tells_each_scenario() {
    let output = stepwright(&["check", "su1522157/table1", "us3809868/brm12", "--json"]);
    let check = object(&stdout(&output));
    assert_eq!((&check["equal"], &check["different"], &check["broken"]), (&json!(2), &json!(0), &json!(0)));
    let first = &check["scenarios"][0];
    assert_eq!((&first["result"], &first["golden"]), (&json!("equal"), &json!("traces/su1522157/table1.vcd")));
}
