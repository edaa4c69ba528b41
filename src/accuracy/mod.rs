//! How accurate an interpolator of straight segments is: every segment there is, measured inside the netlist.
//!
//! A [`Meter`] runs a circuit that has a `deviation_meter` behind its interpolator, many segments at once, and gives a
//! [`Frame`] for each; a [`Tally`] keeps what counts of them. [`Reference`] algorithms give the same frames without a
//! circuit, to compare with.

mod frame;
mod law;
mod meter;
mod quantity;
mod reference;
mod segments;
mod tally;

pub use frame::Frame;
pub use law::Printed;
pub use meter::Meter;
pub use quantity::Quantity;
pub use reference::Reference;
pub use segments::{Segments, count};
pub use tally::{Slope, Tally};
