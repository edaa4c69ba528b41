//! Computer 552 of US 3,809,868, FIG. 18: points and slopes in, loads of the registers of FIG. 18 out.
//!
//! ```text
//!   Case::curve ----> Curve --words()--> Stroke --writes()--> seven Writes, or Bus::draw, which waits for done
//!   Chain::flow ----> Steps of FIG. 19, one by one   ---^
//!   Chain::link ----> all its Sections, and Notes    ---^
//! ```
//!
//! A [`Case`] is one of the five conversions in real numbers; a [`Chain`] is what FIG. 19 reads, linked strokes without
//! corners; a [`Curve`] is a stroke in real numbers; a [`Stroke`] is one in the words of registers 556 to 566; a [`Note`]
//! is what the operator should know. [`appendix`] has the FORTRAN of Appendix A.
//!
//! Nothing here knows a netlist but [`Bus`], and that sees it only through the bus: it writes words and reads the status.
//!
//! ```
//! use stepwright::host::{Chain, Entry, Note};
//!
//! let chain = Chain::new([0.0, 0.0], 4.0) // P0, S0
//!     .then(Entry::Two { p3: [20.0, 35.0], p1: [60.0, 50.0] }) // case II
//!     .then(Entry::Two { p3: [160.0, 400.0], p1: [-50.0, 10.0] }) // not on a curve that leaves so
//!     .then(Entry::One { p1: [190.0, -30.0], s1: 0.0 }); // case I
//! let linked = chain.link();
//! assert_eq!(linked.sections.len(), 2);
//! assert_eq!(linked.sections[0].stroke.jklm, [-46, 14, 7, 57]);
//! assert!(matches!(&linked.notes[..], [Note::Cancelled { points, .. }] if *points == (4..=5)));
//! ```

pub mod appendix;
mod bus;
mod case;
mod chain;
mod curve;
mod flow;
mod note;
mod step;
mod stroke;

pub use bus::Bus;
pub use case::{Case, CaseTwo};
pub use chain::{Carry, Chain, Entry, Linked, Section};
pub use curve::{Curve, Point};
pub use flow::Flow;
pub use note::{Note, Refusal};
pub use step::Step;
pub use stroke::{LARGEST, Stroke, Write};
