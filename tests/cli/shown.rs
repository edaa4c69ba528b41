//! What `show` explains, and that everything shipped can be copied out.

use std::fs;

use stepwright::simulation::shipped;

use super::{ROOT, folder, refuses, stdout, stepwright, stepwright_in, succeeds};

/// Asserts that a page holds all of these.
fn shows(name: &str, parts: &[&str]) {
    let page = succeeds(&["show", name]);
    for part in parts {
        assert!(page.contains(part), "`{part}` is not on the page of {name}:\n{page}");
    }
}

#[test]
fn a_scenario_shows_its_notes_and_keys() {
    shows(
        "su1522157/table1",
        &["scenario su1522157/table1", "\nOne row for each step, with F and R", "\n[inputs]\nmajor_32 = 8"],
    );
    // A circuit's default scenario has its name; the ending tells which is meant.
    shows("su1522157/interpolator", &["circuit su1522157/interpolator", "(show su1522157/interpolator.toml)"]);
    shows("su1522157/interpolator.toml", &["scenario su1522157/interpolator", "\n[stop]\nuntil = \"!busy\""]);
}

#[test]
fn a_circuit_lists_its_instances_with_blocks_and_connections() {
    shows(
        "su1522157/interpolator",
        &[
            "instances\n    distributor_20             pulse_distributor          TAPS = 9, SPACING = 2\n",
            ".word({5'd0, minor_34}) .load(start_33)",
            ".subtract({and_16_out, and_17_out, or_12_out, tap_23})",
            "and_18                     and\n        .in0(and_16_out) .in1(x_is_major_5) .out(step_x_36)\n",
        ],
    );
}

#[test]
fn an_instance_is_shown_at_every_level() {
    let generator = "us3809868/fig09_function_generator.generator_16";
    shows(
        generator,
        &["module incremental_generator", "fig09_function_generator.v:", "FIG. 9", "\n    multiplier_262 "],
    );
    let multiplier = format!("{generator}.multiplier_262");
    shows(
        &multiplier,
        &[
            "block binary_rate_multiplier",
            "incremental_generator.v:",
            "WIDTH                12  ",
            "magnitude_j: ",
            "source: US 3,809,868",
        ],
    );
    shows(&format!("{generator}.not_busy"), &["gate not", "in0                  busy", "out                  idle"]);
    shows("us3809868/fig01_system.generator_16.generator_16.multiplier_262", &["block binary_rate_multiplier"]);
    let unknown = stepwright(&["show", &format!("{generator}.multiplier_26")]);
    refuses(&unknown, &["C009", "did you mean `generator_16.multiplier_262`?"]);
}

#[test]
fn the_circuit_of_a_path_with_dots_is_found() {
    let folder = folder();
    let source = stdout(&stepwright(&["show", "--source", "us3809868/brm12"]));
    fs::write(folder.path().join("my.brm12.v"), source.replace("module brm12", "module my_brm")).unwrap();
    for name in ["my.brm12.v", "./my.brm12", "./my.brm12.v"] {
        let output = stepwright_in(folder.path(), &["show", &format!("{name}.or_cascade")]);
        let output = if output.status.success() { output } else { stepwright_in(folder.path(), &["show", name]) };
        assert!(output.status.success() && stdout(&output).contains("sn7497"), "{name}: {}", super::stderr(&output));
    }
}

#[test]
fn everything_shipped_can_be_copied_out_of_any_folder() {
    let folder = folder();
    for ending in ["v", "toml", "glyphs"] {
        for name in shipped::names(ending) {
            let output = stepwright_in(folder.path(), &["show", "--source", &format!("{name}.{ending}")]);
            let file = fs::read_to_string(format!("{ROOT}/circuits/{name}.{ending}")).expect("a file");
            assert_eq!(stdout(&output), file, "{name}.{ending}");
        }
    }
}

#[test]
fn what_was_copied_out_runs_where_it_is() {
    let folder = folder();
    for name in ["us3809868/brm12.v", "us3809868/brm12.toml"] {
        let source = stdout(&stepwright(&["show", "--source", name]));
        fs::write(folder.path().join(name.rsplit('/').next().unwrap()), source).unwrap();
    }
    let here = stdout(&stepwright_in(folder.path(), &["run", "brm12.toml", "--json"]));
    assert_eq!(here, succeeds(&["run", "us3809868/brm12", "--json"]));
}

#[test]
fn the_source_of_a_block_or_instance_is_verilog() {
    assert!(succeeds(&["show", "--source", "summer"]).contains("module summer #("));
    let counter = succeeds(&["show", "--source", "su1522157/interpolator.counter_14"]);
    assert!(counter.contains("module subtracting_counter") && counter.contains("WIDTH == 12"), "{counter}");
    let module = succeeds(&["show", "--source", "us3809868/fig09_function_generator.generator_16"]);
    assert_eq!(module, shipped::text("us3809868/incremental_generator.v").unwrap());
}
