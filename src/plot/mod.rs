//! Plots: numbers as pictures, with axes, units, a title, and the command that made them.
//!
//! The layout is that of the crate `plotters`, whose SVG back end writes the text; nothing of it is seen outside.

mod chart;
mod heat;

pub use chart::{Chart, Series, Style};
pub use heat::HeatMap;

use plotters::prelude::*;

use crate::picture::Svg;

/// Width and height of a plot, in pixels.
const SIZE: (u32, u32) = (800, 600);
const FONT: &str = "DejaVu Sans";

/// An axis.
#[derive(Clone, PartialEq, Debug)]
pub struct Axis {
    /// What it shows, with its unit.
    pub name: String,
    /// Its least and its greatest number.
    pub range: [f64; 2],
}

impl Axis {
    /// The axis of some numbers, with a little room at either end.
    #[must_use]
    pub fn of(name: impl Into<String>, numbers: impl IntoIterator<Item = f64>) -> Self {
        let (least, most) =
            numbers.into_iter().fold((f64::MAX, f64::MIN), |(a, b), number| (a.min(number), b.max(number)));
        let room = if most > least { (most - least) * 0.04 } else { 0.5 };
        let range = if least > most { [0.0, 1.0] } else { [least - room, most + room] };
        Self { name: name.into(), range }
    }
}

/// A number at an axis, without the digits that come of its being binary.
fn label(number: &f64) -> String {
    ((number * 1e6).round() / 1e6).to_string()
}

/// A plot that `draw` draws below its title, on a white sheet with `command` at its foot.
fn sheet(title: &str, command: &str, draw: impl FnOnce(&DrawingArea<SVGBackend<'_>, plotters::coord::Shift>)) -> Svg {
    let mut text = String::new();
    {
        let area = SVGBackend::with_string(&mut text, SIZE).into_drawing_area();
        // A back end that writes into a string does not fail; what it draws beyond the sheet is cut.
        let _ = area.fill(&WHITE);
        let (above, foot) = area.split_vertically(SIZE.1 - 24);
        let _ = foot.draw_text(command, &(FONT, 12).into_text_style(&foot).color(&BLACK.mix(0.6)), (12, 2));
        if let Ok(below) = above.titled(title, (FONT, 20)) {
            draw(&below);
        }
        let _ = area.present();
    }
    Svg::new(text)
}
