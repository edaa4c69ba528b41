//! What a scenario says its inputs have to satisfy.

use stepwright::simulation::shipped;

use super::{folder, stderr, stdout, stepwright, stepwright_in, succeeds, written};

const WARNING: &str = "warning: the inputs should satisfy minor_34 <= major_32";

#[test]
fn run_warns_of_inputs_that_the_circuit_is_not_made_for_and_goes_on() {
    let output = stepwright(&["run", "su1522157/interpolator", "-s", "major_32=8", "-s", "minor_34=9", "--json"]);
    assert_eq!(output.status.code(), Some(0));
    assert_eq!(stderr(&output), format!("{WARNING}, but at tick 0 that is 9 <= 8\n"));
    let object: serde_json::Value = serde_json::from_str(&stdout(&output)).expect("one JSON object");
    assert_eq!(object["warnings"].as_array().map(Vec::len), Some(1));
    for minor in ["minor_34=8", "minor_34=0"] {
        let output = stepwright(&["run", "su1522157/interpolator", "-s", "major_32=8", "-s", minor]);
        assert_eq!(stderr(&output), "", "{minor}");
    }
}

#[test]
fn it_is_judged_in_every_tick_that_changes_inputs_and_with_their_signs() {
    let folder = folder();
    let text = "circuit = \"us3809868/fig09_function_generator\"\nrequire = [\"x0 >= -3\", \"j != 7\"]\n\
        [[at]]\ntick = 4\nset = { x0 = -4, j = 7 }\n[[at]]\ntick = 9\nset = { x0 = -5, j = 0 }\n[stop]\nticks = 12\n";
    written(folder.path(), "a.toml", text);
    let output = stepwright_in(folder.path(), &["run", "a.toml"]);
    let said = stderr(&output);
    assert_eq!(said.lines().count(), 2, "each requirement once: {said}");
    assert!(said.contains("x0 >= -3, but at tick 4 that is -4 >= -3"), "{said}");
    assert!(said.contains("j != 7, but at tick 4 that is 7 != 7"), "{said}");
}

#[test]
fn a_sweep_counts_the_rows_that_do_not_satisfy_it() {
    let sweep = ["sweep", "su1522157/interpolator", "--over", "major_32=0..=3", "--over", "minor_34=0..=3"];
    let output = stepwright(&sweep);
    assert_eq!(output.status.code(), Some(0));
    // Of 16 pairs, six have the greater second.
    assert_eq!(stderr(&output), format!("{WARNING}, but in 6 of 16 rows they do not\n"));
    assert_eq!(stdout(&output).lines().count(), 17);
}

#[test]
fn every_shipped_scenario_of_the_interpolator_requires_the_lesser_projection_to_be_so() {
    let of_it = shipped::names("toml").filter(|name| {
        let text = shipped::text(&format!("{name}.toml")).expect("it is shipped");
        text.contains("circuit = \"su1522157/interpolator\"")
    });
    for name in of_it {
        let scenario = succeeds(&["show", &format!("{name}.toml"), "--json"]);
        assert!(scenario.contains("\"require\":[\"minor_34 <= major_32\"]"), "{name}");
    }
}
