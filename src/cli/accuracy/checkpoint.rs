//! What has been measured so far, in a file: whole numbers only, so that going on gives what one go gives.

use std::path::Path;

use serde_json::{Value, json};

use super::super::result::parameters;
use super::super::sweep::{RESUMED, differences, hash_of};
use crate::accuracy::{Frame, Meter, Slope, Tally};
use crate::base::{Diagnostic, Report};
use crate::files;

/// The number of the form of the file.
const FORMAT: u32 = 1;

/// A tally under way.
pub struct Checkpoint {
    /// What makes the measurement what it is.
    of: Value,
    /// The ticks that were run.
    pub ticks: u64,
    /// What was found.
    pub tally: Tally,
}

impl Checkpoint {
    /// Nothing measured yet.
    pub fn begin(meter: &Meter, max: u64) -> Self {
        let netlist = meter.design().netlist();
        let circuit = json!({ "module": netlist.scopes[0].module.to_string(), "sha256": hash_of(netlist) });
        let stimulus = format!("{:?}", meter.design().stimulus());
        let of = json!({
            "format": FORMAT, "stepwright": env!("CARGO_PKG_VERSION"), "circuit": circuit, "parameters": parameters(netlist),
            "stimulus": stimulus, "max": max,
        });
        Self { of, ticks: 0, tally: Tally::default() }
    }

    /// What a file has of this measurement.
    ///
    /// # Errors
    /// `C002`; `C066` a file of another measurement, or none.
    pub fn resumed(self, path: &Path) -> Result<Self, Report> {
        let text = files::read(path)?.text;
        let help = "resume with the command that began it, or leave out --resume";
        let none = || Diagnostic::new("C066", format!("{} is no checkpoint", path.display())).help(help);
        let there: Value = serde_json::from_str(&text).map_err(|_| none())?;
        let mut different = Vec::new();
        differences("", &there["of"], &self.of, RESUMED, &mut different);
        if !different.is_empty() {
            let wrong = Diagnostic::new("C066", format!("{} is of another measurement", path.display())).help(help);
            return Err(different.into_iter().fold(wrong, Diagnostic::help).into());
        }
        let (ticks, tally) = (there["ticks"].as_u64(), read(&there["tally"]));
        let (ticks, tally) = ticks.zip(tally).ok_or_else(none)?;
        Ok(Self { ticks, tally, ..self })
    }

    /// Writes it.
    ///
    /// # Errors
    /// `C003`.
    pub fn write(&self, path: &Path) -> Result<(), Report> {
        let text = json!({ "of": self.of, "ticks": self.ticks, "tally": written(&self.tally) });
        files::write_bytes(path, format!("{text:#}\n").as_bytes())
    }
}

fn written(tally: &Tally) -> Value {
    let slopes: Vec<_> = tally.slopes.iter().map(|slope| json!([slope.frames, numbers(&slope.worst)])).collect();
    json!({
        "segments": tally.segments, "violations": tally.violations, "beyond_printed": tally.beyond_printed,
        "astray": tally.astray, "unfinished": tally.unfinished, "worst": tally.worst.iter().map(numbers).collect::<Vec<_>>(),
        "end": numbers(&tally.end), "run": numbers(&tally.run), "slowest": tally.slowest.as_ref().map(numbers),
        "fastest": tally.fastest.as_ref().map(numbers), "no_length": tally.no_length.as_ref().map(numbers),
        "slopes": slopes,
    })
}

fn read(tally: &Value) -> Option<Tally> {
    let optional = |name: &str| match &tally[name] {
        Value::Null => Some(None),
        value => frame(value).map(Some),
    };
    let slope = |slope: &Value| Some(Slope { frames: slope[0].as_u64()?, worst: frame(&slope[1])? });
    let read = Tally {
        segments: tally["segments"].as_u64()?,
        violations: tally["violations"].as_u64()?,
        beyond_printed: tally["beyond_printed"].as_u64()?,
        astray: tally["astray"].as_u64()?,
        unfinished: tally["unfinished"].as_u64()?,
        worst: tally["worst"].as_array()?.iter().map(frame).collect::<Option<_>>()?,
        end: frame(&tally["end"])?,
        run: frame(&tally["run"])?,
        slowest: optional("slowest")?,
        fastest: optional("fastest")?,
        no_length: optional("no_length")?,
        slopes: tally["slopes"].as_array()?.iter().map(slope).collect::<Option<_>>()?,
    };
    (read.slopes.len() == Tally::default().slopes.len()).then_some(read)
}

fn numbers(frame: &Frame) -> Value {
    let Frame { major, minor, greatest, left_major, left_minor, steps, longest_run } = *frame;
    json!([major, minor, greatest, left_major, left_minor, steps, longest_run])
}

fn frame(value: &Value) -> Option<Frame> {
    let unsigned = |place: usize| value[place].as_u64();
    Some(Frame {
        major: unsigned(0)?,
        minor: unsigned(1)?,
        greatest: unsigned(2)?,
        left_major: value[3].as_i64()?,
        left_minor: value[4].as_i64()?,
        steps: unsigned(5)?,
        longest_run: unsigned(6)?,
    })
}
