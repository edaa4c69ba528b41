//! Segments measured: by a circuit with its meter, or by a reference algorithm.

use std::ops::ControlFlow;
use std::time::{Duration, Instant};

use super::super::long_run::{hint, progress};
use super::super::{check_files, interrupt, say};
use super::checkpoint::Checkpoint;
use super::table::Shown;
use super::{AccuracyArguments, check_outputs, does_nothing};
use crate::accuracy::{Meter, Reference, count};
use crate::base::{Diagnostic, Report, StoppedBy};
use crate::simulation::Session;

/// How often the checkpoint is written.
const LATE: Duration = Duration::from_secs(5);
/// After how many frames the bar moves.
const BEAT: u64 = 1 << 10;

/// The greatest projection of a reference algorithm: what a double holds of its squares is exact, and it ends in hours.
const MOST_OF_REFERENCE: u64 = (1 << 16) - 1;

/// What an algorithm does.
pub fn of_reference(reference: Reference, arguments: &AccuracyArguments) -> Result<Shown, Report> {
    does_nothing(arguments, "is an algorithm and no circuit", &["--param", "--over", "--threads", "--checkpoint"])?;
    if arguments.max > MOST_OF_REFERENCE {
        let message = format!("a projection of {} is more than an algorithm takes here", arguments.max);
        return Err(Diagnostic::new("A002", message).help(format!("it takes up to {MOST_OF_REFERENCE}")).into());
    }
    check_files([], arguments.csv.iter().chain(&arguments.svg).chain(&arguments.png).map(std::path::PathBuf::as_path))?;
    Ok(Shown {
        name: reference.name().to_owned(),
        inputs: ["major".into(), "minor".into()],
        max: arguments.max,
        claim: reference.claim(),
        ticks: None,
        tally: reference.tally(arguments.max),
    })
}

/// What a circuit measures; `None` when it was interrupted, which has been told. `is_first`: its files are to be checked.
pub fn of_circuit(session: Session, arguments: &AccuracyArguments, is_first: bool) -> Result<Option<Shown>, Report> {
    let meter = Meter::of(session)?;
    if is_first {
        check_outputs(meter.design(), arguments)?;
    }
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
        claim: meter.claim(),
        ticks: Some(kept.ticks),
        tally: kept.tally,
    }))
}

/// Measures what is not in `kept` yet; `false` when it was interrupted.
fn measure(meter: &Meter, kept: &mut Checkpoint, arguments: &AccuracyArguments) -> Result<bool, Report> {
    let all = count(arguments.max).unwrap_or(u64::MAX);
    let first = kept.tally.segments;
    let bar = progress(all, first, "segments");
    let claim = meter.claim();
    let mut written = Instant::now();
    let mut failed = None;
    let threads = arguments.threads.map(usize::from);
    meter.run(arguments.max, first, threads, interrupt::flag(), |frame, stopped_by, ticks| {
        kept.tally.add(frame, &claim);
        kept.tally.unfinished += u64::from(stopped_by == StoppedBy::Limit);
        kept.ticks += ticks;
        if kept.tally.segments.is_multiple_of(BEAT) {
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
