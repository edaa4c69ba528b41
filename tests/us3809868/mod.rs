//! The figures of US 3,809,868 against the patent's equations, its reading's vectors, and data sheets.

mod analyzer_338;
mod fig09_errors;
mod fig09_lanes;
mod fig09_path;
mod fig09_strokes;
mod fig10_control;
mod fig10_system;
mod machine;
mod multipliers;
mod pulse_edges;
mod tables;
mod vectors;
mod velocity;
