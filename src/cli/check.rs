//! `stepwright check`: scenarios against their golden traces and expectations.

use std::fmt::Write as _;
use std::io::{self, Cursor};
use std::path::{Component, Path, PathBuf};

use rayon::prelude::*;

use super::drivers::drivers;
use super::observers::selection;
use super::{Ending, check_files, complain, print, say};
use crate::base::{Diagnostic, Report};
use crate::files;
use crate::golden::{self, Diff, Input, Summary, Waveform};
use crate::simulation::{Design, EngineKind, Session};
use crate::trace::{VCD, Wave};

pub(super) fn check(named: &[PathBuf], bless: bool, engine: EngineKind) -> Result<Ending, Report> {
    let bless = bless || set("STEPWRIGHT_BLESS");
    if bless && set("CI") {
        let diagnostic = Diagnostic::new("C005", "golden traces are not blessed in CI");
        return Err(diagnostic.help("bless where the waveforms can be looked at, and commit them").into());
    }
    let root = Path::new("circuits");
    let scenarios = if named.is_empty() {
        files::below(root, "toml")
    } else {
        named.iter().map(|named| scenario_path(named)).collect()
    };
    if scenarios.is_empty() {
        say("there is nothing to check: no scenario below ./circuits");
        return Ok(Ending::Nothing);
    }
    let verdicts: Vec<_> = scenarios.par_iter().map(|path| judge_one(path, bless, engine)).collect();
    let mut tally = Tally::default();
    for (path, verdict) in scenarios.iter().zip(verdicts) {
        tally.take(path, verdict)?;
    }
    if named.is_empty() {
        tally.lost(&lost_goldens(&scenarios))?;
    }
    tally.end()
}

fn set(name: &str) -> bool {
    std::env::var_os(name).is_some_and(|value| !value.is_empty() && value != "0")
}

/// A scenario is named by its file, or by its name below `circuits`.
fn scenario_path(named: &Path) -> PathBuf {
    let is_file = named.extension().is_some_and(|ending| ending == "toml");
    if is_file { named.to_owned() } else { Path::new("circuits").join(named).with_added_extension("toml") }
}

/// `circuits/A/B.toml` -> `traces/A/B.vcd`, beside the last folder called `circuits`.
fn golden_path(scenario: &Path) -> Result<PathBuf, Report> {
    let parts: Vec<_> = scenario.components().collect();
    let place = parts.iter().rposition(|part| *part == Component::Normal("circuits".as_ref())).ok_or_else(|| {
        let message = format!("{} has no golden trace: it is in no folder `circuits`", scenario.display());
        Diagnostic::new("C006", message).help("the golden trace of circuits/A/B.toml is traces/A/B.vcd")
    })?;
    let before = parts[..place].iter().collect::<PathBuf>();
    let below = parts[place + 1..].iter().collect::<PathBuf>();
    Ok(before.join("traces").join(below).with_extension("vcd"))
}

/// What came of a scenario that could be run.
enum Verdict {
    Equal(String),
    Different(String),
    Blessed(String),
}

fn judge_one(path: &Path, bless: bool, engine: EngineKind) -> Result<Verdict, Report> {
    let golden = golden_path(path)?;
    let ran = Ran::scenario(path, engine)?;
    if bless {
        check_files(ran.design.files().iter().map(PathBuf::as_path), [golden.as_path()])?;
        return ran.bless(&golden);
    }
    let mut wrong = ran.failed.clone();
    if golden.is_file() {
        let found = golden::check(&Input::file(&golden), &Input::bytes("the run", ran.vcd.clone()))?;
        if !found.comparison.is_equal() {
            wrong.push(ran.explain(&found, path, &golden));
        }
    } else {
        wrong.push(format!("there is no golden trace {}\n{}", golden.display(), how_to_bless(path)));
    }
    let text = format!("{} ticks, {} signals", ran.ticks, ran.waveform.names().count());
    Ok(if wrong.is_empty() { Verdict::Equal(text) } else { Verdict::Different(wrong.join("\n")) })
}

