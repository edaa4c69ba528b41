//! Arithmetic: sums, products, quotients, roots.

mod words;

pub mod absolute_value;
pub mod dda_integrator;
pub mod delay_regulator;
pub mod deviation_meter;
pub mod difference_circuit;
pub mod diode_approximator;
pub mod divider;
pub mod integrator;
pub mod limit_inverter;
pub mod multiplier;
pub mod negator;
pub mod ones_complement_accumulator;
pub mod reference;
pub mod rounder;
pub mod square_rooter;
pub mod squaring_circuit;
pub mod summer;
pub mod vector_magnitude;
pub mod velocity_compensator;
