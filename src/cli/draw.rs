//! `stepwright draw`: a plot file through a machine; figures, SVG, PNG.

use std::path::{Path, PathBuf};

use clap::builder::TypedValueParser;
use clap::{ArgGroup, Args};
use serde_json::json;

use super::{Ending, check_files, interrupt, print, result, say};
use crate::base::{Diagnostic, Report};
use crate::draw::{Canvas, Deviation, How, Look, Placement, Sheet, cut, draw};
use crate::plotfile::{self, Kind, Plot};
use crate::{draw, files};

/// A tolerance below this cannot be held: ends of strokes are whole counts, up to 0.71 away from the curve.
const LEAST_TOLERANCE: f64 = 0.75;

/// Arguments of `draw`.
#[derive(Args, Debug)]
#[command(after_help = "Examples:\n  \
    stepwright draw gear.svg --svg drawn.svg --png drawn.png\n  \
    stepwright draw part.nc --counts-per-mm 40 --tolerance 0.8 --json\n  \
    stepwright draw gear.svg --fit --alternate --moves --png drawn.png")]
#[command(group = ArgGroup::new("scale").args(["size", "counts_per_mm", "fit"]))]
#[command(group = ArgGroup::new("picture").multiple(true).args(["svg", "png"]))]
pub struct DrawArguments {
    /// What to draw: .svg, .gcode, .nc, .ngc or .tap
    pub file: PathBuf,
    /// The longer side, in counts [default: 4000]
    #[arg(long, value_name = "COUNTS", value_parser = positive())]
    pub size: Option<f64>,
    /// Counts of the machine for each millimetre of the drawing
    #[arg(long, value_name = "N", value_parser = positive())]
    pub counts_per_mm: Option<f64>,
    /// As large as the machine's 16 bits allow
    #[arg(long)]
    pub fit: bool,
    /// How far a stroke may be from its curve, in counts
    #[arg(long, value_name = "COUNTS", default_value = "1", value_parser = positive())]
    pub tolerance: f64,
    /// Draw one stroke after another in one machine, rather than many at once
    #[arg(long)]
    pub one_by_one: bool,
    /// Write the picture as SVG
    #[arg(long, value_name = "FILE")]
    pub svg: Option<PathBuf>,
    /// Write the picture as PNG
    #[arg(long, value_name = "FILE")]
    pub png: Option<PathBuf>,
    /// Show each place of the pen as a dot
    #[arg(long, requires = "picture")]
    pub dots: bool,
    /// Show strokes in alternate colours
    #[arg(long, requires = "picture")]
    pub alternate: bool,
    /// Show the ways with the pen up
    #[arg(long, requires = "picture")]
    pub moves: bool,
    /// Print one JSON object
    #[arg(long)]
    pub json: bool,
}

pub(super) fn draw_file(arguments: &DrawArguments) -> Result<Ending, Report> {
    if arguments.tolerance < LEAST_TOLERANCE {
        let message = format!("no stroke keeps within {} counts: its ends are whole counts", arguments.tolerance);
        return Err(Diagnostic::new("C007", message)
            .help(format!("at least {LEAST_TOLERANCE}; or draw it larger"))
            .into());
    }
    let outputs = [&arguments.svg, &arguments.png].into_iter().flatten().map(PathBuf::as_path);
    check_files([arguments.file.as_path()], outputs.clone())?;
    let plot = read(&arguments.file)?;
    let sheet = placement(arguments).place(&plot.curves)?;
    let strokes = cut(&sheet, arguments.tolerance);
    plot.notes.iter().for_each(|note| say(&format!("warning: {note}")));
    let look = Look { dots: arguments.dots, alternate: arguments.alternate, moves: arguments.moves };
    let mut canvas = Canvas::new(&sheet, look);
    let how = if arguments.one_by_one { How::OneByOne } else { How::AtOnce };
    let is_whole = draw(&strokes, how, interrupt::flag(), |done| canvas.take(&strokes[done.index], &done))?;
    let (report, picture) = canvas.finish(&title(arguments), &command());
    if !is_whole {
        say(&format!("interrupted after {} of {} strokes; nothing was written", report.strokes, strokes.len()));
        return Ok(Ending::Different);
    }
    picture.svg().write(arguments.svg.as_deref(), arguments.png.as_deref())?;
    let text = match arguments.json {
        true => json_object(arguments, &plot, &sheet, &report),
        false => table(arguments, &sheet, &report),
    };
    if outputs.clone().any(files::is_standard_output) {
        say(text.trim_end());
    } else {
        print(&text)?;
    }
    Ok(Ending::Done)
}

