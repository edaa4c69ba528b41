//! Logic: decisions made without memory.

pub mod decoder;
pub mod direction_control;
pub mod polarity_detector;
