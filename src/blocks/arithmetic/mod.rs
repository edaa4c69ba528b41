//! Arithmetic: sums, products, quotients, roots.

pub mod acceleration_meter;
pub mod delay_regulator;
pub mod difference_circuit;
pub mod ones_complement_accumulator;
pub mod summer;
