//! `stepwright check`: scenarios against their golden traces and expectations.

mod places;
mod verdict;

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use rayon::prelude::*;
use serde_json::Value;

use super::diff::first;
use super::drivers::drivers;
use super::observers::selection;
use super::{Ending, check_files, complain, print, say};
use crate::base::{Diagnostic, Report};
use crate::files::{self, Scratch};
use crate::golden::{self, Diff, Input, Summary};
use crate::simulation::{Design, EngineKind, Session};
use crate::trace::{VCD, Wave};
use verdict::{Kind, Verdict};

pub(super) fn check(named: &[PathBuf], bless: bool, engine: EngineKind, json: bool) -> Result<Ending, Report> {
    let bless = bless || set("STEPWRIGHT_BLESS");
    if bless && set("CI") {
        let diagnostic = Diagnostic::new("C005", "golden traces are not blessed in CI");
        return Err(diagnostic.help("bless where the waveforms can be looked at, and commit them").into());
    }
    let is_all = named.is_empty();
    let scenarios = if is_all { files::below(Path::new(places::ROOT), "toml") } else { places::scenarios(named)? };
    if scenarios.is_empty() {
        let place = if is_all { "./circuits" } else { "what was named" };
        say(&format!("there is nothing to check: no scenario below {place}"));
        return Ok(Ending::Nothing);
    }
    let judged: Vec<_> = scenarios.par_iter().map(|path| judge_one(path, bless, engine)).collect();
    let mut verdicts = Vec::new();
    for (verdict, report) in judged {
        report.iter().for_each(complain);
        verdicts.push(verdict);
    }
    if is_all {
        verdicts.extend(lost_goldens(&verdicts));
    }
    if json {
        print(&verdict::object(&verdicts))?;
    } else {
        verdicts.iter().try_for_each(|verdict| print(&verdict.lines()))?;
        print(&verdict::last_line(&verdicts))?;
    }
    Ok(verdict::ending(&verdicts))
}

fn set(name: &str) -> bool {
    std::env::var_os(name).is_some_and(|value| !value.is_empty() && value != "0")
}

/// The verdict on a scenario, and what is wrong with one that cannot be run.
fn judge_one(path: &Path, bless: bool, engine: EngineKind) -> (Verdict, Option<Report>) {
    let session = Session::open(path);
    let said = session.as_ref().ok().and_then(|session| session.scenario().golden.as_deref());
    let golden = places::golden(path, said);
    let mut verdict = Verdict::new(path, golden, Kind::Broken);
    let ran = session.and_then(|session| Ran::session(session.engine(engine)));
    let judged = ran.and_then(|ran| if bless { ran.bless(&mut verdict) } else { ran.judge(&mut verdict) });
    let report = judged.err();
    verdict.text = report.as_ref().map_or(verdict.text, Report::to_string);
    (verdict, report)
}

fn how_to_bless(scenario: &Path) -> String {
    format!("to accept what came out: stepwright check --bless {}", scenario.display())
}

/// A scenario that has been run and traced.
struct Ran {
    design: Design,
    trace: Scratch,
    ticks: u64,
    failed: Vec<String>,
    engine: &'static str,
}

impl Ran {
    fn session(session: Session) -> Result<Self, Report> {
        let design = session.elaborate()?;
        let trace = Scratch::create()?;
        let wave = Wave::new(VCD, trace.writer()).of(selection(&[], design.scenario())?);
        let mut run = design.start_with(vec![Box::new(wave)])?;
        let outcome = run.finish()?;
        let failed = run.failed_expectations(&design.scenario().expect, &outcome);
        let engine = run.engine();
        drop(run);
        Ok(Self { trace, ticks: outcome.ticks, failed, engine, design })
    }

    fn input(&self) -> Input {
        let trace = self.trace.clone();
        Input::new("the run", move || Ok(trace.reader()))
    }

    /// Compares with the golden trace and the expectations.
    fn judge(self, verdict: &mut Verdict) -> Result<(), Report> {
        let golden = &verdict.golden;
        let (mut wrong, mut signals) = (self.failed.clone(), 0);
        if golden.is_file() {
            let found = golden::check(&Input::file(golden), &self.input())?;
            signals = found.comparison.nets;
            verdict.first = found.comparison.divergence.as_ref().map_or(Value::Null, first);
            if !found.comparison.is_equal() {
                wrong.push(self.explain(&found, &verdict.scenario, golden));
            }
        } else {
            wrong.push(format!("there is no golden trace {}\n{}", golden.display(), how_to_bless(&verdict.scenario)));
        }
        verdict.kind = if wrong.is_empty() { Kind::Equal } else { Kind::Different };
        verdict.text = match wrong.as_slice() {
            [] => format!("{} ticks, {signals} signals", self.ticks),
            wrong => wrong.join("\n"),
        };
        verdict.failed = self.failed;
        Ok(())
    }

    /// Makes the run the golden trace, unless it is not what the scenario expects.
    fn bless(self, verdict: &mut Verdict) -> Result<(), Report> {
        let golden = &verdict.golden;
        check_files(self.design.files().iter().map(PathBuf::as_path), [golden.as_path()])?;
        if !self.failed.is_empty() {
            verdict.text = self.failed.join("\n");
            (verdict.kind, verdict.failed) = (Kind::Different, self.failed);
            return Ok(());
        }
        let old = golden.is_file().then(|| Input::file(golden));
        let summary = Summary::of(old.as_ref(), &self.input())?;
        if summary.is_unchanged() {
            (verdict.kind, verdict.text) = (Kind::Equal, "unchanged".to_owned());
            return Ok(());
        }
        if let Some(folder) = golden.parent() {
            std::fs::create_dir_all(folder).map_err(|error| files::unwritable(golden, &error))?;
        }
        files::copy(&mut self.trace.reader(), golden)?;
        verdict.text = format!("{}: {summary}", golden.display());
        verdict.kind = Kind::Blessed;
        Ok(())
    }

    /// The first difference, where it comes from, and what to do now.
    fn explain(&self, found: &Diff, scenario: &Path, golden: &Path) -> String {
        let Diff { comparison, around } = found;
        let mut text = format!("circuit {}, engine {}\n{comparison}", self.design.circuit().name(), self.engine);
        if let (Some(divergence), Some([expected, got])) = (&comparison.divergence, around) {
            let nets: Vec<_> = divergence.nets.iter().map(|net| net.name.as_str()).collect();
            let known = drivers(self.design.netlist());
            for cause in golden::causes(expected, got, &known, &nets, divergence.tick).iter().take(3) {
                let _ = writeln!(text, "{cause}");
            }
        }
        let _ = writeln!(text, "to look: gtkwave {}", golden.display());
        text + &how_to_bless(scenario)
    }
}

/// Golden traces whose scenario is gone: a lost scenario must not go unseen.
fn lost_goldens(verdicts: &[Verdict]) -> Vec<Verdict> {
    let known: Vec<_> = verdicts.iter().map(|verdict| verdict.golden.as_path()).collect();
    let all = files::below(Path::new("traces"), "vcd");
    let lost = all.into_iter().filter(|golden| !known.contains(&golden.as_path()));
    lost.map(|golden| Verdict::new(Path::new(""), golden, Kind::Lost)).collect()
}
