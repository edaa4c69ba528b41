//! Routing: which word goes where.

pub mod multiplexer;
