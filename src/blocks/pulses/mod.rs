//! Pulses: their rates, their edges, and what they drive.

pub mod binary_rate_multiplier;
pub mod pulse_interleaver;
pub mod pulse_switch;
pub mod sn7497;
pub mod step_burst;
pub mod stepping_motor;
pub mod trailing_edge;
