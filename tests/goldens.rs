//! Every golden trace, on every engine. A golden trace that gets lost, or its scenario, must not go unseen: both are
//! counted off against each other, here and by `check`.

use std::path::Path;
use std::process::Command;

use stepwright::simulation::{EngineKind, shipped};

#[test]
fn every_scenario_equals_its_golden_trace_on_every_engine() {
    for engine in EngineKind::ALL {
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
    }
}

#[test]
fn every_circuit_has_a_default_scenario() {
    for circuit in shipped::names("v") {
        assert!(shipped::text(&format!("{circuit}.toml")).is_some(), "{circuit}");
    }
}

#[test]
fn every_scenario_has_a_golden_trace() {
    for scenario in shipped::names("toml") {
        let golden = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("traces/{scenario}.vcd"));
        assert!(golden.is_file(), "{}", golden.display());
    }
}
