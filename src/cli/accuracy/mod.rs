//! `stepwright accuracy`: every segment there is, measured inside the netlist.

mod checkpoint;
mod show;

use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use clap::Args;

use super::args::{assignment, given_once};
use super::long_run::{hint, progress};
use super::{Ending, check_files, interrupt, print, say};
use crate::accuracy::{Meter, Reference, Tally, count};
use crate::base::{Diagnostic, Report, StoppedBy};
use crate::files;
use crate::simulation::{Session, measurable};
use checkpoint::Checkpoint;
use show::Shown;

/// Arguments of `accuracy`.
#[derive(Args, Debug)]
#[command(after_help = "Examples:\n  \
    stepwright accuracy su1522157/interpolator --max 511\n  \
    stepwright accuracy su1522157/prototype --csv slopes.csv\n  \
    stepwright accuracy reference/bresenham --json\n  \
    stepwright accuracy su1522157/interpolator --max 4095 --checkpoint all.json\n\n\
    A segment goes from (0, 0) to (X, Y); all with 0 <= Y <= X <= N are taken. The circuit is run with a meter behind it\n\
    (a shipped one, or a scenario of yours with a table [measure]). Interrupted (Ctrl-C), what has been measured is in the\n\
    checkpoint; the same command with --resume goes on from there. Exit status 1: a segment breaks the law.")]
pub struct AccuracyArguments {
    /// A circuit that a circuit with a meter is known for, a scenario of such a meter, or reference/bresenham,
    /// reference/symmetrical_dda, reference/koren_dda
    #[arg(value_name = "CIRCUIT")]
    pub circuit: PathBuf,
    /// The greatest projection
    #[arg(long, value_name = "N", default_value_t = 255)]
    pub max: u64,
    /// Set a parameter of the circuit
    #[arg(short, long = "param", value_name = "NAME=VALUE", value_parser = assignment::<i64>, allow_hyphen_values = true)]
    pub param: Vec<(String, i64)>,
    /// Write a row for each degree of slope
    #[arg(long, value_name = "FILE")]
    pub csv: Option<PathBuf>,
    /// Print one JSON object
    #[arg(long)]
    pub json: bool,
    /// Threads to run on; all cores by default
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub threads: Option<u16>,
    /// Keep what has been measured so far in this file
    #[arg(long, value_name = "FILE")]
    pub checkpoint: Option<PathBuf>,
    /// Go on from the checkpoint
    #[arg(long, requires = "checkpoint")]
    pub resume: bool,
}

/// How often the checkpoint is written.
const LATE: Duration = Duration::from_secs(5);
/// After how many frames the bar moves.
const BEAT: u64 = 1 << 10;

pub(super) fn accuracy(arguments: &AccuracyArguments) -> Result<Ending, Report> {
    given_once("--param", arguments.param.iter().map(|(name, _)| name))?;
    let reference = Reference::ALL.into_iter().find(|reference| Path::new(reference.name()) == arguments.circuit);
    let shown = match reference {
        Some(reference) => of_reference(reference, arguments)?,
        None => match of_circuit(arguments)? {
            Some(shown) => shown,
            None => return Ok(Ending::Different),
        },
    };
    if let Some(path) = &arguments.csv {
        files::write_bytes(path, shown.csv().as_bytes())?;
    }
    print(&if arguments.json { format!("{:#}\n", shown.json()) } else { shown.text() })?;
    let Tally { violations, unfinished, .. } = shown.tally;
    Ok(if violations + unfinished == 0 { Ending::Done } else { Ending::Different })
}

/// The greatest projection of a reference algorithm: what a double holds of its squares is exact, and it ends in hours.
const MOST_OF_REFERENCE: u64 = (1 << 16) - 1;

