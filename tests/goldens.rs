//! Every golden trace, on every engine. A golden trace that gets lost, or its scenario, must not go unseen: both are
//! counted off against each other, here and by `check`.

use std::collections::BTreeSet;
use std::path::Path;
use std::process::Command;

use rayon::prelude::*;
use stepwright::files;
use stepwright::simulation::{EngineKind, shipped};

#[test]
fn every_scenario_equals_its_golden_trace_on_every_engine() {
    EngineKind::all().collect::<Vec<_>>().into_par_iter().for_each(|engine| {
        let output = Command::new(env!("CARGO_BIN_EXE_stepwright"))
            .current_dir(env!("CARGO_MANIFEST_DIR"))
            .args(["check", "--engine", engine.name()])
            .env_remove("STEPWRIGHT_BLESS")
            .output()
            .expect("the binary starts");
        let text = String::from_utf8_lossy(&output.stdout);
        let all = shipped::names("toml").count();
        let tally = format!("{all} equal, 0 blessed, 0 different, 0 broken");
        assert_eq!(text.lines().last(), Some(tally.as_str()), "{engine}:\n{text}");
    });
}

#[test]
fn every_circuit_has_a_default_scenario() {
    for circuit in shipped::names("v") {
        assert!(shipped::text(&format!("{circuit}.toml")).is_some(), "{circuit}");
    }
}

#[test]
fn every_scenario_has_a_golden_trace_and_every_golden_trace_its_scenario() {
    let traces = Path::new(env!("CARGO_MANIFEST_DIR")).join("traces");
    let goldens: BTreeSet<_> = files::below(&traces, "vcd")
        .into_iter()
        .map(|path| path.strip_prefix(&traces).expect("below").with_extension("").display().to_string())
        .collect();
    let scenarios: BTreeSet<_> = shipped::names("toml").map(str::to_owned).collect();
    let lost: Vec<_> = scenarios.difference(&goldens).collect();
    let extra: Vec<_> = goldens.difference(&scenarios).collect();
    assert!(lost.is_empty() && extra.is_empty(), "without a golden trace: {lost:?}; without a scenario: {extra:?}");
}
