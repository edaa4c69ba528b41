//! Bresenham's line: J. E. Bresenham, "Algorithm for computer control of a digital plotter", IBM Systems Journal 4 (1965).

use super::Step;

/// The steps from (0, 0) to (major, minor): one along the major axis each time, and along the minor one, too, when that
/// is nearer to the segment. A node just between two goes up.
pub(super) fn steps(major: u64, minor: u64) -> impl Iterator<Item = Step> {
    let mut error = 2 * minor as i64 - major as i64;
    (0..major).map(move |_| {
        let across = error >= 0;
        error += 2 * minor as i64 - if across { 2 * major as i64 } else { 0 };
        (true, across)
    })
}
