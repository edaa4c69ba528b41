//! The stimuli of a sweep: a cross product of ranges, or the rows of a CSV file, checked before anything runs.

use std::ops::Range;
use std::path::Path;

use serde_json::{Value, json};

use super::csv_file::CsvFile;
use super::ranges::Over;
use super::untimed;
use crate::base::{Diagnostic, Report, Sources};
use crate::netlist::Net;
use crate::scenario::Number;
use crate::simulation::Design;

/// How many errors of a CSV file are shown.
const MOST_ERRORS: usize = 100;

/// Checked stimuli.
pub struct Stimuli {
    /// Words of all inputs before the sweep sets its own.
    initial: Vec<u64>,
    /// Inputs that vary, in the order of the columns.
    varied: Vec<usize>,
    source: Source,
    count: u64,
}

enum Source {
    /// For each varied input its values, as words.
    Ranges(Vec<Axis>),
    Csv {
        file: CsvFile,
        ports: Vec<Port>,
    },
}

/// How a number becomes a word.
#[derive(Clone, Copy)]
struct Port {
    width: u32,
    signed: bool,
    fraction: Option<u32>,
}

impl Port {
    fn of(net: &Net) -> Self {
        Self { width: net.width, signed: net.signed, fraction: net.fraction }
    }

    fn encode(self, number: Number) -> Result<u64, String> {
        number.encode(self.width, self.signed, self.fraction)
    }
}

struct Axis {
    over: Over,
    port: Port,
    count: u64,
}

/// Fills the words of the inputs, stimulus after stimulus.
pub type Feed = Box<dyn FnMut(&mut [u64]) -> bool + Send>;

/// Sets the words of one row's columns; `false` when there is no row any more.
type NextRow = Box<dyn FnMut(&mut dyn FnMut(usize, u64)) -> bool + Send>;

impl Stimuli {
    /// The cross product of `over`, the last one varying fastest.
    ///
    /// # Errors
    /// `C061` a timed input, `C062` an input given twice, `C063` a value that does not fit, `C064` too many stimuli,
    /// `S010` unknown input.
    pub fn over(over: &[Over], design: &Design) -> Result<Self, Report> {
        let mut wrong = Vec::new();
        let mut axes = Vec::new();
        let varied = columns(over.iter().map(|over| over.name.as_str()), design, |error| wrong.push(error));
        for (over, &input) in over.iter().zip(&varied) {
            let Some(input) = input else { continue };
            let port = Port::of(net(design, input));
            let ends = over.spans.iter().flat_map(|span| [span.value(0), span.value(span.count() - 1)]);
            if let Some(error) = ends.filter_map(|end| port.encode(end).err()).next() {
                wrong.push(Diagnostic::new("C063", format!("--over {}: {error}", over.name)));
            }
            axes.push(over.count().map(|count| Axis { over: over.clone(), port, count }));
        }
        let axes: Option<Vec<_>> = axes.into_iter().collect();
        let count = axes.as_ref().and_then(|all| all.iter().try_fold(1_u64, |n, axis| n.checked_mul(axis.count)));
        match (axes, count) {
            (Some(axes), Some(count)) if wrong.is_empty() => {
                let varied = varied.into_iter().flatten().collect();
                Ok(Self { initial: design.stimulus().initial.clone(), varied, source: Source::Ranges(axes), count })
            }
            _ => {
                if wrong.is_empty() {
                    wrong.push(Diagnostic::new("C064", "the sweep has more than 2^64 stimuli").help("narrow a range"));
                }
                Err(Report::new(Sources::default(), wrong))
            }
        }
    }

    /// The rows of a CSV file, or of a pipe that brings one; its header names inputs. The whole file is checked, a row
    /// at a time.
    ///
    /// # Errors
    /// As [`Stimuli::over`], each with its line; `C065` what is no CSV.
    pub fn from_csv(path: &Path, design: &Design) -> Result<Self, Report> {
        let file = CsvFile::open(path)?;
        let mut reader = file.reader()?;
        let header = reader.headers().map_err(|error| file.wrong(&error))?.clone();
        let mut wrong = Wrong::default();
        if header.is_empty() {
            let empty = format!("{} is empty: its first line must name inputs", path.display());
            wrong.push(Diagnostic::new("C065", empty));
        }
        let varied: Option<Vec<_>> = columns(header.iter(), design, |error| wrong.push(error)).into_iter().collect();
        let Some(varied) = varied.filter(|_| wrong.is_empty()) else { return Err(wrong.report(path)) };
        let ports: Vec<_> = varied.iter().map(|&input| Port::of(net(design, input))).collect();
        let mut record = csv::ByteRecord::new();
        let mut count = 0;
        while reader.read_byte_record(&mut record).map_err(|error| file.wrong(&error))? {
            count += 1;
            for (code, what) in wrong_in(&record, &header, &ports) {
                let line = record.position().map_or(0, csv::Position::line);
                wrong.push(Diagnostic::new(code, format!("{}:{line}: {what}", path.display())));
            }
        }
        if !wrong.is_empty() {
            return Err(wrong.report(path));
        }
        let source = Source::Csv { file, ports };
        Ok(Self { initial: design.stimulus().initial.clone(), varied, source, count })
    }

