//! Reference algorithms: interpolators of straight segments that are known from books, as programs.

mod bresenham;
mod dda;

use rayon::prelude::*;

use super::{Claim, Frame, Segments, Tally, count};
use crate::scenario::Law;

/// An algorithm by its name.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Reference {
    /// Bresenham's line: the node nearest to the segment on each column.
    Bresenham,
    /// The symmetrical DDA: two integrators of 2^n words that begin half full.
    SymmetricalDda,
    /// Koren's reference-pulse DDA: the same two integrators, empty at the beginning, as CNC programs have them.
    KorenDda,
}

/// A step: whether it goes along the major axis, and along the minor one.
type Step = (bool, bool);

/// How many segments are one piece of work.
const PIECE: u64 = 1 << 12;

impl Reference {
    /// All there are.
    pub const ALL: [Self; 3] = [Self::Bresenham, Self::SymmetricalDda, Self::KorenDda];

    /// Its name on the command line.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Bresenham => "reference/bresenham",
            Self::SymmetricalDda => "reference/symmetrical_dda",
            Self::KorenDda => "reference/koren_dda",
        }
    }

    /// How far its nodes can be from the segment, by the error of each coordinate: half a step across for Bresenham, half a
    /// step either way for the symmetrical DDA. The other DDA is less than a whole step late on both axes, and what it
    /// is late on one counts against what it is late on the other.
    fn law(self) -> Law {
        match self {
            Self::Bresenham => Law { sin: 0.0, cos: 0.5 },
            Self::SymmetricalDda => Law { sin: 0.5, cos: 0.5 },
            Self::KorenDda => Law { sin: 0.0, cos: 1.0 },
        }
    }

    /// What it is held against: its law, and an end that is met.
    #[must_use]
    pub fn claim(self) -> Claim {
        Claim { law: self.law(), printed: None, end: 0.0 }
    }

    /// Its steps from (0, 0) to (major, minor).
    fn frame(self, major: u64, minor: u64) -> Frame {
        match self {
            Self::Bresenham => judge(major, minor, bresenham::steps(major, minor)),
            Self::SymmetricalDda => judge(major, minor, dda::steps(major, minor, dda::Begin::HalfFull)),
            Self::KorenDda => judge(major, minor, dda::steps(major, minor, dda::Begin::Empty)),
        }
    }

    /// The tally of all segments up to `max`, on all cores.
    ///
    /// # Panics
    /// When there are more than 2^64 segments.
    #[must_use]
    pub fn tally(self, max: u64) -> Tally {
        let all = count(max).expect("a number of segments");
        let claim = self.claim();
        let piece = |piece: u64| {
            let mut tally = Tally::default();
            for (major, minor) in Segments::from(max, piece * PIECE).take(PIECE as usize) {
                tally.add(self.frame(major, minor), &claim);
            }
            tally
        };
        let merge = |mut a: Tally, b: Tally| {
            a.merge(b);
            a
        };
        (0..all.div_ceil(PIECE)).into_par_iter().map(piece).reduce(Tally::default, merge)
    }
}

/// Follows steps and keeps what a deviation meter keeps.
fn judge(major: u64, minor: u64, steps: impl Iterator<Item = Step>) -> Frame {
    let (mut p, mut q) = (0_i64, 0_i64);
    let mut frame = Frame { major, minor, ..Frame::default() };
    let (mut last, mut run) = (None, 0);
    for step in steps {
        p += 4 * i64::from(step.0);
        q += 4 * i64::from(step.1);
        let off = p * minor as i64 - q * major as i64;
        frame.greatest = frame.greatest.max(off.unsigned_abs());
        run = if last == Some(step) { run + 1 } else { 1 };
        last = Some(step);
        frame.longest_run = frame.longest_run.max(run);
        frame.steps += 1;
    }
    (frame.left_major, frame.left_minor) = (4 * major as i64 - p, 4 * minor as i64 - q);
    frame
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Where Bresenham's line is on each column: round(i minor / major), halves either way.
    #[test]
    fn bresenham_is_on_each_column_at_the_nearest_node() {
        for (major, minor) in Segments::from(40, 1) {
            let mut q = 0;
            for (i, (along, across)) in (1..).zip(bresenham::steps(major, minor)) {
                assert!(along);
                q += u64::from(across);
                let off = (q * major).abs_diff(i * minor);
                assert!(2 * off <= major, "({major}, {minor}) column {i}");
            }
            assert_eq!((q, bresenham::steps(major, minor).count() as u64), (minor, major));
        }
    }

    /// The nodes of the DDAs are those of rounding i X / 2^n and i Y / 2^n, to the nearest or downward.
    #[test]
    fn the_ddas_are_the_rounded_line_iteration_by_iteration() {
        for (major, minor) in Segments::from(40, 1) {
            let n = (1..).find(|&n| 1_u64 << n > major).expect("a length");
            for (begin, offset) in [(dda::Begin::HalfFull, 0.5), (dda::Begin::Empty, 0.0)] {
                let at =
                    |i: u64, projection: u64| (i as f64 * projection as f64 / 2_f64.powi(n) + offset).floor() as u64;
                let nodes: Vec<_> = (0..=1_u64 << n).map(|i| (at(i, major), at(i, minor))).collect();
                let expected: Vec<Step> = nodes
                    .windows(2)
                    .map(|pair| (pair[1].0 > pair[0].0, pair[1].1 > pair[0].1))
                    .filter(|&step| step != (false, false))
                    .collect();
                assert_eq!(dda::steps(major, minor, begin).collect::<Vec<_>>(), expected, "({major}, {minor})");
            }
        }
    }

    #[test]
    fn each_keeps_its_law_ends_on_the_point_and_the_laws_are_nearly_reached() {
        for (reference, reached) in Reference::ALL.into_iter().zip([0.48, 0.6, 0.9]) {
            let tally = reference.tally(100);
            assert_eq!((tally.segments, tally.violations, tally.astray), (5151, 0, 0), "{reference:?}");
            assert!(tally.end.end_error() == 0.0 && tally.max_deviation() > reached, "{reference:?}: {tally:?}");
        }
    }
}
