//! The data converters of US 3,809,868, FIG. 3 and 5 to 8, against the formulas in f64 and the vectors.

pub mod arcs;
mod as_printed;
mod formulas;
mod histogram;
mod rig;
mod system;
mod vectors;

pub use formulas::Data;
pub use rig::Converter;

/// File names of the five converters.
pub const CIRCUITS: [&str; 5] = ["fig03_case1", "fig05_case2", "fig06_case3", "fig07_case4", "fig08_case5"];