    /// What they are, for the description of the sweep.
    pub fn describe(&self) -> Value {
        match &self.source {
            Source::Ranges(axes) => {
                json!({ "over": axes.iter().map(|axis| axis.over.to_string()).collect::<Vec<_>>() })
            }
            Source::Csv { file, .. } => json!({ "from_sha256": file.sha256(), "rows": self.count }),
        }
    }

    /// How many there are.
    pub fn count(&self) -> u64 {
        self.count
    }

    /// How many inputs the circuit has.
    pub fn inputs(&self) -> usize {
        self.initial.len()
    }

    /// The inputs that vary, in the order of the columns.
    pub fn varied(&self) -> &[usize] {
        &self.varied
    }

    /// The stimuli of these numbers.
    ///
    /// # Errors
    /// When the CSV file has gone.
    pub fn feed(&self, rows: Range<u64>) -> Result<Feed, Report> {
        let (initial, varied) = (self.initial.clone(), self.varied.clone());
        let mut next: NextRow = match &self.source {
            Source::Ranges(axes) => Self::cross_product(axes, rows),
            Source::Csv { file, ports } => {
                let skipped = usize::try_from(rows.start).unwrap_or(usize::MAX);
                let mut records = file.reader()?.into_records().skip(skipped);
                let (ports, mut left) = (ports.clone(), rows.end - rows.start);
                Box::new(move |set| {
                    // The file was checked as a whole; should it have changed since, the sweep ends here.
                    let record = records.next().and_then(Result::ok).filter(|_| left > 0);
                    left = left.saturating_sub(1);
                    let words: Option<Vec<_>> = record.and_then(|record| {
                        let fields = record.iter().zip(&ports);
                        fields.map(|(field, port)| port.encode(Number::parse(field).ok()?).ok()).collect()
                    });
                    words.iter().flatten().enumerate().for_each(|(column, &word)| set(column, word));
                    words.is_some()
                })
            }
        };
        Ok(Box::new(move |words| {
            words.copy_from_slice(&initial);
            next(&mut |column, word| words[varied[column]] = word)
        }))
    }

    fn cross_product(axes: &[Axis], mut rows: Range<u64>) -> NextRow {
        let axes: Vec<_> = axes.iter().map(|axis| (axis.over.clone(), axis.port, axis.count)).collect();
        Box::new(move |set| {
            let Some(mut rest) = rows.next() else { return false };
            for (column, (over, port, count)) in axes.iter().enumerate().rev() {
                let value = over.value(rest % count).and_then(|number| port.encode(number).ok());
                set(column, value.unwrap_or_default());
                rest /= count;
            }
            true
        })
    }
}

/// What is wrong with a CSV file: the errors that are shown, and how many more there are.
#[derive(Default)]
struct Wrong {
    shown: Vec<Diagnostic>,
    more: u64,
}

impl Wrong {
    fn push(&mut self, diagnostic: Diagnostic) {
        if self.shown.len() < MOST_ERRORS {
            self.shown.push(diagnostic);
        } else {
            self.more += 1;
        }
    }

    fn is_empty(&self) -> bool {
        self.shown.is_empty()
    }

    fn report(mut self, path: &Path) -> Report {
        if self.more > 0 {
            self.shown.push(Diagnostic::new("C065", format!("{}: {} more errors", path.display(), self.more)));
        }
        Report::new(Sources::default(), self.shown)
    }
}

fn net(design: &Design, input: usize) -> &Net {
    &design.netlist().nets[design.netlist().inputs[input].index()]
}

/// The inputs of the columns; what is wrong with one is told.
fn columns<'a>(
    names: impl Iterator<Item = &'a str>,
    design: &Design,
    mut tell: impl FnMut(Diagnostic),
) -> Vec<Option<usize>> {
    let known: Vec<_> = design.inputs().map(|port| port.name.as_str()).collect();
    let mut is_found = vec![false; known.len()];
    let mut found = Vec::new();
    for name in names {
        let input = known.iter().position(|known| *known == name);
        match input {
            None => {
                let message = format!("the circuit `{}` has no input `{name}`", design.circuit().name());
                let diagnostic = Diagnostic::new("S010", message).nearest(name, known.iter().copied());
                tell(diagnostic.help(format!("its inputs are: {}", known.join(", "))));
            }
            Some(input) if std::mem::replace(&mut is_found[input], true) => {
                tell(Diagnostic::new("C062", format!("the input `{name}` is given twice")));
            }
            Some(input) => untimed(design, input, name).unwrap_or_else(&mut tell),
        }
        found.push(input);
    }
    found
}

/// What is wrong in a row: its length, and each value.
fn wrong_in(record: &csv::ByteRecord, header: &csv::StringRecord, ports: &[Port]) -> Vec<(&'static str, String)> {
    let mut wrong = Vec::new();
    if record.len() != header.len() {
        wrong.push(("C065", format!("{} values for {} inputs", record.len(), header.len())));
    }
    for ((field, port), name) in record.iter().zip(ports).zip(header) {
        let word = Number::parse(&String::from_utf8_lossy(field)).and_then(|number| port.encode(number));
        wrong.extend(word.err().map(|error| ("C063", format!("{name}: {error}"))));
    }
    wrong
}
