//! What a sweep runs: one part for each set of the parameters that it varies, each with all stimuli; of these the rows
//! of its shard.

use std::ops::Range;

use super::SweepArguments;
use super::ranges::Over;
use super::rows::{Format, Measured, Rows};
use super::set_and_swept;
use super::shard::Shard;
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
    all: u64,
    shard: Option<Shard>,
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
    /// `C062` a parameter given twice, `C063` a value that is none for a parameter, `C064` too many rows, `C069` too many
    /// circuits, `C080` and `C081` no shard, and all that is wrong with a circuit or its stimuli.
    pub fn new(arguments: &SweepArguments, format: Format) -> Result<Self, Report> {
        let shard = arguments.shard.as_deref().map(|text| Shard::parse(text, |name| std::env::var(name).ok()));
        let shard = shard.transpose()?;
        let (parameters, inputs): (Vec<_>, Vec<_>) =
            arguments.over.iter().cloned().partition(|over| over.name.starts_with("p:"));
        let session = arguments.target.session()?;
        let session = if arguments.measure.is_empty() { session } else { session.measured()? };
        let parts = sets(&parameters, &arguments.target.param)?.into_iter();
        let parts = parts.map(|parameters| Part::new(session.clone(), parameters, &inputs, arguments));
        let parts = parts.collect::<Result<Vec<_>, _>>()?;
        let Some(all) = parts[0].stimuli.count().checked_mul(parts.len() as u64) else {
            return Err(Diagnostic::new("C064", "the sweep has more than 2^64 stimuli").help("narrow a range").into());
        };
        Ok(Self { parts, format, all, shard })
    }

    /// The first part: there always is one.
    pub fn first(&self) -> &Part {
        &self.parts[0]
    }

    /// How many rows all shards have.
    pub fn all(&self) -> u64 {
        self.all
    }

    /// The shard that is asked for.
    pub fn shard(&self) -> Option<Shard> {
        self.shard
    }

    /// The rows to run: those of the shard, or all.
    pub fn rows(&self) -> Range<u64> {
        self.shard.map_or(0..self.all, |shard| shard.rows(self.all))
    }

    /// The parts that some rows are of, each with its own numbers of them.
    pub fn within(&self, rows: Range<u64>) -> impl Iterator<Item = (&Part, Range<u64>)> {
        let each = self.first().stimuli.count();
        let own = move |(i, part)| {
            let first = i as u64 * each;
            let own = rows.start.max(first)..rows.end.min(first + each);
            (own.start < own.end).then(|| (part, own.start - first..own.end - first))
        };
        self.parts.iter().enumerate().filter_map(own)
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
