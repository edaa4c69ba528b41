//! Stepwright: a cycle-accurate simulator for digital interpolation hardware.
//!
//! Circuits are netlists of clocked blocks in structural Verilog; a run goes tick by tick, and everything in it can be
//! read, traced, compared with a golden trace, and exported for other simulators.
//!
//! ```
//! use stepwright::simulation::Circuit;
//! use stepwright::trace::{Select, Wave};
//!
//! # fn main() -> Result<(), stepwright::base::Report> {
//! # let folder = tempfile::tempdir().expect("a folder");
//! # let file = folder.path().join("frame.fst");
//! // One frame of the linear interpolator of SU 1522157: the segment from (0, 0) to (8, 3).
//! let circuit = Circuit::shipped("su1522157/interpolator")?;
//! let mut frame = circuit
//!     .session()
//!     .parameter("WIDTH", 12)
//!     .input("major_32", 8)
//!     .input("minor_34", 3)
//!     .input("x_is_major_35", 1)
//!     .start()?;
//! let (start, f) = (frame.input("start_33")?, frame.net("f_1")?);
//! let [step_x, step_xy] = [frame.net("step_x_36")?, frame.net("step_xy_38")?];
//! frame.record(Wave::create(&file)?.of(Select::new(["step_*", "f_1"])?))?; // the ending says FST
//! frame.set(start, 1)?;
//! frame.step(1);
//! frame.set(start, 0)?;
//!
//! assert!(frame.until(step_x, 100), "the first step is along X");
//! assert_eq!(frame.read(f), 3); // F0 = 0.375, in eighths
//! assert!(frame.until(step_xy, 100), "the second one is combined");
//! assert_eq!(frame.read(f), -21); // 0.375 - 3
//! frame.end_recording()?;
//! # Ok(())
//! # }
//! ```
//!
//! [`simulation`] is the front door: everything that runs a circuit comes through it, the command line included. The
//! command line is the default feature `cli`; a program that embeds the interpreter alone builds without any feature,
//! and gets the fast engines by `native` and `lanes`.
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
//! | pulse | a level with a rising and a trailing edge; rising edges are what is counted |
//! | strobe | a pulse of one tick |
//! | observer | what looks at a run tick by tick: a waveform, a table, a path ([`trace::Observer`]) |
//! | scenario | a circuit, its stimulus, and what is expected ([`scenario`]) |
//! | golden | a trace that has been looked at and is now the standard ([`golden`]) |
//! | bless | to make a new trace golden |
#![warn(missing_docs)]

#[cfg(feature = "cli")]
pub mod accuracy;
pub mod base;
pub mod blocks;
#[cfg(feature = "cli")]
pub mod cli;
pub mod compile;
#[cfg(feature = "draw")]
pub mod draw;
pub mod engine;
pub mod export;
pub mod files;
pub mod golden;
pub mod host;
pub mod netlist;
#[cfg(feature = "pictures")]
pub mod picture;
#[cfg(feature = "pictures")]
pub mod plot;
#[cfg(feature = "draw")]
pub mod plotfile;
pub mod scenario;
pub mod simulation;
pub mod trace;

/// The program on the front page does what it says.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
