//! What is measured of one segment.

use std::f64::consts::FRAC_PI_4;

/// One segment and what became of it. Lengths are in quarters of a whole step, so that they are whole numbers.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Frame {
    /// The greater projection, in whole steps.
    pub major: u64,
    /// The lesser projection, in whole steps.
    pub minor: u64,
    /// Greatest |p minor - q major| of the nodes (p, q): the deviation times the segment's length.
    pub greatest: u64,
    /// What is left to go at the end along the major axis.
    pub left_major: i64,
    /// The same along the minor axis.
    pub left_minor: i64,
    /// Steps, of whatever kind.
    pub steps: u64,
    /// Most equal steps in a row.
    pub longest_run: u64,
}

impl Frame {
    /// How long the segment is, in whole steps.
    #[must_use]
    pub fn length(&self) -> f64 {
        (self.major as f64).hypot(self.minor as f64)
    }

    /// The segment's angle with the major axis, in radians, 0 to pi/4; 0 for a segment of no length.
    #[must_use]
    pub fn angle(&self) -> f64 {
        (self.minor as f64).atan2(self.major as f64).min(FRAC_PI_4)
    }

    /// The greatest distance of a node from the segment's line, in whole steps; 0 for a segment of no length, which has no
    /// line.
    #[must_use]
    pub fn deviation(&self) -> f64 {
        if self.major == 0 { 0.0 } else { self.greatest as f64 / 4.0 / self.length() }
    }

    /// How far the path ends from the segment's end, along the axis where that is more, in whole steps.
    #[must_use]
    pub fn end_error(&self) -> f64 {
        self.left_major.unsigned_abs().max(self.left_minor.unsigned_abs()) as f64 / 4.0
    }

    /// The mean feed: how far the path has come for each step, from its start to its end, in whole steps; 0 without
    /// a step.
    #[must_use]
    pub fn feed(&self) -> f64 {
        let gone = |projection: u64, left: i64| projection as f64 - left as f64 / 4.0;
        if self.steps == 0 {
            return 0.0;
        }
        gone(self.major, self.left_major).hypot(gone(self.minor, self.left_minor)) / self.steps as f64
    }
}
