//! Bad input to FIG. 17: `error` until the next good start, and never a mark where none belongs.

use super::fig17_image::machine_with;
use super::machine::Machine;

/// A dash of 100 and a long one of 9000.
const DASHES: &str =
    "glyph 2D -\n move 0 0\n line 100 0\n advance 120\nglyph 5F _\n move 0 0\n line 9000 0\n advance 1";

/// What came of a character: the pen in each tick with a mark, where it ended, and the error.
struct Drawn {
    marks: Vec<[i64; 2]>,
    end: [i64; 2],
    error: u64,
}

fn pen(machine: &Machine) -> [i64; 2] {
    ["x", "y"].map(|name| machine.get_signed(name))
}

fn start(machine: &mut Machine, code: u8, from: [i64; 2], scale: i64) {
    machine.set(&[("code_449", code.into()), ("x0", from[0]), ("y0", from[1]), ("scale_514", scale), ("start", 1)]);
    machine.tick();
    machine.set(&[("start", 0)]);
}

fn finish(machine: &mut Machine) -> Drawn {
    let mut marks = Vec::new();
    while machine.get("done") == 0 {
        if machine.get("mark") == 1 {
            marks.push(pen(machine));
        }
        machine.tick();
    }
    marks.dedup();
    Drawn { marks, end: pen(machine), error: machine.get("error") }
}

fn draw(machine: &mut Machine, code: u8, from: [i64; 2], scale: i64) -> Drawn {
    start(machine, code, from, scale);
    finish(machine)
}

#[test]
fn a_wrong_character_marks_nothing_and_its_error_stays_until_the_next_good_start() {
    let mut machine = machine_with(DASHES);
    let cases = [
        ("a code without a character", b'A', [3, 4], 4096),
        ("a coefficient beyond the generator", b'_', [3, 4], 4096),
        ("a word beyond 16 bits", b'_', [3, 4], 32767),
    ];
    for (what, code, from, scale) in cases {
        let drawn = draw(&mut machine, code, from, scale);
        assert_eq!((drawn.marks.len(), drawn.end, drawn.error), (0, from, 1), "{what}");
        for _ in 0..5 {
            machine.tick();
            assert_eq!([machine.get("error"), machine.get("done"), machine.get("busy")], [1, 0, 0], "{what}");
        }
        let good = draw(&mut machine, b'-', [0, 0], 2048);
        assert_eq!((good.end, good.error, good.marks.len()), ([60, 0], 0, 51), "after {what}");
    }
}

#[test]
fn a_place_outside_of_the_coordinates_is_an_error_and_the_pen_stays() {
    let drawn = draw(&mut machine_with(DASHES), b'-', [32700, 9], 2048);
    assert_eq!(drawn.error, 0, "32760 is inside");
    let drawn = draw(&mut machine_with(DASHES), b'-', [32710, 9], 2048);
    assert_eq!((drawn.end, drawn.error), ([32760, 9], 1), "the dash ends inside, the next origin does not");
}

#[test]
fn a_stroke_that_runs_out_of_the_coordinates_loses_its_mark_there() {
    let drawn = draw(&mut machine_with(DASHES), b'-', [32700, 9], 4096);
    assert_eq!(drawn.error, 1);
    let along: Vec<_> = (32700..=32767).map(|x| [x, 9]).collect();
    assert_eq!(drawn.marks, along);
}

#[test]
fn a_start_while_busy_is_refused_with_an_error_and_the_character_goes_on_unharmed() {
    let mut machine = machine_with(DASHES);
    start(&mut machine, b'-', [10, 20], 4096);
    for _ in 0..1000 {
        machine.tick();
    }
    assert_eq!(machine.get("error"), 0);
    start(&mut machine, b'_', [-5, -5], 1);
    assert_eq!(machine.get("error"), 1);
    let drawn = finish(&mut machine);
    assert_eq!((drawn.end, drawn.error), ([130, 20], 1));
    assert_eq!(drawn.marks.last(), Some(&[110, 20]));
}

#[test]
fn what_the_inputs_do_after_the_start_does_not_matter() {
    let mut machine = machine_with(DASHES);
    start(&mut machine, b'-', [10, 20], 4096);
    machine.set(&[("code_449", 0), ("x0", 1), ("y0", 1), ("scale_514", 1)]);
    let drawn = finish(&mut machine);
    assert_eq!((drawn.end, drawn.error), ([130, 20], 0));
}
