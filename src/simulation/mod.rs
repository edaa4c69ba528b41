//! The front door of the library: the shipped circuits, a stimulus resolved against a netlist, a run.

mod run;
pub mod shipped;
mod stimulus;

pub use run::{Outcome, Sample, StoppedBy, run};
pub use stimulus::{DEFAULT_LIMIT, Stimulus, StopRule, resolve};
