//! What a scenario says, name by name.

use super::number::Number;
use super::require::Requirement;
use crate::base::Span;

/// Something with a name and the place where the name stands, when it comes from a file.
#[derive(Clone, PartialEq, Debug)]
pub struct Named<T> {
    /// The name of a port, parameter or net.
    pub name: String,
    /// What is said of it.
    pub value: T,
    /// Where; `None` when it came from the command line.
    pub span: Option<Span>,
}

/// A circuit, what is done to it, and what is expected.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Scenario {
    /// One line on what it shows.
    pub title: String,
    /// The circuit: a name such as `su1522157/interpolator`, or a path.
    pub circuit: String,
    /// Where that is said.
    pub circuit_span: Option<Span>,
    /// Where the golden trace is, seen from the scenario's folder; at the usual place without it.
    pub golden: Option<String>,
    /// Parameters of the top module.
    pub parameters: Vec<Named<i64>>,
    /// Inputs held from tick 0. Inputs not named are 0.
    pub inputs: Vec<Named<Number>>,
    /// What the inputs have to satisfy, as long as the run lasts; each with its text as its name.
    pub require: Vec<Named<Requirement>>,
    /// Changes of inputs, in order of tick; a changed input keeps its value.
    pub changes: Vec<Change>,
    /// When to stop.
    pub stop: Option<Stop>,
    /// Globs over the names of the signals to trace; empty for all.
    pub trace: Vec<Named<()>>,
    /// How `--table` shows the run.
    pub table: Option<Table>,
    /// The two signals whose path `run` draws.
    pub plot: Option<Plot>,
    /// What it measures, when its circuit is another one with a meter behind it.
    pub measure: Option<Measure>,
    /// What must come out.
    pub expect: Expectations,
}

/// What a circuit with a `deviation_meter` says of the linear interpolator before it.
#[derive(Clone, PartialEq, Debug)]
pub struct Measure {
    /// The circuit that it measures.
    pub of: String,
    /// The input of the greater projection.
    pub major: Named<()>,
    /// The input of the lesser one.
    pub minor: Named<()>,
    /// How long a combined step is along each axis, in whole steps.
    pub combined: f64,
    /// The deviation that is claimed of a segment at an angle a: `sin` times sin a and `cos` times cos a, in whole steps.
    pub law: Law,
    /// The same as it is printed: an amplitude in whole steps, and the angle in degrees that is added to a.
    pub printed: Option<[f64; 2]>,
    /// How far off the end may be along either axis, in whole steps.
    pub end: f64,
}

/// A deviation over the angle of a segment: a sum of its sine and its cosine.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Law {
    /// Factor of the sine.
    pub sin: f64,
    /// Factor of the cosine.
    pub cos: f64,
}

/// Inputs that change at a tick.
#[derive(Clone, PartialEq, Debug)]
pub struct Change {
    /// From this tick on.
    pub tick: u64,
    /// New values.
    pub set: Vec<Named<Number>>,
}

/// When a run ends.
#[derive(Clone, PartialEq, Debug)]
pub enum Stop {
    /// After so many ticks.
    Ticks(u64),
    /// When a net is high or low, but after `limit` ticks at the latest.
    Until {
        /// The net.
        net: UntilNet,
        /// Most ticks to run; reaching it is a failure.
        limit: u64,
    },
}

/// `NET` or `!NET`.
#[derive(Clone, PartialEq, Debug)]
pub struct UntilNet {
    /// Dotted name below the top module.
    pub net: String,
    /// `true`: until any bit is 1; `false` (written `!NET`): until all bits are 0.
    pub high: bool,
    /// Where it is written.
    pub span: Option<Span>,
}

impl UntilNet {
    /// Reads `NET` or `!NET`.
    #[must_use]
    pub fn parse(text: &str, span: Option<Span>) -> Self {
        match text.strip_prefix('!') {
            Some(net) => Self { net: net.trim().to_owned(), high: false, span },
            None => Self { net: text.trim().to_owned(), high: true, span },
        }
    }
}

/// A table of signals, a row for each tick in which one of `when` is high (every tick without them).
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Table {
    /// Strobe nets.
    pub when: Vec<Named<()>>,
    /// Signals, in order; empty for all outputs.
    pub columns: Vec<Named<()>>,
    /// How many ticks after that a row is taken: when the pulse has landed.
    pub after: u64,
}

/// A path to draw.
#[derive(Clone, PartialEq, Debug)]
pub struct Plot {
    /// Horizontal axis.
    pub x: Axis,
    /// Vertical axis.
    pub y: Axis,
    /// The net that is high while the path is drawn; always, without one.
    pub pen: Option<Named<()>>,
}

/// Where a coordinate comes from.
#[derive(Clone, PartialEq, Debug)]
pub enum Axis {
    /// The value of a signal.
    Signal(Named<()>),
    /// The sum of pulses so far, each net with the length of its step: `{ step_x_36 = 1, step_xy_38 = 0.75 }`.
    Steps(Vec<Named<f64>>),
}

impl Plot {
    /// The signals that make the coordinates.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        [&self.x, &self.y].into_iter().flat_map(|axis| match axis {
            Axis::Signal(signal) => vec![signal.name.as_str()],
            Axis::Steps(steps) => steps.iter().map(|step| step.name.as_str()).collect(),
        })
    }
}

/// What a run must come to.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Expectations {
    /// Ticks run.
    pub ticks: Option<u64>,
    /// `until`, `ticks` or `limit`.
    pub stopped_by: Option<String>,
    /// Numbers on outputs and other nets at the end.
    pub outputs: Vec<Named<Number>>,
    /// Pulses that one-bit outputs gave: rising edges, and one for an output that was high in tick 0.
    pub pulses: Vec<Named<u64>>,
}