fn read(path: &Path) -> Result<Plot, Report> {
    let ending = path.extension().unwrap_or_default().to_string_lossy();
    let kind = Kind::of(&ending).ok_or_else(|| {
        let diagnostic = Diagnostic::new("F001", format!("the ending of {} tells no kind of drawing", path.display()));
        diagnostic.help("known are .svg, .gcode, .nc, .ngc or .tap")
    })?;
    let text = files::read(path)?;
    plotfile::read(kind, &text.name, &text.text)
}

fn placement(arguments: &DrawArguments) -> Placement {
    match (arguments.fit, arguments.counts_per_mm) {
        (true, _) => Placement::Fit,
        (_, Some(counts)) => Placement::CountsPerMillimetre(counts),
        _ => Placement::Size(arguments.size.unwrap_or(4000.0)),
    }
}

fn title(arguments: &DrawArguments) -> String {
    let name = arguments.file.file_name().unwrap_or_default().to_string_lossy();
    format!("{name}, drawn by us3809868/fig09_function_generator")
}

/// The command line, so that it can be typed again.
fn command() -> String {
    let words: Vec<_> = std::env::args().skip(1).collect();
    let quoted = shlex::try_join(words.iter().map(String::as_str)).unwrap_or_default();
    format!("stepwright {quoted}")
}

fn table(arguments: &DrawArguments, sheet: &Sheet, report: &draw::Report) -> String {
    let Deviation { max, at, rms, end } = report.deviation;
    let [left, bottom, right, top] = report.extent;
    format!(
        "{}\n    strokes              {}\n    ticks                {}\n    pulses               {}\n    \
         length               {:.1} counts\n    box                  ({left}, {bottom}) to ({right}, {top}) counts\n    \
         scale                {:.4} counts a millimetre\n    deviation            {max:.3} counts at most, at ({}, {})\n    \
         \u{20}                    {rms:.3} counts in the root mean square, {end:.3} at the end of a curve\n    \
         tolerance            {} counts, for the strokes as they were told\n    pulses by SHA-256    {}\n",
        title(arguments),
        report.strokes,
        report.ticks,
        report.pulses,
        report.length,
        sheet.counts_per_millimetre,
        at[0],
        at[1],
        arguments.tolerance,
        report.hash,
    )
}

fn json_object(arguments: &DrawArguments, plot: &Plot, sheet: &Sheet, report: &draw::Report) -> String {
    let Deviation { max, at, rms, end } = report.deviation;
    let object = json!({
        "machine": "us3809868",
        "strokes": report.strokes,
        "ticks": report.ticks,
        "pulses": report.pulses,
        "length": report.length,
        "box": report.extent,
        "deviation": { "max": max, "at": at, "rms": rms, "end": end },
        "tolerance": arguments.tolerance,
        "counts_per_unit": sheet.counts_per_millimetre,
        "unit": "mm",
        "hash": report.hash,
        "warnings": plot.notes,
    });
    result::json("draw", object)
}

/// A number that is more than 0.
fn positive() -> impl TypedValueParser<Value = f64> {
    clap::builder::NonEmptyStringValueParser::new().try_map(|text| match text.parse::<f64>() {
        Ok(number) if number.is_finite() && number > 0.0 => Ok(number),
        _ => Err("expected a number that is more than 0"),
    })
}
