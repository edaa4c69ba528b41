//! Icarus and the interpreter agree on every net and every tick of every scenario.

use std::sync::Arc;

use rayon::prelude::*;
use stepwright::compile::{Observe, Program, compile};
use stepwright::engine::{Engine, Interpreter};
use stepwright::export::{self, BenchInputs};
use stepwright::netlist::{self, Netlist};
use stepwright::simulation::{Stimulus, resolve, run, shipped};
use stepwright::{base, scenario};

use super::tools;
use super::wave::{Variable, Wave};

#[test]
fn icarus_agrees_on_every_net_and_tick_of_every_scenario() {
    if !tools::present(&["iverilog", "vvp"]) {
        return;
    }
    let scenarios: Vec<_> = shipped::names("toml").collect();
    let on_disk = tools::files_below("circuits", "toml").len();
    assert!(on_disk > 0 && scenarios.len() == on_disk, "{} scenarios of {on_disk}", scenarios.len());
    let judged = scenarios.par_iter().map(|name| judge_scenario(name));
    let wrong: Vec<String> = judged.filter_map(Result::err).collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Runs a scenario here and there.
fn judge_scenario(name: &str) -> Result<(), String> {
    let (netlist, stimulus) = load(name).map_err(|report| report.to_string())?;
    judge(name, &netlist, &stimulus)
}

/// Runs a circuit here and there; an error tells the first net and tick on which they differ.
pub fn judge(name: &str, netlist: &Netlist, stimulus: &Stimulus) -> Result<(), String> {
    let program = Arc::new(compile(netlist, &observe(stimulus)));
    let mut engine = Interpreter::new(Arc::clone(&program));
    let ticks = run(&mut engine, &program, stimulus, None).ticks;
    let wave = icarus(netlist, stimulus, ticks);

    let theirs = variables(name, &program, &wave)?;
    let mut difference = None;
    let mut compare = |tick, engine: &dyn Engine| {
        for (signal, theirs) in program.signals.iter().zip(&theirs) {
            let (ours, theirs) = (engine.value(signal.value), theirs.at(tick));
            if theirs != Some(ours) && difference.is_none() {
                let net = signal.name();
                difference = Some(format!("{name}, tick {tick}, {net}: {ours} here, {theirs:?} in Icarus"));
            }
        }
    };
    run(&mut Interpreter::new(Arc::clone(&program)), &program, stimulus, Some(&mut compare));
    difference.map_or(Ok(()), Err)
}

fn load(name: &str) -> Result<(Netlist, Stimulus), base::Report> {
    let file = |path: String| (shipped::text(&path).unwrap_or_else(|| panic!("no {path}")), path);
    let (text, path) = file(format!("{name}.toml"));
    let scenario = scenario::parse(&path, text)?;
    let (text, path) = file(format!("{}.v", scenario.circuit));
    let parameters: Vec<_> = scenario.parameters.iter().map(|p| (p.name.clone(), p.value)).collect();
    let shelf = shipped::Shelf { near: &scenario.circuit };
    let netlist = netlist::load(&path, text, None, &shelf, &parameters)?;
    let stimulus =
        resolve(&netlist, &scenario).map_err(|errors| base::Report::new(base::Sources::default(), errors))?;
    Ok((netlist, stimulus))
}

fn observe(stimulus: &Stimulus) -> Observe<'static> {
    Observe { until: stimulus.stop.until, ..Observe::EVERYTHING }
}

fn icarus(netlist: &Netlist, stimulus: &Stimulus, ticks: u64) -> Wave {
    let folder = tempfile::tempdir().expect("a folder");
    let inputs = BenchInputs { initial: &stimulus.initial, changes: &stimulus.changes, ticks };
    for file in export::files(netlist, inputs) {
        std::fs::write(folder.path().join(&file.name), &file.text).expect("a file");
    }
    tools::icarus(folder.path(), &export::bench_name(netlist));
    Wave::of_bench(&folder.path().join("bench.vcd"))
}

/// Icarus' variable for each of our signals; none may be missing.
fn variables<'w>(name: &str, program: &Program, wave: &'w Wave) -> Result<Vec<Variable<'w>>, String> {
    assert!(!program.signals.is_empty(), "{name}: nothing to compare");
    let find = |signal: &base::Signal| {
        let path = signal.path.join(".");
        wave.find(&path).ok_or_else(|| format!("{name}: Icarus shows no {path}"))
    };
    program.signals.iter().map(find).collect()
}
