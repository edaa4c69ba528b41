//! Arithmetic: sums, products, quotients, roots.

pub mod ones_complement_accumulator;
pub mod summer;
