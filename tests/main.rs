//! The one integration-test binary; each module tests one concern from outside.

/// `accuracy`: what a meter behind the interpolator says.
mod accuracy;
/// What `check` says went wrong first.
mod cause;
/// The command line as scripts see it.
mod cli;
/// Codes that no other test raises.
mod codes;
/// The data converters of US 3,809,868.
mod converters;
/// The table of diagnostics.
mod diagnostics;
mod draw;
/// Engines agree with each other and with the meaning of the ops.
mod engines;
/// The longest runs of the shipped scenarios.
mod extremes;
/// The multiplying function generator of US 3,809,868.
mod function_generator;
/// Random circuits and stimuli.
mod generate;
/// Golden traces on every engine.
mod goldens;
/// Signals, and what they leave.
#[cfg(target_os = "linux")]
mod interrupts;
/// Sweeps that measure.
mod measures;
/// Circuits as text.
mod netlist;
/// Numerals of figures and names in circuits.
mod numerals;
/// Files that a command writes.
#[cfg(target_os = "linux")]
mod outputs;
mod outside;
/// Pages that say what the code does.
mod pages;
mod ranges;
/// Sweeps in shards.
mod shards;
mod simulation;
mod specialised;
/// The linear interpolator of SU 1522157 and its multiplexer.
mod su1522157;
/// What several concerns need.
mod support;
mod sweep;
mod tidy;
mod us3809868;
