//! The front door of the library: the shipped circuits, a stimulus resolved against a netlist, a run, and
//! [`Simulation`] for stepping by hand.

mod interactive;
mod run;
pub mod shipped;
mod stimulus;

pub use crate::engine::StoppedBy;
pub use interactive::Simulation;
pub use run::{Outcome, Sample, run};
pub use stimulus::{DEFAULT_LIMIT, Stimulus, StopRule, resolve};
