//! Timing: clocks, delays, sequences.

mod chain;
pub mod clock_generator;
pub mod delay_element;
pub mod half_clock_delay;
pub mod programmable_delay;
pub mod pulse_distributor;
pub mod rank_sequencer;
pub mod stop_switch;
pub mod stroke_sequencer;
pub mod two_phase_clock;
