//! How accurate an interpolator is: every straight segment there is, measured inside the netlist, or sampled strokes.
//!
//! A [`Meter`] runs a circuit that has a `deviation_meter` behind its interpolator, many segments at once, and gives a
//! [`Frame`] for each; a [`Tally`] keeps what counts of them. [`Reference`] algorithms give the same frames without a
//! circuit, to compare with. Elliptical strokes, which are too many and too long, are [sampled](sample) and
//! [followed](strokes) pulse by pulse.

mod frame;
mod law;
mod meter;
mod quantity;
mod reference;
mod segments;
mod stroke;
mod tally;

pub use frame::Frame;
pub use law::{Claim, Printed};
pub use meter::Meter;
pub use quantity::Quantity;
pub use reference::Reference;
pub use segments::{Segments, count};
pub use stroke::{Coefficients, Stroke, draws_strokes, sample, strokes};
pub use tally::{Slope, Tally};
