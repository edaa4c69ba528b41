//! Drawings through the machines: curves are cut into strokes, the strokes run, and what the pulses drew is held against
//! the curves.
//!
//! ```text
//!   curves --Placement--> counts --cut--> Strokes --Runner--> pulses --Report, Drawn--> figures, pictures
//! ```
//!
//! A [`Sheet`] holds curves in counts; [`cut()`] makes of each one as few strokes of the machine as the tolerance allows; each
//! stroke begins at whole counts that the host knows beforehand, so that all of them can run at once.

mod cut;
mod measure;
mod picture;
mod place;
mod run;
mod smooth;

pub use cut::{Stroke, cut};
pub use measure::{Deviation, Report};
pub use picture::{Canvas, Look};
pub use place::{Placement, Sheet};
pub use run::{Done, How, draw};
