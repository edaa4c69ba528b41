//! What stands in adder, registers and counter after each pulse of the schedule, and table 1 row by row.

use super::machine::{Machine, Step};

/// Adder 1, register 2, register 3 and counter 14, in eighths of a step.
type Contents = [i64; 4];

fn contents(machine: &Machine) -> Contents {
    ["f_1", "register_2.contents", "register_3.contents", "r_14"].map(|name| machine.read(name))
}

/// The schedule of the patent's description: contents after pulses 33 and 23 to 30.
fn schedule(x: i64, y: i64) -> [(u32, Contents); 9] {
    let d = x - y;
    [
        (33, [x, x, y, 8 * x]),
        (23, [d, 0, y, 8 * x - 1]),
        (24, [d, d, 2 * y, 8 * x - 3]),
        (25, [d, 2 * d, 4 * y, 8 * x - 3]),
        (26, [3 * d, 2 * d, 4 * y, 8 * x - 3]),
        (27, [3 * d, 0, 4 * y, 8 * x - 3]),
        (28, [3 * d, 3 * d, 4 * y, 8 * x - 3]),
        (29, [3 * d - 4 * y, 6 * d, 4 * y, 8 * x - 3]),
        (30, [3 * d - 4 * y, 6 * d, 8 * y, 8 * x - 3]),
    ]
}

#[test]
fn the_contents_after_each_pulse_are_those_of_the_schedule() {
    for spacing in [2, 3, 8] {
        for (x, y) in [(8, 3), (7, 3), (1, 0), (1, 1), (5, 5), (127, 43), (4095, 0), (4095, 1365), (4095, 4095)] {
            let mut machine = Machine::new(&[("TAP_SPACING", spacing)]);
            machine.start(x, y, true);
            for (pulse, expected) in schedule(x, y) {
                assert_eq!(contents(&machine), expected, "({x}, {y}) after pulse {pulse}, spacing {spacing}");
                assert_eq!((machine.read("trigger_4.q"), machine.read("trigger_5.q")), (0, 1));
                (0..spacing).for_each(|_| machine.tick());
            }
            assert_eq!(machine.read("trigger_4.q"), 1, "tap 31 begins the stepping");
        }
    }
}

#[test]
fn table_1_comes_out_row_by_row() {
    // Output, F after, R after, in thousandths, as the corrected table prints them.
    let table = [
        (Step::X, -2625, 6625),
        (Step::Both, 1125, 5875),
        (Step::X, -1875, 4875),
        (Step::Both, 1875, 4125),
        (Step::X, -1125, 3125),
        (Step::Both, 2625, 2375),
        (Step::X, -375, 1375),
        (Step::Both, 3375, 625),
        (Step::X, 375, -375),
    ];
    let mut machine = Machine::new(&[]);
    machine.start(8, 3, true);
    let (mut f, mut r) = (375, 7625);
    for (output, f_after, r_after) in table {
        while machine.step().is_none() {
            machine.tick();
        }
        let thousandths = |name| machine.read(name) * 125;
        assert_eq!((machine.step(), thousandths("f_1"), thousandths("r_14")), (Some(output), f, r));
        (f, r) = (f_after, r_after);
        machine.tick();
    }
    // The overflow shows the last row for one tick before it clears the adder.
    assert_eq!((machine.read("f_1") * 125, machine.read("r_14") * 125), (f, r));
    assert_eq!(machine.read("overflow_14"), 1);
}
