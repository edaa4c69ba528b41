//! SU 1522157: the linear interpolator and its multiplexer, held against the patent.

mod accuracy;
mod equations;
mod figure;
mod limits;
mod machine;
mod multiplexer;
mod oracle;
mod schedule;
mod vectors;
