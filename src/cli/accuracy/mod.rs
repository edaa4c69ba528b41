//! `stepwright accuracy`: every segment there is, measured inside the netlist, or strokes of an ellipse.

mod checkpoint;
mod over;
mod segments;
mod strokes;
mod table;

use std::path::{Path, PathBuf};

use clap::Args;
use serde_json::Value;

use super::args::{assignment, given_once};
use super::sweep::Over;
use super::{Ending, check_files, print};
use crate::accuracy::{Reference, draws_strokes};
use crate::base::{Diagnostic, Report};
use crate::files;
use crate::picture::Svg;
use crate::simulation::{Session, measurable};

/// Arguments of `accuracy`.
#[derive(Args, Debug)]
#[command(after_help = "Examples:\n  \
    stepwright accuracy su1522157/interpolator --max 511\n  \
    stepwright accuracy su1522157/prototype --csv slopes.csv\n  \
    stepwright accuracy reference/bresenham --json\n  \
    stepwright accuracy su1522157/interpolator --max 4095 --checkpoint all.json\n  \
    stepwright accuracy su1522157/interpolator --max 32 --over p:DELAY_13=1..=4 --over p:CLOCK_PERIOD=3..=6\n  \
    stepwright accuracy us3809868/fig09_function_generator --max 511 --over p:GUARD=0..=3\n\n\
    A segment goes from (0, 0) to (X, Y); all with 0 <= Y <= X <= N are taken. The circuit is run with a meter behind it\n\
    (a shipped one, or a scenario of yours with a table [measure]). Of a generator of strokes, 40 ellipses are drawn whose\n\
    greater half axis is N. Interrupted (Ctrl-C), what has been measured of segments is in the checkpoint; the same command\n\
    with --resume goes on from there. Exit status 1: a segment breaks the law, or a path ends where it may not.")]
