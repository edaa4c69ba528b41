//! Rows as text: CSV, or JSON lines.

use std::fmt::{Display, Write};
use std::path::Path;

use crate::accuracy::{Meter, Quantity};
use crate::base::word::decode;
use crate::base::{Diagnostic, Port};
use crate::simulation::{Batch, Row};

/// How rows are written.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Format {
    /// A header, then a line for each row.
    Csv,
    /// A JSON object for each row.
    JsonLines,
}

impl Format {
    /// The format that a file's name asks for; CSV for a name without an ending, such as /dev/null.
    ///
    /// # Errors
    /// `C068` another ending.
    pub fn of(path: Option<&Path>) -> Result<Self, Diagnostic> {
        let ending = path.and_then(Path::extension).map(|ending| ending.to_string_lossy());
        match ending.as_deref() {
            None | Some("csv") => Ok(Format::Csv),
            Some("jsonl" | "ndjson" | "json") => Ok(Format::JsonLines),
            Some(_) => {
                let name = path.unwrap_or(Path::new("-")).display();
                let wrong = Diagnostic::new("C068", format!("the name {name} does not tell a format of rows"));
                Err(wrong.help("end it in .csv, or in .jsonl for JSON lines"))
            }
        }
    }

    /// Whether a line that was written tells of a run that reached its limit. All else in it are numbers and names.
    pub fn is_at_limit(self, line: &[u8]) -> bool {
        let word: &[u8] = match self {
            Format::Csv => b",limit",
            Format::JsonLines => b"\"stopped_by\":\"limit\"",
        };
        line.windows(word.len()).any(|window| window == word)
    }
}

/// The columns of a CSV that are of the run and of no port; what is measured comes behind them.
const OF_THE_RUN: [&str; 2] = ["ticks", "stopped_by"];

/// What of a row is measured: its columns, and their numbers.
#[derive(Clone, Copy)]
pub struct Measured<'a> {
    /// The columns.
    pub quantities: &'a [Quantity],
    /// What tells the numbers.
    pub meter: &'a Meter,
}

/// A column: names of ports are identifiers, so that neither format has to quote or escape anything.
#[derive(Clone, Debug)]
struct Column {
    name: String,
    width: u32,
    signed: bool,
}

impl Column {
    fn of(port: &Port) -> Self {
        Self { name: port.name.clone(), width: port.width, signed: port.signed }
    }

    fn number(&self, word: u64) -> i128 {
        decode(word, self.width, self.signed)
    }
}

/// Writes rows of one batch.
#[derive(Clone)]
pub struct Rows<'a> {
    format: Format,
    /// Parameters that the sweep varies, which stand before the inputs.
    parameters: Vec<(String, i64)>,
    measured: Option<Measured<'a>>,
    varied: Vec<usize>,
    inputs: Vec<Column>,
    outputs: Vec<Column>,
    pulses: Vec<String>,
}

impl<'a> Rows<'a> {
    /// Rows with the parameters and inputs that vary, all outputs, what is measured, and the pulse counts.
    pub fn new(
        format: Format,
        batch: &Batch<'_>,
        parameters: &[(String, i64)],
        varied: &[usize],
        measured: Option<Measured<'a>>,
    ) -> Self {
        Self {
            format,
            parameters: parameters.to_vec(),
            measured,
            varied: varied.to_vec(),
            inputs: varied.iter().map(|&input| Column::of(&batch.inputs()[input])).collect(),
            outputs: batch.outputs().iter().map(Column::of).collect(),
            pulses: batch.counted().map(|port| port.name.clone()).collect(),
        }
    }

