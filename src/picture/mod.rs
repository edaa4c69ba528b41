//! Pictures: everything drawn is SVG first, and PNG is made from that very SVG.
//!
//! A [`Picture`] is a sheet with a title, axes in a stated unit, layers of paths and dots, a legend, and the command that
//! made it. What another library composes, such as a plot, becomes an [`Svg`], too, and goes out the same way. Text is
//! set in the font that the program carries, so that a picture looks the same on every machine.

mod font;
mod layer;
mod scale;
mod sheet;
mod svg;

pub use font::{FONT, fonts};
pub use kurbo;
pub use layer::{Layer, Shape};
pub use sheet::Picture;
pub use svg::Svg;
