//! How far the drawn nodes are from the segment: the law of figure 5.

use proptest::prelude::*;

use super::machine::{Machine, Step, end_of};

/// Asserts that each node of a path with X as the major axis deviates from the segment by at most
/// 0.5 (0.25 sin a + 0.75 cos a) of a step, where tan a = minor / major.
///
/// With sin a = Y / L and cos a = X / L the length L drops out: for a node in quarter steps (p, q),
/// |p Y - q X| / 4 <= 0.5 (0.25 Y + 0.75 X), in whole numbers.
pub fn assert_within_the_bound(steps: &[Step], major: i64, minor: i64) {
    for drawn in 1..=steps.len() {
        let (p, q) = end_of_first(steps, drawn);
        assert!(2 * (p * minor - q * major).abs() <= minor + 3 * major, "({major}, {minor}), node {drawn}");
    }
}

fn end_of_first(steps: &[Step], count: usize) -> (i64, i64) {
    let (whole, combined) = steps[..count].iter().fold((0, 0), |(whole, combined), step| match step {
        Step::Both => (whole, combined + 1),
        Step::X | Step::Y => (whole + 1, combined),
    });
    (4 * whole + 3 * combined, 3 * combined)
}

fn pair(limit: i64) -> impl Strategy<Value = (i64, i64)> {
    (1..=limit).prop_flat_map(|major| (Just(major), 0..=major))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 40, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn no_drawn_node_deviates_more_than_the_patents_bound_and_the_end_misses_by_a_quarter_at_most(
        (major, minor) in pair(700),
        minus_zero in 0i64..=1,
    ) {
        let mut machine = Machine::new(&[("CLOCK_PERIOD", 3), ("MINUS_ZERO", minus_zero)]);
        let steps = machine.frame(major, minor, true);
        assert_within_the_bound(&steps, major, minor);
        let (x, y) = end_of(&steps);
        prop_assert!((x - 4 * major).abs() <= 1 && (y - 4 * minor).abs() <= 1, "ends at ({x}, {y}) quarters");
    }
}

#[test]
fn the_steepest_deviation_is_that_of_127_43() {
    let steps = Machine::new(&[]).frame(127, 43, true);
    let length = f64::hypot(127.0, 43.0);
    let deviation = |drawn| {
        let (p, q) = end_of_first(&steps, drawn);
        (p * 43 - q * 127).abs() as f64 / 4.0 / length
    };
    let worst = (1..=steps.len()).map(deviation).fold(0.0, f64::max);
    assert!((worst - 0.39528).abs() < 5e-6, "{worst}");
}

#[test]
fn the_shortest_diagonal_ends_a_quarter_of_a_step_short_on_both_axes() {
    assert_eq!(end_of(&Machine::new(&[]).frame(1, 1, true)), (3, 3));
}
