//! What can be typed: the command line as `clap` types.

use std::collections::HashSet;
use std::path::PathBuf;

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::{ArgGroup, Args, Parser, Subcommand};

pub use super::accuracy::AccuracyArguments;
pub use super::check::CheckArguments;
use super::completions;
pub use super::diff::DiffArguments;
pub use super::draw::DrawArguments;
pub use super::sweep::{MergeArguments, SweepArguments};
use crate::base::word::of_letters;
use crate::base::{Diagnostic, Report};
use crate::scenario::Number;
use crate::simulation::{EngineKind, Session};

/// Cycle-accurate simulator for digital interpolation hardware.
#[derive(Parser, Debug)]
#[command(name = "stepwright", version, max_term_width = 100, after_help = EXAMPLES)]
pub struct Arguments {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
}

const EXAMPLES: &str = "\
Examples:
  stepwright list                                          the shipped circuits
  stepwright run su1522157/table1 --table                  the patent's table 1, row by row
  stepwright run su1522157/interpolator -s major_32=127 -s minor_34=43 --vcd out.vcd --gtkw out.gtkw
  stepwright run us3809868/fig09_function_generator        a quarter ellipse
  stepwright check                                         every scenario against its golden trace

Exit status: 0 done and equal; 1 a difference, a failed expectation, a limit reached, or interrupted; 2 wrong usage or
input, or an output that cannot be written; 3 nothing selected; 141 the reader of standard output has gone.
Colours follow the terminal and the variable NO_COLOR.";

