//! `stepwright check`: scenarios against their golden traces and expectations.

mod arguments;
mod places;
mod since;
mod verdict;

use std::path::{Path, PathBuf};

use rayon::prelude::*;
use serde_json::Value;

use super::diff::first;
use super::drivers::drivers;
use super::observers::selection;
use super::{Ending, check_files, complain, print, say};
use crate::base::{Diagnostic, Report};
use crate::files::{self, Scratch, Text};
use crate::golden::{self, Cause, Comparison, Input, Summary};
use crate::simulation::{Circuit, Design, EngineKind, Session};
use crate::trace::{VCD, Wave};
pub use arguments::CheckArguments;
use since::Older;
use verdict::{Kind, Verdict};

pub(super) fn check(arguments: &CheckArguments) -> Result<Ending, Report> {
    let CheckArguments { scenarios: named, json, .. } = arguments;
    let bless = arguments.bless || set("STEPWRIGHT_BLESS");
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
    let how =
        How { bless, engine: arguments.engine, since: arguments.since.as_deref().map(Older::checked_out).transpose()? };
    let judged: Vec<_> = scenarios.par_iter().map(|path| judge_one(path, &how)).collect();
    let mut verdicts = Vec::new();
    for (verdict, report) in judged {
        report.iter().for_each(complain);
        verdicts.push(verdict);
    }
    if is_all {
        verdicts.extend(lost_goldens(&verdicts));
    }
    verdict::tell_causes_once(&mut verdicts);
    if *json {
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

/// What is done with every scenario.
struct How {
    bless: bool,
    engine: EngineKind,
    since: Option<Older>,
}

/// The verdict on a scenario, and what is wrong with one that cannot be run.
fn judge_one(path: &Path, how: &How) -> (Verdict, Option<Report>) {
    let session = Session::open(path);
    let said = session.as_ref().ok().and_then(|session| session.scenario().golden.as_deref());
    let golden = places::golden(path, said);
    let mut verdict = Verdict::new(path, golden, Kind::Broken);
    let ran = session.and_then(|session| Ran::session(session.engine(how.engine)));
    let since = how.since.as_ref();
    let judged = ran.and_then(|ran| if how.bless { ran.bless(&mut verdict) } else { ran.judge(&mut verdict, since) });
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
    text: Option<Text>,
    trace: Scratch,
    ticks: u64,
    failed: Vec<String>,
    engine: &'static str,
}

impl Ran {
    fn session(session: Session) -> Result<Self, Report> {
        let text = session.scenario_file().cloned();
        let design = session.elaborate()?;
        let trace = Scratch::create()?;
        let wave = Wave::new(VCD, trace.writer()).of(selection(&[], design.scenario())?);
        let mut run = design.start_with(vec![Box::new(wave)])?;
        let outcome = run.finish()?;
        let failed = run.failed_expectations(&design.scenario().expect, &outcome);
        let engine = run.engine();
        drop(run);
        Ok(Self { trace, ticks: outcome.ticks, failed, engine, design, text })
    }

    fn input(&self) -> Input {
        input("the run", &self.trace)
    }

    /// Compares with the golden trace and the expectations.
    fn judge(self, verdict: &mut Verdict, since: Option<&Older>) -> Result<(), Report> {
        let golden = &verdict.golden;
        let (mut wrong, mut signals) = (self.failed.clone(), 0);
        if golden.is_file() {
            let found = golden::check(&Input::file(golden), &self.input())?;
            signals = found.nets;
            verdict.first = found.divergence.as_ref().map_or(Value::Null, first);
            if !found.is_equal() {
                wrong.push(self.explain(&found, golden));
                let (causes, note) = self.causes(golden, since)?;
                verdict.causes = causes;
                wrong.extend((!note.is_empty()).then_some(note));
                wrong.push(how_to_bless(&verdict.scenario));
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

    /// The first difference, and how to look at it.
    fn explain(&self, found: &Comparison, golden: &Path) -> String {
        let (circuit, engine) = (self.design.circuit().name(), self.engine);
        format!("circuit {circuit}, engine {engine}\n{found}to look: gtkwave {}", golden.display())
    }

    /// The nets that first went wrong, by the golden trace or by all nets of an older netlist, and what to say of that.
    fn causes(&self, golden: &Path, since: Option<&Older>) -> Result<(Vec<Cause>, String), Report> {
        let known = drivers(self.design.netlist());
        let plain = golden::How::default();
        let Some(since) = since else {
            let (_, causes) = golden::explain(&Input::file(golden), &self.input(), &plain, &known)?;
            let is_unsure = causes.iter().any(|cause| cause.untraced > 0);
            return Ok((causes, if is_unsure { HOW_TO_BE_SURE.to_owned() } else { String::new() }));
        };
        let name = &since.name;
        let Some(older) = self.older(since) else {
            return Ok((
                Vec::new(),
                format!("at {name} there is no circuit that runs this scenario: no cause is known"),
            ));
        };
        let (old, new) = (input(name, &whole(&older)?), input("the run", &whole(&self.design)?));
        let (_, causes) = golden::explain(&old, &new, &plain, &known)?;
        let same = format!("the netlist of {name} does the same: the golden trace is not of it");
        let note = if causes.is_empty() { same } else { String::new() };
        Ok((causes, note))
    }

    /// The older netlist with the present scenario.
    fn older(&self, since: &Older) -> Option<Design> {
        let circuit = self.design.files().first().and_then(|now| since.file(now))?;
        let text = self.text.as_ref()?;
        let session = Circuit::open(circuit).and_then(|circuit| circuit.scenario(&text.name, &text.text));
        session.and_then(|session| session.engine(self.design.engine()).elaborate()).ok()
    }
}

/// What to do where a golden trace lacks the net in question.
const HOW_TO_BE_SURE: &str = "to compare every net with an older netlist: --since HEAD, or another revision";

/// The trace of every net.
fn whole(design: &Design) -> Result<Scratch, Report> {
    let trace = Scratch::create()?;
    design.start_with(vec![Box::new(Wave::new(VCD, trace.writer()))])?.finish()?;
    Ok(trace)
}

fn input(name: &str, trace: &Scratch) -> Input {
    let trace = trace.clone();
    Input::new(name, move || Ok(trace.reader()))
}

/// Golden traces whose scenario is gone: a lost scenario must not go unseen.
fn lost_goldens(verdicts: &[Verdict]) -> Vec<Verdict> {
    let known: Vec<_> = verdicts.iter().map(|verdict| verdict.golden.as_path()).collect();
    let all = files::below(Path::new("traces"), "vcd");
    let lost = all.into_iter().filter(|golden| !known.contains(&golden.as_path()));
    lost.map(|golden| Verdict::new(Path::new(""), golden, Kind::Lost)).collect()
}
