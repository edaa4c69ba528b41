//! Pulses: trains of one-tick strobes and their rates.

pub mod binary_rate_multiplier;
pub mod pulse_interleaver;
pub mod pulse_switch;
pub mod sn7497;