    /// The first line of the file; none for JSON lines. No two columns share a name: a port that is called as a column
    /// of the run is told from it by where it stands in a JSON line.
    pub fn header(&self) -> Option<String> {
        let measured: Vec<_> = self.quantities().iter().map(|quantity| quantity.name()).collect();
        let is_taken = |name: &str| OF_THE_RUN.contains(&name) || measured.contains(&name);
        let named = |kind: &str, column: &Column| match is_taken(&column.name) {
            true => format!("{kind}.{}", column.name),
            false => column.name.clone(),
        };
        let inputs = self.inputs.iter().map(|column| named("inputs", column));
        let outputs = self.outputs.iter().map(|column| named("outputs", column));
        let pulses = self.pulses.iter().map(|name| format!("pulses.{name}"));
        let parameters = self.parameters.iter().map(|(name, _)| format!("p:{name}"));
        let own = OF_THE_RUN.iter().chain(&measured).map(|name| (*name).to_owned());
        let all: Vec<_> = parameters.chain(inputs).chain(outputs).chain(own).chain(pulses).collect();
        (self.format == Format::Csv).then(|| all.join(",") + "\n")
    }

    fn quantities(&self) -> &[Quantity] {
        self.measured.map_or(&[], |measured| measured.quantities)
    }

    /// How the row of a stimulus begins: with its parameters and inputs.
    pub fn beginning(&self, inputs: &[u64]) -> String {
        let words: Vec<_> = self.varied.iter().map(|&input| inputs[input]).collect();
        let mut text = String::new();
        match self.format {
            Format::Csv => {
                for (_, value) in &self.parameters {
                    let _ = write!(text, "{value},");
                }
                numbers(&self.inputs, &words, &mut text);
            }
            Format::JsonLines => {
                text.push('{');
                if !self.parameters.is_empty() {
                    text.push_str("\"parameters\":");
                    pairs(self.parameters.iter().map(|(name, value)| (name, value)), &mut text);
                    text.push(',');
                }
                text.push_str("\"inputs\":");
                object(&self.inputs, &words, &mut text);
                text.push(',');
            }
        }
        text
    }

    /// What is measured of a row, column by column.
    pub fn measures(&self, row: &Row<'_>) -> Vec<(&'static str, f64)> {
        let Some(Measured { quantities, meter }) = self.measured else { return Vec::new() };
        let frame = meter.frame(row);
        quantities.iter().map(|quantity| (quantity.name(), quantity.of(&frame))).collect()
    }

    /// How they are written.
    pub fn format(&self) -> Format {
        self.format
    }

    /// The same rows as CSV.
    pub fn as_csv(&self) -> Self {
        Self { format: Format::Csv, ..self.clone() }
    }

    /// Appends a row and its line end.
    pub fn write(&self, row: Row<'_>, text: &mut String) {
        text.push_str(&self.beginning(row.inputs));
        let (ticks, stopped_by) = (row.ticks, row.stopped_by);
        let measures = self.measures(&row);
        // Writing into a string cannot fail.
        match self.format {
            Format::Csv => {
                numbers(&self.outputs, row.outputs, text);
                let _ = write!(text, "{ticks},{stopped_by}");
                for (_, number) in measures {
                    let _ = write!(text, ",{number}");
                }
                for count in row.pulses {
                    let _ = write!(text, ",{count}");
                }
            }
            Format::JsonLines => {
                let _ = write!(text, "\"ticks\":{ticks},\"stopped_by\":\"{stopped_by}\",\"outputs\":");
                object(&self.outputs, row.outputs, text);
                if !measures.is_empty() {
                    text.push_str(",\"measures\":");
                    pairs(measures.into_iter(), text);
                }
                text.push_str(",\"pulses\":");
                pairs(self.pulses.iter().zip(row.pulses), text);
                text.push('}');
            }
        }
        text.push('\n');
    }
}

/// Each number and a comma.
fn numbers(columns: &[Column], words: &[u64], text: &mut String) {
    for (column, &word) in columns.iter().zip(words) {
        let _ = write!(text, "{},", column.number(word));
    }
}

fn object(columns: &[Column], words: &[u64], text: &mut String) {
    pairs(columns.iter().zip(words).map(|(column, &word)| (&column.name, column.number(word))), text);
}

/// An object of names and numbers.
fn pairs(pairs: impl Iterator<Item = (impl Display, impl Display)>, text: &mut String) {
    text.push('{');
    for (i, (name, number)) in pairs.enumerate() {
        let _ = write!(text, "{}\"{name}\":{number}", if i > 0 { "," } else { "" });
    }
    text.push('}');
}