fn read_waveform(path: &Path) -> Result<Waveform, Report> {
    let file = std::fs::File::open(path).map_err(|error| files::unreadable(path, &files::reason(&error)))?;
    golden::read(&path.display().to_string(), io::BufReader::new(file))
}

fn how_to_bless(scenario: &Path) -> String {
    format!("to accept what came out: stepwright check --bless {}", scenario.display())
}

/// A scenario that has been run and traced.
struct Ran {
    design: Design,
    vcd: Vec<u8>,
    waveform: Waveform,
    ticks: u64,
    failed: Vec<String>,
    engine: &'static str,
}

impl Ran {
    fn scenario(path: &Path, engine: EngineKind) -> Result<Self, Report> {
        let design = Session::open(path)?.engine(engine).elaborate()?;
        let mut vcd = Vec::new();
        let wave = Wave::new(VCD, Box::new(Cursor::new(&mut vcd))).of(selection(&[], design.scenario())?);
        let mut run = design.start_with(vec![Box::new(wave)])?;
        let outcome = run.finish()?;
        let failed = run.failed_expectations(&design.scenario().expect, &outcome);
        let engine = run.engine();
        drop(run);
        let waveform = golden::read("the run", vcd.as_slice())?;
        Ok(Self { vcd, waveform, ticks: outcome.ticks, failed, engine, design })
    }

    fn bless(self, golden: &Path) -> Result<Verdict, Report> {
        if !self.failed.is_empty() {
            return Ok(Verdict::Different(self.failed.join("\n")));
        }
        let old = if golden.is_file() { Some(read_waveform(golden)?) } else { None };
        let summary = Summary::new(old.as_ref(), &self.waveform);
        if summary.is_unchanged() {
            return Ok(Verdict::Equal("unchanged".to_owned()));
        }
        if let Some(folder) = golden.parent() {
            std::fs::create_dir_all(folder).map_err(|error| files::unwritable(golden, &error))?;
        }
        files::write_bytes(golden, &self.vcd)?;
        Ok(Verdict::Blessed(format!("{}: {summary}", golden.display())))
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
fn lost_goldens(scenarios: &[PathBuf]) -> Vec<PathBuf> {
    let known: Vec<_> = scenarios.iter().filter_map(|path| golden_path(path).ok()).collect();
    let all = files::below(Path::new("traces"), "vcd");
    all.into_iter().filter(|golden| !known.contains(golden)).collect()
}

#[derive(Default)]
struct Tally {
    equal: usize,
    blessed: usize,
    different: usize,
    broken: usize,
}

impl Tally {
    fn take(&mut self, path: &Path, verdict: Result<Verdict, Report>) -> Result<(), Report> {
        let name = path.display();
        match verdict {
            Ok(Verdict::Equal(text)) => {
                self.equal += 1;
                print(&format!("ok       {name} ({text})\n"))
            }
            Ok(Verdict::Blessed(text)) => {
                self.blessed += 1;
                print(&format!("blessed  {name}\n{}\n", indented(&text)))
            }
            Ok(Verdict::Different(text)) => {
                self.different += 1;
                print(&format!("DIFFERS  {name}\n{}\n", indented(&text)))
            }
            Err(report) => {
                self.broken += 1;
                complain(&report);
                print(&format!("BROKEN   {name}\n"))
            }
        }
    }

    fn lost(&mut self, goldens: &[PathBuf]) -> Result<(), Report> {
        self.different += goldens.len();
        goldens.iter().try_for_each(|golden| print(&format!("LOST     {}: its scenario is gone\n", golden.display())))
    }

    fn end(self) -> Result<Ending, Report> {
        let Self { equal, blessed, different, broken } = self;
        print(&format!("{equal} equal, {blessed} blessed, {different} different, {broken} broken\n"))?;
        Ok(match (different, broken) {
            (0, 0) => Ending::Done,
            (_, 0) => Ending::Different,
            _ => Ending::Wrong,
        })
    }
}

fn indented(text: &str) -> String {
    text.lines().map(|line| format!("    {line}")).collect::<Vec<_>>().join("\n")
}
