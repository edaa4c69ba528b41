//! What the computer tells its operator.

use std::fmt;
use std::ops::RangeInclusive;

/// Why data give no stroke.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Refusal {
    /// A slope that is given, or carried on from a section with J = 0, is infinite or no number. A vertical tangent has
    /// no slope, as in the patent; a quarter turn (FIG. 13) of all points makes it a horizontal one.
    Vertical,
    /// Cases II and III: E is not between 0 and 1, both excluded. The curve would need a point of inflection.
    Inflection {
        /// E, which may be no number.
        e: f64,
    },
    /// Case I: the slopes at both ends are equal, so that their tangents do not meet.
    EqualSlopes,
    /// Case IV: G is not above 0. P0 and P1 are on opposite sides of the tangent at P3, or one of them is on it.
    Tangent {
        /// G, which may be no number.
        g: f64,
    },
    /// A word beyond what its register, or the generator, can hold.
    TooLarge {
        /// Which: `J`, `X1`, ...
        word: &'static str,
        /// Its value in counts, which may be no number.
        value: f64,
        /// The least that would be right.
        low: f64,
        /// The most that would be right.
        high: f64,
    },
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Vertical => write!(f, "a vertical tangent has no slope"),
            Self::Inflection { e } => write!(f, "E = {e:.4} is not between 0 and 1"),
            Self::EqualSlopes => write!(f, "the slopes at both ends are equal"),
            Self::Tangent { g } => write!(f, "G = {g:.4} is not above 0"),
            Self::TooLarge { word, value, low, high } => write!(f, "{word} = {value} is not from {low} to {high}"),
        }
    }
}

/// What happened in a chain. Points are numbered as they arrived, cancelled ones included; P0 is point 1.
#[derive(Clone, PartialEq, Debug)]
pub enum Note {
    /// Operation 610: the last two points, or the last one of case I, do not count; others are needed.
    Cancelled {
        /// Their numbers.
        points: RangeInclusive<usize>,
        /// Why.
        refusal: Refusal,
    },
    /// The stroke from this point on goes back against the direction in which the one before has arrived: the slopes
    /// are equal, the directions opposite. Test 586 does not see it.
    Cusp {
        /// Its number.
        point: usize,
    },
    /// The stroke from this point on leaves in another direction than the one before has arrived in. Only chains that
    /// carry the slope as the patent prints it have corners.
    Corner {
        /// Its number.
        point: usize,
        /// How far the direction turns, 0 to 180.
        degrees: f64,
    },
}

impl fmt::Display for Note {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Cancelled { points, refusal } => {
                let (first, last) = (points.start(), points.end());
                let what = if first == last { format!("point {last}") } else { format!("points {first} and {last}") };
                write!(f, "{what} cancelled: {refusal}")
            }
            Self::Cusp { point } => write!(f, "cusp at point {point}"),
            Self::Corner { point, degrees } => write!(f, "corner of {degrees:.1} degrees at point {point}"),
        }
    }
}
