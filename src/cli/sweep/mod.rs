//! `stepwright sweep`: many stimuli of one circuit, one row each, in order.

mod csv_file;
mod description;
mod heatmap;
mod lines;
mod merge;
mod plan;
mod ranges;
mod resume;
mod rows;
mod shard;
mod stimuli;

use std::ops::{ControlFlow, Range};
use std::path::{Path, PathBuf};

use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};

use super::args::Target;
use super::long_run::{hint, progress};
use super::{Ending, check_files, interrupt, say};
use crate::accuracy::Quantity;
use crate::base::{Diagnostic, Report, StoppedBy};
use crate::simulation::Design;
use description::Description;
pub(super) use description::{RESUMED, differences, hash_of};
use heatmap::Heat;
pub use merge::{MergeArguments, merge};
pub(super) use plan::sets;
use plan::{Part, Plan};
pub(super) use ranges::Over;
use rows::Format;
pub use stimuli::Stimuli;

/// Arguments of `sweep`.
#[derive(Args, Debug)]
#[command(after_help = "Examples:\n  \
    stepwright sweep su1522157/interpolator --over major_32=0..=255 --over minor_34=0..=255 --out frames.csv\n  \
    stepwright sweep su1522157/interpolator -s minor_34=3 --over major_32=3,5,8..=64:8\n  \
    stepwright sweep su1522157/interpolator --from frames.csv --out results.jsonl\n  \
    stepwright sweep su1522157/interpolator --over major_32=0..=4095 --shard 3/8 --out part3.csv\n  \
    stepwright sweep su1522157/interpolator --over p:DELAY_13=1..=4 --over minor_34=0..=16 --measure deviation,steps\n\n\
    A range a..b ends before b, a..=b with it; :s takes every s-th. With several --over the last varies fastest,\n\
    and parameters (p:NAME) slower than inputs.\n\
    Rows are CSV, or JSON lines when the file's name ends in .jsonl. Interrupted (Ctrl-C), the file holds all rows done\n\
    so far; the same command with --resume goes on from there. What sweep they are of stands in FILE.sweep beside it.")]
pub struct SweepArguments {
    /// What to run.
    #[command(flatten)]
    pub target: Target,
    /// Take an input, or with p: a parameter, through ranges and lists of values: 0..10, 0..=255:5, 1,2,5
    #[arg(long, value_name = "NAME=RANGE", value_parser = Over::parse, required_unless_present = "from")]
    pub over: Vec<Over>,
    /// Take inputs from a CSV file whose header names them
    #[arg(long, value_name = "FILE.csv", conflicts_with = "over")]
    pub from: Option<PathBuf>,
    /// Write the rows into this file (standard output otherwise)
    #[arg(long, value_name = "FILE.csv|.jsonl")]
    pub out: Option<PathBuf>,
    /// Threads to run on; all cores by default
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub threads: Option<u16>,
    /// Add columns that are measured: the circuit is run with a meter behind it (see `accuracy`)
    #[arg(long, value_name = "NAME,..", value_delimiter = ',', value_parser = quantity())]
    pub measure: Vec<Quantity>,
    /// Draw the two inputs or parameters that vary against a column
    #[arg(long, value_name = "FILE.svg", conflicts_with_all = ["resume", "from"])]
    pub heatmap: Option<PathBuf>,
    /// The column that the heat map shows; the first that is measured without it
    #[arg(long, value_name = "NAME", requires = "heatmap")]
    pub column: Option<String>,
    /// Run one part only: part I of N, from 0 on; with auto/N or auto the one that Slurm, Kubernetes or GNU parallel says
    #[arg(long, value_name = "I/N", requires = "out", conflicts_with = "heatmap")]
    pub shard: Option<String>,
    /// Go on with a file that an interrupted sweep left
    #[arg(long, requires = "out")]
    pub resume: bool,
}

