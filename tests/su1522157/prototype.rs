//! The prototype against the equations of its reading: F0 = 0.5 {(X - Y) - Y}; a whole step while F >= 0, which takes Y from
//! F, otherwise a step of (1, 1), which adds X - Y; X steps in all.

use super::machine::{Machine, Step, letters};

/// The equations, in halves so that all is whole. `minus_zero`: the sign of an F that has come to zero is negative.
fn equations(major: i64, minor: i64, minus_zero: bool) -> String {
    let mut f = (major - minor) - minor;
    let mut steps = String::new();
    for _ in 0..major {
        let whole = if minus_zero { f > 0 } else { f >= 0 };
        steps.push(if whole { 'U' } else { 'D' });
        f += if whole { -2 * minor } else { 2 * (major - minor) };
    }
    steps
}

fn pairs(limit: i64) -> impl Iterator<Item = (i64, i64)> {
    (1..=limit).flat_map(|major| (0..=major).map(move |minor| (major, minor)))
}

#[test]
fn every_pair_up_to_48_follows_the_equations_with_either_axis_as_the_major_one_and_ends_on_the_point() {
    let mut machine = Machine::prototype(&[]);
    for (major, minor) in pairs(48) {
        for (x_is_major, whole) in [(true, Step::X), (false, Step::Y)] {
            let steps = machine.frame(major, minor, x_is_major);
            assert_eq!(letters(&steps), equations(major, minor, false), "({major}, {minor})");
            let combined = steps.iter().filter(|step| **step == Step::Both).count() as i64;
            let alone = steps.iter().filter(|step| **step == whole).count() as i64;
            assert_eq!((alone + combined, combined), (major, minor), "({major}, {minor})");
        }
    }
}

#[test]
fn no_node_deviates_more_than_half_a_step_times_the_cosine_with_either_zero() {
    for minus_zero in [0, 1] {
        let mut machine = Machine::prototype(&[("CLOCK_PERIOD", 3), ("MINUS_ZERO", minus_zero)]);
        for (major, minor) in pairs(48) {
            let (mut p, mut q) = (0, 0);
            for step in machine.frame(major, minor, true) {
                p += 1;
                q += i64::from(step == Step::Both);
                assert!(2 * (p * minor - q * major).abs() <= major, "({major}, {minor}) at ({p}, {q})");
            }
            assert_eq!((p, q), (major, minor));
        }
    }
}

#[test]
fn minus_zero_takes_tied_steps_in_the_other_order() {
    let mut machine = Machine::prototype(&[("MINUS_ZERO", 1)]);
    let tied: Vec<_> = pairs(24).filter(|&(major, minor)| minor > 0 && minor < major).collect();
    for &(major, minor) in &tied {
        let steps = letters(&machine.frame(major, minor, true));
        assert_eq!(steps, equations(major, minor, true), "({major}, {minor})");
    }
    assert!(tied.iter().any(|&(major, minor)| equations(major, minor, true) != equations(major, minor, false)));
}

#[test]
fn a_frame_of_no_length_emits_one_step_as_that_of_the_interpolator() {
    for (minus_zero, step) in [(0, Step::Y), (1, Step::Both)] {
        assert_eq!(Machine::prototype(&[("MINUS_ZERO", minus_zero)]).frame(0, 0, true), [step]);
    }
}

#[test]
fn the_shortest_clock_period_and_the_widest_word_change_no_step() {
    for parameters in [[("CLOCK_PERIOD", 3), ("TAP_SPACING", 1)], [("WIDTH", 48), ("DELAY_22", 4)]] {
        let mut machine = Machine::prototype(&parameters);
        for (major, minor) in pairs(12) {
            assert_eq!(letters(&machine.frame(major, minor, true)), equations(major, minor, false), "{parameters:?}");
        }
    }
}
