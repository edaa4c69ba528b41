//! Arithmetic: sums, products, quotients, roots.

pub mod summer;