pub(super) fn sweep(arguments: &SweepArguments) -> Result<Ending, Report> {
    let format = Format::of(arguments.out.as_deref())?;
    let plan = Plan::new(arguments, format)?;
    let to_run = plan.rows();
    let all = to_run.end - to_run.start;
    let out = arguments.out.as_deref().unwrap_or(Path::new("-"));
    let beside = Description::path(out);
    let reads = plan.first().design().files().iter().chain(&arguments.from).map(PathBuf::as_path);
    check_files(reads, [out, beside.as_path()].into_iter().chain(arguments.heatmap.as_deref()))?;
    let mut map = arguments.heatmap.as_ref().map(|_| Heat::of(arguments, &plan)).transpose()?;
    let (mut output, left) = resume::open(out, arguments, &plan)?;
    let bar = progress(all, left.rows, "rows");
    let mut tally = Tally { rows: left.rows, at_limit: left.at_limit, broken: Vec::new() };
    for (part, numbers) in plan.within(to_run.start + left.rows..to_run.end) {
        let is_whole = tally.run(&plan, part, numbers, arguments, map.as_mut(), |text| {
            bar.inc(1);
            output.write(text)
        })?;
        if !is_whole {
            break;
        }
    }
    bar.finish_and_clear();
    let requirements = &plan.first().design().scenario().require;
    let run = tally.rows - left.rows;
    for (requirement, rows) in requirements.iter().zip(&tally.broken).filter(|(_, rows)| **rows > 0) {
        let wanted = &requirement.value;
        say(&format!("warning: the inputs should satisfy {wanted}, but in {rows} of {run} rows they do not"));
    }
    output.finish()?;
    let Tally { rows, at_limit, .. } = tally;
    if rows < all {
        say(&format!("interrupted after {rows} of {all} rows"));
        if let Some(path) = &arguments.out {
            hint(&format!("they are in {}", path.display()));
        }
        return Ok(Ending::Different);
    }
    if let Some((path, map)) = arguments.heatmap.as_ref().zip(map) {
        map.drawn().svg().write(Some(path), None)?;
    }
    Ok(ending(at_limit, rows))
}

/// How a sweep ends all of whose rows are there.
fn ending(at_limit: u64, rows: u64) -> Ending {
    if at_limit == 0 {
        return Ending::Done;
    }
    say(&format!("{at_limit} of {rows} rows reached the limit before the net to wait for came"));
    Ending::Different
}

/// What is told of the rows when all are done.
struct Tally {
    rows: u64,
    at_limit: u64,
    /// For each requirement the rows that break it.
    broken: Vec<u64>,
}

impl Tally {
    /// Runs some stimuli of a part, and gives their lines to `sink`; `false` when it was broken off.
    fn run(
        &mut self,
        plan: &Plan,
        part: &Part,
        numbers: Range<u64>,
        arguments: &SweepArguments,
        mut map: Option<&mut Heat>,
        mut sink: impl FnMut(&str) -> ControlFlow<()> + Send,
    ) -> Result<bool, Report> {
        let design = part.design();
        let batch = part.batch(arguments)?.cancelled_by(interrupt::flag());
        let rows = plan.written(part, &batch, arguments);
        self.broken.resize(design.scenario().require.len(), 0);
        let mut text = String::new();
        let done = batch.run(part.stimuli.feed(numbers.clone())?, |row| {
            self.at_limit += u64::from(row.stopped_by == StoppedBy::Limit);
            design.broken_requirements(row.inputs).iter().for_each(|requirement| self.broken[requirement.place] += 1);
            if let Some(map) = map.as_mut() {
                map.add(&rows, row);
            }
            text.clear();
            rows.write(row, &mut text);
            sink(&text)
        })?;
        self.rows += done.rows;
        Ok(numbers.start + done.rows == numbers.end)
    }
}

/// A quantity by its name.
fn quantity() -> impl TypedValueParser<Value = Quantity> {
    PossibleValuesParser::new(Quantity::ALL.map(Quantity::name)).map(|name| {
        Quantity::ALL.into_iter().find(|quantity| quantity.name() == name).expect("one of the possible values")
    })
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

/// A sweep over an input that the scenario changes by itself would show words that the circuit never had.
fn untimed(design: &Design, input: usize, name: &str) -> Result<(), Diagnostic> {
    if design.stimulus().changes.iter().any(|change| change.input == input) {
        let diagnostic = Diagnostic::new("C061", format!("the scenario changes the input `{name}` over time"));
        return Err(diagnostic.help("sweep over the inputs that it holds, or write a scenario that holds this one"));
    }
    Ok(())
}
