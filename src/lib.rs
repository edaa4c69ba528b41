//! Stepwright: a cycle-accurate simulator for digital interpolation hardware.
//!
//! Circuits are netlists of clocked blocks in structural Verilog; a run goes tick by tick, and everything in it can be
//! read, traced, compared with a golden trace, and exported for other simulators.
//!
//! ```
//! use stepwright::simulation::Simulation;
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! // One frame of the linear interpolator of SU 1522157: the segment from (0, 0) to (8, 3).
//! let mut frame = Simulation::load("su1522157/interpolator", &[("WIDTH", 12)])?;
//! frame.trace(&["step_*", "f_1"], std::io::sink())?; // a VCD; give it a file
//! frame.set("major_32", 8)?;
//! frame.set("minor_34", 3)?;
//! frame.set("x_is_major_35", 1)?;
//! frame.set("start_33", 1)?;
//! frame.step();
//! frame.set("start_33", 0)?;
//!
//! assert!(frame.run_until("step_x_36", 100)?, "the first step is along X");
//! assert_eq!(frame.read("f_1")?, 3); // F0 = 0.375, in eighths
//! assert!(frame.run_until("step_xy_38", 100)?, "the second one is combined");
//! assert_eq!(frame.read("f_1")?, -21); // 0.375 - 3
//! frame.end_trace()?;
//! # Ok(())
//! # }
//! ```
//!
//! # Words used here
//!
//! | word | means |
//! |---|---|
//! | block | a kind of part with ports and parameters, made of ops ([`blocks`]) |
//! | cell | an instance of a block or gate in a circuit |
//! | net | a wire or vector of a circuit; its bits are driven once each |
//! | port | an input or output of a module or block |
//! | op | a word-level operation; engines and the Verilog printer know nothing else ([`base::Op`]) |
//! | tick | one step of the one global time |
//! | settle | to compute every combinational value of a tick |
//! | commit | to change all state together, at the end of a tick |
//! | sample point | after settling, before commit: what waveforms show for a tick |
//! | strobe | a one-bit signal that is 1 for one tick: a patent's pulse |
//! | scenario | a circuit, its stimulus, and what is expected ([`scenario`]) |
//! | golden | a trace that has been looked at and is now the standard ([`golden`]) |
//! | bless | to make a new trace golden |
#![warn(missing_docs)]

pub mod base;
pub mod blocks;
pub mod cli;
pub mod compile;
pub mod engine;
pub mod export;
pub mod golden;
pub mod netlist;
pub mod scenario;
pub mod simulation;
pub mod trace;
