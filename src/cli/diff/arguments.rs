//! What can be typed after `diff`.

use std::path::PathBuf;

use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};

use crate::cli::completions;
use crate::golden::Unknown;

/// Arguments of `diff`.
#[derive(Args, Debug)]
#[command(
    after_help = "Examples:\n  stepwright diff traces/su1522157/table1.vcd out.vcd --circuit su1522157/table1\n  \
    stepwright diff mine.fst bench.vcd --map top.u1=bench.dut --at clk --mask zero\n\n\
    Files are VCD or FST. Signals stand for each other by the longest common tail of their names; those that only one\n\
    file has are told, and are no difference. A bus in one file may be single bits in the other."
)]
pub struct DiffArguments {
    /// The expected waveform
    pub a: PathBuf,
    /// The other one
    pub b: PathBuf,
    /// The circuit or scenario that both show: walk the drivers back to the nets that first went wrong
    #[arg(long, value_name = "CIRCUIT|SCENARIO", add = completions::targets())]
    pub circuit: Option<PathBuf>,
    /// Let a scope or signal of the first file stand for one of the second (may be given again)
    #[arg(long, value_name = "A=B", value_parser = pair)]
    pub map: Vec<(String, String)>,
    /// Look just before each rising edge of a net, with ! each falling one, in the files that have it; else at every change
    #[arg(long, value_name = "NET|!NET")]
    pub at: Option<String>,
    /// What a bit that is x or z equals: itself only, anything, or what 0 does
    #[arg(long, value_name = "HOW", default_value = "strict", value_parser = unknown())]
    pub mask: Unknown,
    /// Forgive differences that last no more than so many ticks
    #[arg(long, value_name = "TICKS", default_value_t = 0)]
    pub late: u64,
    /// Forgive numbers that are no further apart
    #[arg(long, value_name = "DISTANCE", default_value = "0", value_parser = distance)]
    pub near: f64,
    /// Compare from this tick on
    #[arg(long, value_name = "TICK")]
    pub from: Option<u64>,
    /// Compare up to and including this tick
    #[arg(long, value_name = "TICK")]
    pub to: Option<u64>,
    /// Print one JSON object
    #[arg(long)]
    pub json: bool,
}

/// What x and z are equal to, by a word.
fn unknown() -> impl TypedValueParser<Value = Unknown> {
    PossibleValuesParser::new(["strict", "wild", "zero"]).map(|word| match word.as_str() {
        "wild" => Unknown::Wild,
        "zero" => Unknown::Zero,
        _ => Unknown::Strict,
    })
}

/// A number that is not negative.
fn distance(text: &str) -> Result<f64, String> {
    let number = text.parse().ok().filter(|number: &f64| *number >= 0.0 && number.is_finite());
    number.ok_or_else(|| "expected a number of 0 or more".to_owned())
}

/// `A=B`.
fn pair(text: &str) -> Result<(String, String), String> {
    let pair = text.split_once('=').ok_or("expected A=B")?;
    Ok((pair.0.trim().to_owned(), pair.1.trim().to_owned()))
}