fn of_reference(reference: Reference, arguments: &AccuracyArguments) -> Result<Shown, Report> {
    let given = [
        ("--param", !arguments.param.is_empty()),
        ("--threads", arguments.threads.is_some()),
        ("--checkpoint", arguments.checkpoint.is_some()),
    ];
    if let Some((option, _)) = given.iter().find(|(_, is_given)| *is_given) {
        let message = format!("{option} does nothing for `{}`, which is an algorithm and no circuit", reference.name());
        return Err(Diagnostic::new("C008", message).help("leave it out").into());
    }
    if arguments.max > MOST_OF_REFERENCE {
        let message = format!("a projection of {} is more than an algorithm takes here", arguments.max);
        return Err(Diagnostic::new("A002", message).help(format!("it takes up to {MOST_OF_REFERENCE}")).into());
    }
    check_files([], arguments.csv.iter().map(PathBuf::as_path))?;
    let tally = reference.tally(arguments.max);
    let name = reference.name().to_owned();
    Ok(Shown {
        name,
        inputs: ["major".into(), "minor".into()],
        max: arguments.max,
        law: reference.law(),
        printed: None,
        ticks: None,
        tally,
    })
}

/// What a circuit measures; `None` when it was interrupted, which has been told.
fn of_circuit(arguments: &AccuracyArguments) -> Result<Option<Shown>, Report> {
    let session = Session::open(&arguments.circuit).and_then(Session::measured).map_err(with_references)?;
    let session = arguments.param.iter().fold(session, |session, (name, value)| session.parameter(name, *value));
    let meter = Meter::of(session)?;
    let writes = [&arguments.csv, &arguments.checkpoint].into_iter().flatten();
    check_files(meter.design().files().iter().map(PathBuf::as_path), writes.map(PathBuf::as_path))?;
    let mut kept = Checkpoint::begin(&meter, arguments.max);
    if let Some(path) = arguments.checkpoint.as_deref().filter(|_| arguments.resume) {
        kept = kept.resumed(path)?;
    }
    let is_whole = measure(&meter, &mut kept, arguments)?;
    if let Some(path) = &arguments.checkpoint {
        kept.write(path)?;
    }
    if !is_whole {
        let all = count(arguments.max).unwrap_or(u64::MAX);
        say(&format!("interrupted after {} of {all} segments", kept.tally.segments));
        if let Some(path) = &arguments.checkpoint {
            hint(&format!("what they measure is in {}", path.display()));
        }
        return Ok(None);
    }
    let measure = meter.design().scenario().measure.as_ref().expect("a meter measures");
    Ok(Some(Shown {
        name: measure.of.clone(),
        inputs: [measure.major.name.clone(), measure.minor.name.clone()],
        max: arguments.max,
        law: meter.law(),
        printed: meter.printed(),
        ticks: Some(kept.ticks),
        tally: kept.tally,
    }))
}

/// Measures what is not in `kept` yet; `false` when it was interrupted.
fn measure(meter: &Meter, kept: &mut Checkpoint, arguments: &AccuracyArguments) -> Result<bool, Report> {
    let all = count(arguments.max).unwrap_or(u64::MAX);
    let first = kept.tally.segments;
    let bar = progress(all, first, "segments");
    let (law, printed) = (meter.law(), meter.printed());
    let mut written = Instant::now();
    let mut failed = None;
    let threads = arguments.threads.map(usize::from);
    meter.run(arguments.max, first, threads, interrupt::flag(), |frame, stopped_by, ticks| {
        kept.tally.add(frame, law, printed);
        kept.tally.unfinished += u64::from(stopped_by == StoppedBy::Limit);
        kept.ticks += ticks;
        if kept.tally.segments % BEAT == 0 {
            bar.inc(BEAT);
            if let Some(path) = arguments.checkpoint.as_deref().filter(|_| written.elapsed() > LATE) {
                failed = kept.write(path).err();
                written = Instant::now();
            }
        }
        if failed.is_some() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    })?;
    bar.finish_and_clear();
    failed.map_or(Ok(kept.tally.segments == all), Err)
}

/// What is not known, with all that is.
fn with_references(mut report: Report) -> Report {
    let names = Reference::ALL.map(Reference::name);
    let circuits = measurable().join(", ");
    for diagnostic in report.diagnostics.iter_mut().filter(|diagnostic| ["A001", "C001"].contains(&diagnostic.code)) {
        let known = format!("accuracy knows {circuits} and the algorithms {}", names.join(", "));
        *diagnostic = diagnostic.clone().help(known);
    }
    report
}
