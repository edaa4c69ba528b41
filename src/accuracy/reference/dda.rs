//! Digital differential analysers: two integrators whose overflows are the steps.
//!
//! In each iteration each projection is added to its remainder, and a remainder that reaches the length 2^n of its register
//! overflows into a step and is reduced by it; 2^n iterations make the segment, and those without an overflow move
//! nothing. 2^n is the least power that is greater than the major projection.

use super::Step;

/// What the remainders are at the beginning.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Begin {
    /// Zero, which cuts the line down to whole steps: the reference-pulse DDA of Y. Koren, "Interpolator for a computer
    /// numerical control system", IEEE Transactions on Computers C-25 (1976).
    Empty,
    /// Half the length, which rounds the line to the nearest step: the symmetrical DDA of W. M. Newman and R. F. Sproull,
    /// "Principles of Interactive Computer Graphics" (1973).
    HalfFull,
}

/// The steps from (0, 0) to (major, minor).
pub(super) fn steps(major: u64, minor: u64, begin: Begin) -> impl Iterator<Item = Step> {
    let length = (major + 1).next_power_of_two();
    let remainder = if begin == Begin::HalfFull { length / 2 } else { 0 };
    let (mut x, mut y) = (remainder, remainder);
    let iterations = (0..length).map(move |_| (overflows(&mut x, major, length), overflows(&mut y, minor, length)));
    iterations.filter(|&step| step != (false, false))
}

fn overflows(remainder: &mut u64, projection: u64, length: u64) -> bool {
    *remainder += projection;
    let is_full = *remainder >= length;
    *remainder -= if is_full { length } else { 0 };
    is_full
}
