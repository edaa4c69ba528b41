//! Routing: which word goes where.

pub mod bipolar_gate;
pub mod bound_switch;
pub mod data_switch;
pub mod instruction_multiplexer;
pub mod multiplexer;
pub mod polarity_gate;
pub mod quadrant_switch;
pub mod strobe_switch;
