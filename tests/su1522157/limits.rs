//! What a cycle-accurate model shows and the patent does not say: times, races, frames of no length, rest.

use super::machine::{Machine, Step, letters};
use super::oracle;

fn small_pairs(limit: i64) -> impl Iterator<Item = (i64, i64)> {
    (1..=limit).flat_map(|major| (0..=major).map(move |minor| (major, minor)))
}

fn assert_follows_the_equations(parameters: &[(&str, i64)], limit: i64) {
    let mut machine = Machine::new(parameters);
    for (major, minor) in small_pairs(limit) {
        let steps = letters(&machine.frame(major, minor, true));
        assert_eq!(steps, oracle::letters(major, minor), "({major}, {minor}) with {parameters:?}");
    }
}

#[test]
fn clock_period_tap_spacing_and_word_length_change_no_step() {
    for clock_period in [3, 4, 5, 16] {
        for tap_spacing in [1, 2, 3, 9] {
            assert_follows_the_equations(&[("CLOCK_PERIOD", clock_period), ("TAP_SPACING", tap_spacing)], 8);
        }
    }
    for width in [4, 8, 32, 48] {
        assert_follows_the_equations(&[("WIDTH", width)], 15);
    }
}

#[test]
fn delay_22_from_1_to_4_ticks_changes_no_step() {
    for delay in 1..=4 {
        assert_follows_the_equations(&[("DELAY_22", delay)], 16);
        let race = &[("DELAY_13", 3), ("DELAY_22", delay)];
        assert_eq!(frames_with_a_step_too_many(race, 16), frames_with_a_step_too_many(&[("DELAY_13", 3)], 16));
    }
}

/// How many frames come out with just one step more than the equations allow; any other difference is a failure.
fn frames_with_a_step_too_many(parameters: &[(&str, i64)], limit: i64) -> usize {
    let mut machine = Machine::new(parameters);
    let too_long = small_pairs(limit).filter(|&(major, minor)| {
        let steps = letters(&machine.frame(major, minor, true));
        let right = oracle::letters(major, minor);
        assert_eq!(steps[..right.len()], right, "({major}, {minor}) with {parameters:?}");
        assert!(steps.len() <= right.len() + 1, "({major}, {minor}) with {parameters:?}");
        steps.len() > right.len()
    });
    too_long.count()
}

#[test]
fn a_delay_13_that_is_over_before_the_next_strobe_does_no_harm() {
    for (delay, clock_period) in [(1, 3), (2, 4), (6, 8)] {
        assert_follows_the_equations(&[("DELAY_13", delay), ("CLOCK_PERIOD", clock_period)], 12);
    }
}

#[test]
fn a_delay_13_of_3_with_period_4_makes_84_of_the_560_frames_up_to_32_one_step_too_long() {
    assert_eq!(small_pairs(32).count(), 560);
    assert_eq!(frames_with_a_step_too_many(&[("DELAY_13", 3)], 32), 84);
    let steps = Machine::new(&[("DELAY_13", 3)]).frame(1, 1, true);
    assert_eq!(steps, [Step::Both, Step::Both], "(1, 1) gets two steps");
}

#[test]
fn a_frame_of_no_length_emits_one_step() {
    // F is zero: a whole step where the sign of zero is 0, a combined one where minus zero looks negative. Trigger 5
    // has been cleared before tap 31, so the whole step comes out on 37 whichever axis is the major one.
    for (minus_zero, step) in [(0, Step::Y), (1, Step::Both)] {
        for x_is_major in [false, true] {
            let steps = Machine::new(&[("MINUS_ZERO", minus_zero)]).frame(0, 0, x_is_major);
            assert_eq!(steps, [step], "MINUS_ZERO = {minus_zero}");
        }
    }
}

#[test]
fn busy_rises_in_the_tick_after_the_start_pulse_and_nothing_stirs_after_it_falls() {
    let mut machine = Machine::new(&[]);
    for _ in 0..3 {
        assert!(!machine.busy());
        let (_, ticks) = machine.timed_frame(8, 3, true);
        assert!(ticks > 9 * 2, "the distributor alone takes that long");
        for _ in 0..40 {
            assert!(!machine.busy() && machine.step().is_none());
            assert_eq!(machine.read("r_14"), 0);
            machine.tick();
        }
    }
}

#[test]
fn the_phase_of_the_free_running_generator_changes_no_step() {
    let mut machine = Machine::new(&[]);
    for wait in 0..8 {
        (0..wait).for_each(|_| machine.tick());
        assert_eq!(letters(&machine.frame(8, 3, true)), "UDUDUDUDU");
    }
}
