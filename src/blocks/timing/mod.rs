//! Timing: clocks, delays, sequences.

mod chain;
pub mod clock_generator;
pub mod delay_element;
pub mod pulse_distributor;
