//! What a sweep runs: one part for each set of the parameters that it varies, each with all stimuli.

use super::SweepArguments;
use super::ranges::Over;
use super::rows::{Format, Measured, Rows};
use super::set_and_swept;
use super::stimuli::Stimuli;
use crate::accuracy::Meter;
use crate::base::{Diagnostic, Report};
use crate::scenario::Number;
use crate::simulation::{Batch, Design, Session};

/// How many circuits there may be: each is kept, elaborated, as long as the sweep lasts.
const MOST_PARTS: u64 = 1 << 10;

/// The parts of a sweep, in order.
pub struct Plan {
    parts: Vec<Part>,
    format: Format,
}

/// One circuit with its parameters, and the stimuli that it gets.
pub struct Part {
    /// The parameters that vary.
    parameters: Vec<(String, i64)>,
    runner: Runner,
    /// The stimuli.
    pub stimuli: Stimuli,
}

enum Runner {
    Design(Box<Design>),
    /// A circuit with a meter, for columns that are measured.
    Meter(Box<Meter>),
}

impl Plan {
    /// The parts of what was typed, all of them checked.
    ///
    /// # Errors
    /// `C062` a parameter given twice, `C063` a value that is none for a parameter, `C069` too many circuits, and all that is
    /// wrong with a circuit or its stimuli.
    pub fn new(arguments: &SweepArguments, format: Format) -> Result<Self, Report> {
        let (parameters, inputs): (Vec<_>, Vec<_>) =
            arguments.over.iter().cloned().partition(|over| over.name.starts_with("p:"));
        let session = arguments.target.session()?;
        let session = if arguments.measure.is_empty() { session } else { session.measured()? };
        let parts = sets(&parameters, &arguments.target.param)?.into_iter();
        let parts = parts.map(|parameters| Part::new(session.clone(), parameters, &inputs, arguments));
        Ok(Self { parts: parts.collect::<Result<_, _>>()?, format })
    }

    /// The first part: there always is one.
    pub fn first(&self) -> &Part {
        &self.parts[0]
    }

    /// How many rows there are; `None` beyond 2^64.
    pub fn rows(&self) -> Option<u64> {
        self.first().stimuli.count().checked_mul(self.parts.len() as u64)
    }

    /// The parts from row `skip` on, each with how many of its rows are skipped.
    pub fn from(&self, skip: u64) -> impl Iterator<Item = (&Part, u64)> {
        let each = self.first().stimuli.count();
        let done = skip.checked_div(each).unwrap_or(0);
        let parts = self.parts.iter().skip(usize::try_from(done).unwrap_or(usize::MAX));
        parts.enumerate().map(move |(i, part)| (part, if i == 0 { skip - done * each } else { 0 }))
    }

    /// How the rows of a part are written.
    pub fn written<'p>(&self, part: &'p Part, batch: &Batch<'_>, arguments: &'p SweepArguments) -> Rows<'p> {
        let quantities = &arguments.measure;
        let measured = match &part.runner {
            Runner::Design(_) => None,
            Runner::Meter(meter) => Some(Measured { quantities, meter }),
        };
        Rows::new(self.format, batch, &part.parameters, part.stimuli.varied(), measured)
    }
}

impl Part {
    fn new(
        session: Session,
        parameters: Vec<(String, i64)>,
        inputs: &[Over],
        arguments: &SweepArguments,
    ) -> Result<Self, Report> {
        let session = parameters.iter().fold(session, |session, (name, value)| session.parameter(name, *value));
        let runner = match arguments.measure.is_empty() {
            true => Runner::Design(Box::new(session.elaborate()?)),
            false => Runner::Meter(Box::new(Meter::of(session)?)),
        };
        let stimuli = match &arguments.from {
            Some(path) => Stimuli::from_csv(path, runner.design())?,
            None => Stimuli::over(inputs, runner.design())?,
        };
        set_and_swept(arguments, runner.design(), stimuli.varied())?;
        Ok(Self { parameters, runner, stimuli })
    }

    /// Its batch, on the threads that are asked for.
    ///
    /// # Errors
    /// `C067`.
    pub fn batch(&self, arguments: &SweepArguments) -> Result<Batch<'_>, Diagnostic> {
        let batch = self.design().batch();
        match arguments.threads {
            Some(threads) => batch.threads(threads.into()),
            None => Ok(batch),
        }
    }

    /// Its circuit.
    pub fn design(&self) -> &Design {
        self.runner.design()
    }
}

impl Runner {
    fn design(&self) -> &Design {
        match self {
            Runner::Design(design) => design,
            Runner::Meter(meter) => meter.design(),
        }
    }
}

/// Every set of values of some parameters, the last one varying fastest; one empty set for none.
pub(in crate::cli) fn sets(over: &[Over], given: &[(String, i64)]) -> Result<Vec<Vec<(String, i64)>>, Diagnostic> {
    let mut known: Vec<_> = given.iter().map(|(name, _)| name.as_str()).collect();
    for name in over.iter().map(parameter) {
        if known.contains(&name) {
            return Err(
                Diagnostic::new("C062", format!("the parameter `{name}` is given twice")).help("leave one of them out")
            );
        }
        known.push(name);
    }
    let count = over.iter().try_fold(1_u64, |count, over| count.checked_mul(over.count()?));
    if count.is_none_or(|count| count > MOST_PARTS) {
        let message = format!("the parameters make more than {MOST_PARTS} circuits");
        return Err(Diagnostic::new("C069", message).help("narrow a range"));
    }
    over.iter().try_fold(vec![Vec::new()], |sets, over| {
        let values: Vec<_> = (0..over.count().unwrap_or(0)).filter_map(|i| over.value(i)).collect();
        let values: Vec<_> = values.into_iter().map(|value| whole(over, value)).collect::<Result<_, _>>()?;
        let longer = |set: &Vec<(String, i64)>| {
            let set = set.clone();
            let with = |&value: &i64| [&set[..], &[(parameter(over).to_owned(), value)]].concat();
            values.iter().map(with).collect::<Vec<_>>()
        };
        Ok(sets.iter().flat_map(longer).collect())
    })
}

fn parameter(over: &Over) -> &str {
    over.name.trim_start_matches("p:")
}

fn whole(over: &Over, value: Number) -> Result<i64, Diagnostic> {
    let value = match value {
        Number::Word(word) => i64::try_from(word).ok(),
        Number::Real(_) => None,
    };
    value.ok_or_else(|| {
        let message = format!("--over {}: a parameter is a whole number of 64 bits", over.name);
        Diagnostic::new("C063", message)
    })
}
