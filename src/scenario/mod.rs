//! The stimulus language, as data: it knows names, not engines.

mod model;
mod number;
mod reader;

pub use model::{Axis, Change, Expectations, Named, Plot, Scenario, Stop, Table, UntilNet};
pub use number::Number;
pub use reader::parse;
