//! The front door: open a circuit, set it up, run it, look at it. Everything that runs a circuit comes through here.
//!
//! ```text
//!   Circuit --session()--> Session --elaborate()--> Design --start()--> Run
//!   Session::open(scenario) --^                        \--batch()--> Batch
//! ```
//!
//! A [`Circuit`] is text and where its modules are found; a [`Session`] is what shall be done with it (a scenario is the
//! same in a file); a [`Design`] is the checked netlist with all names resolved; a [`Run`] stands at a tick.

mod batch;
mod circuit;
mod design;
mod expect;
mod find;
mod library;
mod measured;
mod names;
mod outcome;
mod pace;
mod require;
mod run;
mod session;
pub mod shipped;
mod stimulus;

pub use batch::Batch;
pub use circuit::Circuit;
pub use design::Design;
pub use measured::measurable;
pub use outcome::{Outcome, Output};
pub use require::Broken;
pub use run::{Input, Net, Run};
pub use session::Session;
pub use stimulus::DEFAULT_LIMIT;

pub use crate::base::StoppedBy;
pub use crate::engine::batch::{Done, Row};
pub use crate::engine::{EngineKind, Stats};