pub struct AccuracyArguments {
    /// A circuit that a circuit with a meter is known for, a scenario of such a meter, a generator of strokes with the
    /// ports of us3809868/fig09_function_generator, or reference/bresenham, reference/symmetrical_dda,
    /// reference/koren_dda
    #[arg(value_name = "CIRCUIT")]
    pub circuit: PathBuf,
    /// The greatest projection
    #[arg(long, value_name = "N", default_value_t = 255)]
    pub max: u64,
    /// Set a parameter of the circuit
    #[arg(short, long = "param", value_name = "NAME=VALUE", value_parser = assignment::<i64>, allow_hyphen_values = true)]
    pub param: Vec<(String, i64)>,
    /// Measure with each value of a parameter, one row each: p:NAME=RANGE as in `sweep`
    #[arg(long, value_name = "p:NAME=RANGE", value_parser = Over::parse, conflicts_with = "checkpoint")]
    pub over: Vec<Over>,
    /// Write a row for each degree of slope, each stroke, or each set of parameters
    #[arg(long, value_name = "FILE")]
    pub csv: Option<PathBuf>,
    /// Draw the deviation of each degree of slope, and the law, as FIG. 5 does
    #[arg(long, value_name = "FILE", conflicts_with = "over")]
    pub svg: Option<PathBuf>,
    /// The same as PNG
    #[arg(long, value_name = "FILE", conflicts_with = "over")]
    pub png: Option<PathBuf>,
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

/// What was measured, in whatever way.
trait Measured {
    /// A table for people.
    fn text(&self) -> String;
    /// A table for programs.
    fn csv(&self) -> String;
    /// A picture, of what there is one of.
    fn svg(&self) -> Option<Svg> {
        None
    }
    /// One object.
    fn json(&self) -> Value;
    /// The columns of its row among others.
    fn summary(&self) -> Vec<(&'static str, Value)>;
    /// Whether everything is as claimed.
    fn is_good(&self) -> bool;
}

pub(super) fn accuracy(arguments: &AccuracyArguments) -> Result<Ending, Report> {
    given_once("--param", arguments.param.iter().map(|(name, _)| name))?;
    let reference = Reference::ALL.into_iter().find(|reference| Path::new(reference.name()) == arguments.circuit);
    let measured: Box<dyn Measured> = match reference {
        Some(reference) => Box::new(segments::of_reference(reference, arguments)?),
        None if !arguments.over.is_empty() => Box::new(over::over(arguments)?),
        None => match of_circuit(arguments, session(arguments)?, true)? {
            Some(measured) => measured,
            None => return Ok(Ending::Different),
        },
    };
    if let Some(path) = &arguments.csv {
        files::write_bytes(path, measured.csv().as_bytes())?;
    }
    let (svg, png) = (arguments.svg.as_deref(), arguments.png.as_deref());
    if (svg.is_some() || png.is_some())
        && let Some(picture) = measured.svg()
    {
        picture.write(svg, png)?;
    }
    print(&if arguments.json { format!("{:#}\n", measured.json()) } else { measured.text() })?;
    Ok(if measured.is_good() { Ending::Done } else { Ending::Different })
}

/// The circuit as typed.
fn session(arguments: &AccuracyArguments) -> Result<Session, Report> {
    let session = Session::open(&arguments.circuit).map_err(with_all_that_is_known)?;
    Ok(arguments.param.iter().fold(session, |session, (name, value)| session.parameter(name, *value)))
}

/// What is measured of a circuit; `None` when it was interrupted, which has been told.
fn of_circuit(
    arguments: &AccuracyArguments,
    session: Session,
    is_first: bool,
) -> Result<Option<Box<dyn Measured>>, Report> {
    if session.scenario().measure.is_none() && draws_strokes(session.clone())? {
        does_nothing(arguments, "is a generator of strokes", &["--threads", "--checkpoint", "--svg", "--png"])?;
        return Ok(Some(Box::new(strokes::of_circuit(&session, arguments, is_first)?)));
    }
    let session = session.measured().map_err(with_all_that_is_known)?;
    Ok(segments::of_circuit(session, arguments, is_first)?.map(|segments| Box::new(segments) as Box<dyn Measured>))
}

/// Checks the files of a command, once.
fn check_outputs(session: &crate::simulation::Design, arguments: &AccuracyArguments) -> Result<(), Report> {
    let writes = [&arguments.csv, &arguments.checkpoint, &arguments.svg, &arguments.png].into_iter().flatten();
    check_files(session.files().iter().map(PathBuf::as_path), writes.map(PathBuf::as_path))
}

/// `C008`: one of these options is given to what `is` something that does not take it.
fn does_nothing(arguments: &AccuracyArguments, is: &str, options: &[&str]) -> Result<(), Diagnostic> {
    let given = [
        ("--param", !arguments.param.is_empty()),
        ("--over", !arguments.over.is_empty()),
        ("--threads", arguments.threads.is_some()),
        ("--checkpoint", arguments.checkpoint.is_some()),
        ("--svg", arguments.svg.is_some()),
        ("--png", arguments.png.is_some()),
    ];
    match given.iter().find(|(option, is_given)| *is_given && options.contains(option)) {
        Some((option, _)) => {
            let message = format!("{option} does nothing for `{}`, which {is}", arguments.circuit.display());
            Err(Diagnostic::new("C008", message).help("leave it out"))
        }
        None => Ok(()),
    }
}

/// What is not known, with all that is.
fn with_all_that_is_known(mut report: Report) -> Report {
    let circuits = measurable().join(", ");
    let algorithms = Reference::ALL.map(Reference::name).join(", ");
    for diagnostic in report.diagnostics.iter_mut().filter(|diagnostic| ["A001", "C001"].contains(&diagnostic.code)) {
        *diagnostic = diagnostic
            .clone()
            .help(format!("accuracy knows {circuits}, generators with the ports of us3809868/fig09_function_generator"))
            .help(format!("and the algorithms {algorithms}"));
    }
    report
}
