//! Routing: which word goes where.

pub mod multiplexer;
pub mod quadrant_switch;
