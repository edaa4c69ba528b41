//! The stimulus language, as data: it knows names, not engines.

mod model;
mod number;
mod reader;
mod require;

pub use model::{Axis, Change, Expectations, Law, Measure, Named, Plot, Scenario, Stop, Table, UntilNet};
pub use number::Number;
pub use reader::{KEYS, parse};
pub use require::{Comparison, Requirement, Term};