/// A command.
#[derive(Subcommand, Debug)]
pub enum Command {
    /// List circuits with their scenarios, or the blocks
    #[command(after_help = "Examples:\n  stepwright list\n  stepwright list blocks\n  stepwright list su1522157\n  \
        stepwright list ./mine    what is in a folder of yours")]
    List {
        /// `circuits`: the shipped ones and those below ./circuits; `blocks`; or a folder, also one below ./circuits
        #[arg(value_name = "circuits|blocks|FOLDER", default_value = "circuits", add = completions::folders())]
        what: String,
        /// Print one JSON object
        #[arg(long)]
        json: bool,
    },
    /// Show what a circuit, scenario, block or instance is: ports, parameters, figure, parts, notes
    #[command(after_help = "Examples:\n  stepwright show su1522157/interpolator\n  \
        stepwright show su1522157/interpolator.accumulator_1    an instance, with its connections\n  \
        stepwright show su1522157/table1    a scenario's notes and keys\n  \
        stepwright show summer    a block\n  \
        stepwright show --source su1522157/table1 > mine.toml    a copy to change")]
    Show {
        /// A circuit or scenario (name or path), a block, or an instance in a circuit
        #[arg(value_name = "NAME[.INSTANCE]", add = completions::shown())]
        name: String,
        /// Print the text itself: a circuit's or scenario's file (of both names: NAME.toml for the scenario), a block as Verilog
        #[arg(long, conflicts_with = "json")]
        source: bool,
        /// Print one JSON object
        #[arg(long)]
        json: bool,
    },
    /// Run a circuit or a scenario
    Run(RunArguments),
    /// Run scenarios and compare them with their golden traces and expectations
    Check(CheckArguments),
    /// Compare two waveform files, of any tools, and show where they first differ and why
    Diff(DiffArguments),
    /// Draw a plot file by a machine: figures, pictures
    Draw(DrawArguments),
    /// Run many stimuli of a circuit, one row of results each
    Sweep(SweepArguments),
    /// Join the parts of a sweep that ran in shards
    Merge(MergeArguments),
    /// Measure how far an interpolator's paths are from the ideal line, over all segments there are
    Accuracy(AccuracyArguments),
    /// Write a circuit in a form that other tools read
    #[command(after_help = "Example:\n  stepwright export su1522157/table1 --verilog out\n  \
        iverilog -g2005 -o bench.vvp out/*.v && vvp -n bench.vvp")]
    Export {
        /// What to export
        #[command(flatten)]
        target: Target,
        /// Write the circuit's files, the blocks and a bench as Verilog into this folder
        #[arg(long, value_name = "DIR")]
        verilog: PathBuf,
    },
    /// Print a completion script for a shell
    #[command(
        after_help = "Example:\n  stepwright completions bash > ~/.local/share/bash-completion/completions/stepwright\n\n\
        It completes circuits, scenarios, blocks, instances, inputs, parameters and nets by asking stepwright."
    )]
    Completions {
        /// The shell
        shell: clap_complete::Shell,
    },
}

/// What to run and with which values: shared by the commands that run something.
#[derive(Args, Debug)]
pub struct Target {
    /// A circuit or scenario: a shipped name such as su1522157/interpolator, or a path to a .v or .toml file
    #[arg(value_name = "CIRCUIT|SCENARIO", add = completions::targets())]
    pub target: PathBuf,
    /// Hold an input at a value: decimal, 0x.., 0b.., or a real number for a fixed-point port
    #[arg(short, long = "set", value_name = "NAME=VALUE", value_parser = assignment::<Number>, allow_hyphen_values = true,
        add = completions::inputs())]
    pub set: Vec<(String, Number)>,
    /// Set a parameter of the circuit: a whole number, or a string as in IMAGE="letters"
    #[arg(short, long = "param", value_name = "NAME=VALUE", value_parser = assignment::<i64>, allow_hyphen_values = true,
        add = completions::parameters())]
    pub param: Vec<(String, i64)>,
    /// Run so many ticks
    #[arg(long, value_name = "N", conflicts_with = "until")]
    pub ticks: Option<u64>,
    /// Run until a net is high, or with ! low
    #[arg(long, value_name = "NET|!NET", add = completions::nets())]
    pub until: Option<String>,
    /// Give up after so many ticks (exit status 1)
    #[arg(long, value_name = "N")]
    pub limit: Option<u64>,
    /// Engine to run on
    #[arg(long, value_name = "NAME", default_value = "auto", value_parser = engine())]
    pub engine: EngineKind,
}

impl Target {
    /// The session that was typed.
    ///
    /// # Errors
    /// `C001` nothing of that name, `C007` options that contradict each other, and what is wrong in the scenario.
    pub fn session(&self) -> Result<Session, Report> {
        if let (Some(ticks), Some(limit)) = (self.ticks, self.limit)
            && limit < ticks
        {
            let diagnostic = Diagnostic::new("C007", format!("--limit {limit} is less than --ticks {ticks}"));
            return Err(diagnostic.help("leave one of them out").into());
        }
        given_once("--set", self.set.iter().map(|(name, _)| name))?;
        given_once("--param", self.param.iter().map(|(name, _)| name))?;
        let mut session = Session::open(&self.target)?.engine(self.engine);
        session = self.set.iter().fold(session, |session, (name, value)| session.input(name, *value));
        session = self.param.iter().fold(session, |session, (name, value)| session.parameter(name, *value));
        session = self.ticks.iter().fold(session, |session, &ticks| session.ticks(ticks));
        session = self.until.iter().fold(session, |session, net| session.until(net));
        Ok(self.limit.iter().fold(session, |session, &limit| session.limit(limit)))
    }
}

/// One of two values would do nothing.
pub(super) fn given_once<'n>(option: &str, names: impl Iterator<Item = &'n String>) -> Result<(), Diagnostic> {
    let mut known = HashSet::new();
    match names.into_iter().find(|name| !known.insert(*name)) {
        Some(name) => {
            Err(Diagnostic::new("C007", format!("{option} gives `{name}` twice")).help("leave one of them out"))
        }
        None => Ok(()),
    }
}

/// Arguments of `run`.
#[derive(Args, Debug)]
#[command(after_help = "Examples:\n  \
    stepwright run su1522157/table1 --table\n  \
    stepwright run su1522157/interpolator -s major_32=8 -s minor_34=3 -p MINUS_ZERO=1 --json\n  \
    stepwright run ./my.v -s start=1 --until done --wave my.fst --trace 'counter_*' --from 100 --to 200\n  \
    stepwright run su1522157/table1 --csv - --columns f_1,r_14 --when step_x_36\n  \
    stepwright run su1522157/table1 --wave end.vcd --last 20 --trace 'accumulator_1.*'    one scope, the last ticks\n\n\
    The file - is standard output. A waveform's format follows from its ending.")]
#[command(group = ArgGroup::new("waveform").multiple(true).args(["wave", "vcd", "fst"]))]
#[command(group = ArgGroup::new("shown").multiple(true).args(["wave", "vcd", "fst", "table", "csv"]))]
#[command(group = ArgGroup::new("rows").multiple(true).args(["table", "csv"]))]
pub struct RunArguments {
    /// What to run.
    #[command(flatten)]
    pub target: Target,
    /// Write the waveform, as VCD or FST as the file's name ends (may be given again)
    #[arg(long, value_name = "FILE.vcd|.fst")]
    pub wave: Vec<PathBuf>,
    /// Write the waveform as VCD, whatever the file is called
    #[arg(long, value_name = "FILE")]
    pub vcd: Option<PathBuf>,
    /// Write the waveform as FST, whatever the file is called
    #[arg(long, value_name = "FILE")]
    pub fst: Option<PathBuf>,
    /// Write a GTKWave save file for the waveform
    #[arg(long, value_name = "FILE", requires = "waveform")]
    pub gtkw: Option<PathBuf>,
    /// Trace only the signals that match (dotted names; may be given again)
    #[arg(long, value_name = "GLOB", requires = "waveform", add = completions::nets())]
    pub trace: Vec<String>,
    /// Trace from this tick on
    #[arg(long, value_name = "TICK", requires = "waveform")]
    pub from: Option<u64>,
    /// Trace up to and including this tick
    #[arg(long, value_name = "TICK", requires = "waveform")]
    pub to: Option<u64>,
    /// Trace the last ticks only, so many
    #[arg(long, value_name = "TICKS", requires = "waveform", conflicts_with_all = ["from", "to", "when"],
        value_parser = clap::value_parser!(u64).range(1..))]
    pub last: Option<u64>,
    /// Print a table of signals, tick by tick or as the scenario's table says
    #[arg(long)]
    pub table: bool,
    /// Write that table as CSV
    #[arg(long, value_name = "FILE")]
    pub csv: Option<PathBuf>,
    /// The table's columns: names of signals
    #[arg(long, value_name = "NAME,..", value_delimiter = ',', requires = "rows", add = completions::nets())]
    pub columns: Vec<String>,
    /// The table's rows: ticks in which one of these nets is high; a waveform begins with the first of them
    #[arg(long, value_name = "NET,..", value_delimiter = ',', requires = "shown", add = completions::nets())]
    pub when: Vec<String>,
    /// Draw the path, as is done anyway without --json
    #[arg(long)]
    pub plot: bool,
    /// Tell on standard error what the specialised native code runs
    #[arg(long)]
    pub stats: bool,
    /// Print the result as one JSON object, with the table and the path where they are asked for
    #[arg(long)]
    pub json: bool,
}

/// An engine by its name; `clap` lists the names and suggests the nearest.
pub(super) fn engine() -> impl TypedValueParser<Value = EngineKind> {
    PossibleValuesParser::new(EngineKind::all().map(|kind| PossibleValue::new(kind.name()).help(kind.doc())))
        .try_map(|name| name.parse::<EngineKind>().map_err(|error| error.message))
}

/// `NAME=VALUE`.
pub(super) fn assignment<T: FromText>(text: &str) -> Result<(String, T), String> {
    let (name, value) = text.split_once('=').ok_or("expected NAME=VALUE")?;
    T::from_text(value.trim()).map(|value| (name.trim().to_owned(), value))
}

/// A value that can stand after `NAME=`.
pub(super) trait FromText: Sized {
    fn from_text(text: &str) -> Result<Self, String>;
}

impl FromText for Number {
    fn from_text(text: &str) -> Result<Self, String> {
        Number::parse(text)
    }
}

impl FromText for i64 {
    fn from_text(text: &str) -> Result<Self, String> {
        if let Some(letters) = text.strip_prefix('"').and_then(|text| text.strip_suffix('"')) {
            let number = of_letters(letters).and_then(|number| i64::try_from(number).ok());
            return number.ok_or_else(|| format!("`{letters}` is not a string of 1 to 8 letters"));
        }
        match Number::parse(text)? {
            Number::Word(value) => i64::try_from(value).map_err(|_| format!("{value} does not fit 64 bits")),
            Number::Real(_) => Err(format!("`{text}` is not a whole number")),
        }
    }
}
