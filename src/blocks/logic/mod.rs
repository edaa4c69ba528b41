//! Logic: decisions made without memory.

pub mod decoder;
pub mod direction_control;
pub mod instruction_decoder;
pub mod limit_comparator;
pub mod order;
pub mod phase_detector;
pub mod polarity_detector;
