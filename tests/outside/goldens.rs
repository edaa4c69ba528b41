//! GTKWave's own tools accept every golden trace, and it shows every row that the save file of a scenario names.

use std::fs::File;
use std::io::BufReader;
use std::path::Path;

use rayon::prelude::*;
use stepwright::golden::{Signals, Waveform, compare, read_golden};

use super::tools::{self, files_below, run};

fn read(path: &Path) -> Waveform {
    let file = BufReader::new(File::open(path).expect("a waveform"));
    read_golden(&path.display().to_string(), file).unwrap_or_else(|report| panic!("{report}"))
}

#[test]
fn every_golden_trace_survives_the_way_through_gtkwaves_format_and_back() {
    if !tools::present(&["vcd2fst", "fst2vcd"]) {
        return;
    }
    let goldens = files_below("traces", "vcd");
    let scenarios = files_below("circuits", "toml").len();
    assert!(scenarios > 0 && goldens.len() == scenarios, "{} golden traces, {scenarios} scenarios", goldens.len());
    goldens.par_iter().for_each(|golden| {
        let folder = tempfile::tempdir().expect("a folder");
        // vcd2fst always exits 0; what it made of the trace shows on the way back.
        run(folder.path(), "vcd2fst", &[golden.to_str().expect("a plain path"), "golden.fst"]);
        run(folder.path(), "fst2vcd", &["-o", "golden.vcd", "golden.fst"]);
        let (before, after) = (read(golden), read(&folder.path().join("golden.vcd")));
        let comparison = compare(&before, &after, Signals::All);
        assert!(comparison.nets > 0 && comparison.is_equal(), "{}: {comparison}", golden.display());
    });
}

#[test]
fn gtkwave_shows_every_row_that_the_save_file_of_a_scenario_names() {
    if !tools::present(&["gtkwave", "xvfb-run", "xauth"]) {
        return;
    }
    let scenarios = files_below("circuits", "toml");
    assert!(!scenarios.is_empty());
    let check = concat!(env!("CARGO_MANIFEST_DIR"), "/.ci/gtkwave_check");
    for scenario in scenarios {
        let folder = tempfile::tempdir().expect("a folder");
        let scenario = scenario.to_str().expect("a plain path");
        let binary = env!("CARGO_BIN_EXE_stepwright");
        run(folder.path(), binary, &["run", scenario, "--vcd", "run.vcd", "--gtkw", "run.gtkw"]);
        run(folder.path(), check, &["run.vcd", "run.gtkw"]);
    }
}
