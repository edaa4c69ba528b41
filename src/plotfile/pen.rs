//! A pen that lines and arcs are drawn with, for formats that move one.

use kurbo::{Arc, BezPath, Point, Vec2};

use super::{FARTHEST, Reading};

/// An arc's curves are within one part in so many of its radius.
const FINE: f64 = 1e6;

/// A pen at a place, in millimetres, with the curve under way.
pub(super) struct Pen {
    pub at: Point,
    curve: BezPath,
}

impl Pen {
    pub fn new() -> Self {
        Self { at: Point::ZERO, curve: BezPath::new() }
    }

    /// Draws a line; none where the pen stays.
    pub fn line(&mut self, reading: &mut Reading, to: Point, at: std::ops::Range<usize>) {
        if to != self.at && self.may_go(reading, to, 1, at) {
            self.curve.line_to(to);
        }
        self.at = to;
    }

    /// Draws an arc about a centre, by an angle in radians, counter-clockwise when it is more than 0. Its pieces are
    /// quarters, as machines draw them; the last one ends in `to`.
    pub fn arc(&mut self, reading: &mut Reading, centre: Point, angle: f64, to: Point, at: std::ops::Range<usize>) {
        let radius = self.at - centre;
        let quarters = (angle.abs() / std::f64::consts::FRAC_PI_2 - 1e-9).ceil().max(1.0);
        if !self.may_go(reading, centre + radius * 2.0, quarters as usize, at) {
            self.at = to;
            return;
        }
        let full = quarters as usize - 1;
        for i in 0..=full {
            let start = radius.atan2() + std::f64::consts::FRAC_PI_2.copysign(angle) * i as f64;
            let sweep = if i < full {
                std::f64::consts::FRAC_PI_2.copysign(angle)
            } else {
                angle - std::f64::consts::FRAC_PI_2.copysign(angle) * full as f64
            };
            let arc = Arc::new(centre, Vec2::splat(radius.hypot()), start, sweep, 0.0);
            arc.to_cubic_beziers(radius.hypot() / FINE, |first, second, end| self.curve.curve_to(first, second, end));
        }
        // Where the file's numbers are rounded, the end is what it says.
        if let Some(kurbo::PathEl::CurveTo(.., end)) = self.curve.elements_mut().last_mut() {
            *end = to;
        }
        self.at = to;
    }

    /// Puts the pen up, and down again at another place when it draws next.
    pub fn lift(&mut self, reading: &mut Reading, to: Point) {
        let curve = std::mem::take(&mut self.curve);
        if curve.segments().next().is_some() {
            reading.plot.curves.push(curve);
        }
        self.at = to;
    }

    fn may_go(&mut self, reading: &mut Reading, to: Point, pieces: usize, at: std::ops::Range<usize>) -> bool {
        if ![to.x, to.y].iter().all(|side| side.abs() <= FARTHEST) {
            reading.wrong("F004", at, "this lies farther away than any drawing", "");
            return false;
        }
        if self.curve.is_empty() {
            self.curve.move_to(self.at);
        }
        reading.count(pieces, at)
    }
}
