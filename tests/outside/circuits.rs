//! Icarus agrees on every net and every tick of every scenario with what `run` runs: the interpreter where it is short,
//! native code where it is long.

use rayon::prelude::*;
use stepwright::base::{Report, Signal, ValueId};
use stepwright::export;
use stepwright::simulation::{Design, Session, shipped};
use stepwright::trace::{Frame, Observer};

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
    let design = Session::open(name).and_then(Session::elaborate);
    judge(name, &design.map_err(|report| report.to_string())?)
}

/// Runs a design here and there; an error tells the first net and tick on which they differ.
pub fn judge(name: &str, design: &Design) -> Result<(), String> {
    let mut run = design.start_with(Vec::new()).map_err(|report| report.to_string())?;
    let ticks = run.finish().map_err(|report| report.to_string())?.ticks;
    held_against(&icarus(design, ticks), name, design)
}

/// Runs a design here and holds it against what Icarus wrote of it; an error tells the first net and tick on which they
/// differ.
pub fn held_against(wave: &Wave, name: &str, design: &Design) -> Result<(), String> {
    let mut judge = Judge { wave, signals: Vec::new(), difference: None };
    let mut run = design.start_with(vec![Box::new(&mut judge)]).map_err(|report| report.to_string())?;
    run.finish().map_err(|report| report.to_string())?;
    drop(run);
    assert!(!judge.signals.is_empty(), "{name}: nothing to compare");
    judge.difference.map_or(Ok(()), |difference| Err(format!("{name}, {difference}")))
}

/// What Icarus makes of an exported design, so many ticks.
pub fn icarus(design: &Design, ticks: u64) -> Wave {
    let folder = tempfile::tempdir().expect("a folder");
    for file in export::files(design.netlist(), design.stimulus(), ticks) {
        std::fs::write(folder.path().join(&file.name), &file.text).expect("a file");
    }
    tools::icarus(folder.path(), &export::bench_name(design.netlist()));
    Wave::of_bench(&folder.path().join("bench.vcd"))
}

/// Compares every signal at every tick with what Icarus wrote; none may be missing there.
struct Judge<'w> {
    wave: &'w Wave,
    signals: Vec<(Signal, Variable<'w>)>,
    difference: Option<String>,
}

impl Observer for Judge<'_> {
    fn wants(&self, _: &str) -> bool {
        true
    }

    fn begin(&mut self, signals: &[Signal]) -> Result<Vec<ValueId>, Report> {
        for signal in signals {
            match self.wave.find(&signal.path.join(".")) {
                Some(theirs) => self.signals.push((signal.clone(), theirs)),
                None => self.difference = Some(format!("Icarus shows no {}", signal.name())),
            }
        }
        Ok(self.signals.iter().map(|(signal, _)| signal.value).collect())
    }

    fn tick(&mut self, frame: Frame<'_>) -> Result<(), Report> {
        if self.difference.is_some() {
            return Ok(());
        }
        for ((signal, theirs), &ours) in self.signals.iter().zip(frame.words) {
            let theirs = theirs.at(frame.tick);
            if theirs != Some(ours) {
                let (tick, net) = (frame.tick, signal.name());
                self.difference = Some(format!("tick {tick}, {net}: {ours} here, {theirs:?} in Icarus"));
                return Ok(());
            }
        }
        Ok(())
    }

    fn end(&mut self) -> Result<(), Report> {
        Ok(())
    }
}
