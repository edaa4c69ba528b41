//! Stepwright: a cycle-accurate simulator for digital interpolation hardware.
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
