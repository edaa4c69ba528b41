//! Routing: which word goes where.

pub mod bipolar_gate;
pub mod bound_switch;
pub mod data_switch;
pub mod instruction_multiplexer;
pub mod multiplexer;
pub mod octant_commutator;
pub mod or_network;
pub mod polarity_gate;
pub mod presettable_decoder;
pub mod quadrant_switch;
pub mod strobe_switch;
pub mod switch_matrix;
pub mod word_gate;
