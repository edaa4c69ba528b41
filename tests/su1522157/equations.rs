//! Every small pair in both orientations, against equations (1) to (3).

use super::machine::{Machine, Step, letters};
use super::oracle;

/// All pairs 0 <= minor <= major <= limit but (0, 0).
fn pairs(limit: i64) -> impl Iterator<Item = (i64, i64)> {
    (1..=limit).flat_map(|major| (0..=major).map(move |minor| (major, minor)))
}

#[test]
fn every_pair_up_to_64_follows_the_equations_with_either_axis_as_the_major_one() {
    let mut machine = Machine::new(&[]);
    for (major, minor) in pairs(64) {
        let rows = oracle::rows(major, minor);
        for (x_is_major, whole) in [(true, Step::X), (false, Step::Y)] {
            let steps = machine.frame(major, minor, x_is_major);
            let expected: Vec<_> = rows.iter().map(|row| if row.combined { Step::Both } else { whole }).collect();
            assert_eq!(steps, expected, "({major}, {minor}), X major: {x_is_major}");
        }
    }
}

#[test]
fn f_and_r_hold_the_equations_values_at_every_step() {
    let mut machine = Machine::new(&[]);
    for (major, minor) in pairs(16) {
        machine.start(major, minor, true);
        let (mut f, mut r) = (oracle::first_f(major, minor), oracle::first_r(major));
        for row in oracle::rows(major, minor) {
            while machine.step().is_none() {
                machine.tick();
            }
            assert_eq!((machine.read("f_1"), machine.read("r_14")), (f, r), "before a step of ({major}, {minor})");
            (f, r) = (row.f, row.r);
            machine.tick();
        }
        while machine.busy() {
            machine.tick();
        }
    }
}

#[test]
fn minus_zero_changes_682_of_the_8384_pairs_up_to_128_and_neither_their_bound_nor_their_end() {
    let mut plus = Machine::new(&[("CLOCK_PERIOD", 3)]);
    let mut minus = Machine::new(&[("CLOCK_PERIOD", 3), ("MINUS_ZERO", 1)]);
    let (mut all, mut changed) = (0, 0);
    for (major, minor) in pairs(128) {
        let expected = oracle::letters(major, minor);
        let [plus, minus] = [&mut plus, &mut minus].map(|machine| machine.frame(major, minor, true));
        assert_eq!(letters(&plus), expected, "({major}, {minor})");
        all += 1;
        changed += i32::from(minus != plus);
        super::accuracy::assert_within_the_bound(&minus, major, minor);
        assert_eq!(super::machine::end_of(&minus), super::machine::end_of(&plus), "({major}, {minor})");
    }
    assert_eq!((all, changed), (8384, 682));
}
