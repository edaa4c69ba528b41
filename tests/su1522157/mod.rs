//! SU 1522157: the linear interpolator, its multiplexer, its prototype and a plotter with it, held against the patent.

mod accuracy;
mod chained;
mod equations;
mod figure;
mod limits;
mod machine;
mod minus_zero;
mod multiplexer;
pub mod oracle;
mod plotter;
mod prototype;
mod schedule;
mod vectors;
