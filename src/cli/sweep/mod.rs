//! `stepwright sweep`: many stimuli of one circuit, one row each, in order.

mod ranges;
mod resume;
mod rows;
mod stimuli;

use std::io::IsTerminal;
use std::path::PathBuf;

use clap::Args;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use super::args::Target;
use super::{Ending, interrupt};
use crate::base::{Diagnostic, Report, StoppedBy};
use crate::simulation::Design;
use ranges::Over;
use rows::{Format, Rows};
use stimuli::Stimuli;

/// Arguments of `sweep`.
#[derive(Args, Debug)]
#[command(after_help = "Examples:\n  \
    stepwright sweep su1522157/interpolator --over major_32=0..=255 --over minor_34=0..=255 --out frames.csv\n  \
    stepwright sweep su1522157/interpolator -s minor_34=3 --over major_32=3,5,8..=64:8\n  \
    stepwright sweep su1522157/interpolator --from frames.csv --out results.jsonl\n\n\
    A range a..b ends before b, a..=b with it; :s takes every s-th. With several --over the last varies fastest.\n\
    Rows are CSV, or JSON lines when the file's name ends in .jsonl. Interrupted (Ctrl-C), the file holds all rows done\n\
    so far; the same command with --resume goes on from there.")]
pub struct SweepArguments {
    /// What to run.
    #[command(flatten)]
    pub target: Target,
    /// Take an input through ranges and lists of values: 0..10, 0..=255:5, 1,2,5
    #[arg(long, value_name = "NAME=RANGE", value_parser = Over::parse, required_unless_present = "from")]
    pub over: Vec<Over>,
    /// Take inputs from a CSV file whose header names them
    #[arg(long, value_name = "FILE.csv", conflicts_with = "over")]
    pub from: Option<PathBuf>,
    /// Write the rows into this file (standard output otherwise)
    #[arg(long, value_name = "FILE.csv|.jsonl")]
    pub out: Option<PathBuf>,
    /// Threads to run on; all cores by default
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    pub threads: Option<u16>,
    /// Go on with a file that an interrupted sweep left
    #[arg(long, requires = "out")]
    pub resume: bool,
}

pub(super) fn sweep(arguments: &SweepArguments) -> Result<Ending, Report> {
    let format = Format::of(arguments.out.as_deref())?;
    let design = arguments.target.session()?.elaborate()?;
    let mut batch = design.batch().cancelled_by(interrupt::flag());
    if let Some(threads) = arguments.threads {
        batch = batch.threads(threads.into())?;
    }
    let stimuli = match &arguments.from {
        Some(path) => Stimuli::from_csv(path, &design)?,
        None => Stimuli::over(&arguments.over, &design)?,
    };
    set_and_swept(arguments, &design, stimuli.varied())?;
    let rows = Rows::new(format, &batch, stimuli.varied());
    let (mut output, done_before) = resume::open(arguments, &rows, &stimuli)?;
    let bar = progress(stimuli.count(), done_before);
    let mut text = String::new();
    let mut at_limit = 0_u64;
    let mut broken = vec![0_u64; design.scenario().require.len()];
    let done = batch.run(stimuli.feed(done_before)?, |row| {
        at_limit += u64::from(row.stopped_by == StoppedBy::Limit);
        design.broken_requirements(row.inputs).iter().for_each(|requirement| broken[requirement.place] += 1);
        text.clear();
        rows.write(row, &mut text);
        bar.inc(1);
        output.write(&text)
    })?;
    bar.finish_and_clear();
    for (requirement, rows) in design.scenario().require.iter().zip(broken).filter(|(_, rows)| *rows > 0) {
        eprintln!(
            "warning: the inputs should satisfy {}, but in {rows} of {} rows they do not",
            requirement.value, done.rows
        );
    }
    if !output.finish()? {
        return Ok(Ending::Done);
    }
    let rows = done_before + done.rows;
    if rows < stimuli.count() {
        eprintln!("{}", interrupted(rows, stimuli.count(), arguments));
        return Ok(Ending::Different);
    }
    if at_limit > 0 {
        eprintln!("{at_limit} of {} rows reached the limit before the net to wait for came", done.rows);
        return Ok(Ending::Different);
    }
    Ok(Ending::Done)
}

/// A value of `--set` for an input that the sweep varies would do nothing.
fn set_and_swept(arguments: &SweepArguments, design: &Design, varied: &[usize]) -> Result<(), Diagnostic> {
    let names: Vec<_> = design.inputs().map(|net| &net.name).collect();
    match arguments.target.set.iter().find(|(name, _)| varied.iter().any(|&input| names[input] == name)) {
        Some((name, _)) => {
            let wrong = Diagnostic::new("C062", format!("--set gives `{name}`, which the sweep varies"));
            Err(wrong.help("leave one of them out"))
        }
        None => Ok(()),
    }
}

/// A bar on standard error when that is a terminal.
fn progress(count: u64, done: u64) -> ProgressBar {
    let target =
        if std::io::stderr().is_terminal() { ProgressDrawTarget::stderr() } else { ProgressDrawTarget::hidden() };
    let bar = ProgressBar::with_draw_target(Some(count), target).with_position(done);
    let style = ProgressStyle::with_template("{wide_bar} {human_pos} of {human_len} rows, {per_sec}, {eta} left");
    bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
    bar.reset_eta();
    bar
}

fn interrupted(rows: u64, count: u64, arguments: &SweepArguments) -> String {
    let head = format!("interrupted after {rows} of {count} rows");
    match &arguments.out {
        None => head,
        Some(path) => {
            let typed: Vec<_> = std::env::args().filter(|word| word != "--resume").collect();
            format!("{head}, which are in {}; to go on:\n  {} --resume", path.display(), typed.join(" "))
        }
    }
}

/// A sweep over an input that the scenario changes by itself would show words that the circuit never had.
fn untimed(design: &Design, input: usize, name: &str) -> Result<(), Diagnostic> {
    if design.stimulus().changes.iter().any(|change| change.input == input) {
        let diagnostic = Diagnostic::new("C061", format!("the scenario changes the input `{name}` over time"));
        return Err(diagnostic.help("sweep over the inputs that it holds, or write a scenario that holds this one"));
    }
    Ok(())
}
