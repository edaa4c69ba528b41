//! `stepwright run`: one circuit, one stimulus; results, tables, waveforms, a picture.

use std::path::PathBuf;

use super::args::RunArguments;
use super::observers::Observers;
use super::{Ending, check_files, interrupt, result, say, stats};
use crate::base::Report;
use crate::simulation::StoppedBy;

pub(super) fn run(arguments: &RunArguments) -> Result<Ending, Report> {
    let design = arguments.target.session()?.elaborate()?;
    let mut observers = Observers::new(arguments, &design)?;
    check_files(design.files().iter().map(PathBuf::as_path), observers.files())?;
    result::warnings(&design).iter().for_each(|warning| say(&format!("warning: {warning}")));
    let mut run = design.start_with(observers.all()?)?.cancelled_by(interrupt::flag());
    let outcome = run.finish()?;
    if arguments.stats {
        say(&stats::table(run.engine(), run.stats()));
    }
    let failed = run.failed_expectations(&design.scenario().expect, &outcome);
    drop(run);
    result::show(arguments, &design, &observers, &outcome)?;
    failed.iter().for_each(|line| say(line));
    match outcome.stopped_by {
        StoppedBy::Limit => {
            say(&format!("the limit of {} ticks was reached before the net to wait for came", outcome.ticks));
        }
        StoppedBy::Interrupt => {
            say(&format!("interrupted at tick {}; what was written ends there", outcome.ticks - 1));
        }
        StoppedBy::Until | StoppedBy::Ticks if failed.is_empty() => return Ok(Ending::Done),
        StoppedBy::Until | StoppedBy::Ticks => {}
    }
    Ok(Ending::Different)
}
