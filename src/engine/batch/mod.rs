//! Batches: many independent stimuli of one program, answered in order.

mod row;

#[cfg(feature = "lanes")]
mod counters;
#[cfg(feature = "lanes")]
mod edges;
#[cfg(feature = "lanes")]
mod job;
#[cfg(feature = "lanes")]
mod queue;
#[cfg(feature = "lanes")]
mod run;
#[cfg(feature = "lanes")]
mod worker;

pub use row::{Done, Feed, Row, Sink};
#[cfg(feature = "lanes")]
pub use run::{Options, Sample, Watch, run_batch};

#[cfg(all(test, feature = "lanes"))]
mod tests;
