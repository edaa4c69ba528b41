//! The pen of FIG. 11 tick by tick: clipping, characters, errors.

use super::machine::{Machine, SMALL};

/// Case IV from (0, 0) to (300, 100); J to M are -200, 100, 100, 200.
const CASE_4: [(&str, i64); 8] = [
    ("case_364", 4),
    ("quarters", 1),
    ("x1", 300),
    ("y1", 100),
    ("x3", 100),
    ("y3", 100),
    ("s3", 131_072),
    ("factor_471", 4096),
];

/// The letter t, a tenth of its enlarged scale, at (20, 10).
const LETTER: [(&str, i64); 5] =
    [("case_364", 6), ("code_449", b't' as i64), ("x0", 20), ("y0", 10), ("scale_514", 410)];

const LINES: [&str; 4] = ["up_304", "down_306", "up_314", "down_316"];

/// What becomes of a point, seen from the initial one.
type Map = fn([i64; 2]) -> [i64; 2];

/// What was seen from a start to `done`.
#[derive(Debug, PartialEq)]
struct Seen {
    /// Point and mark of each tick in which the generator is at work.
    drawn: Vec<([i64; 2], bool)>,
    /// The line of each pulse, in order.
    pulses: Vec<usize>,
    end: [i64; 2],
    error: bool,
}

fn system() -> Machine {
    let nets = ["busy_370"];
    Machine::new(&super::machine::shipped_session("us3809868/fig11_system", SMALL, &nets))
}

fn begin(machine: &mut Machine, inputs: &[(&str, i64)]) {
    machine.set(inputs);
    machine.set(&[("start", 1)]);
    machine.tick();
    machine.set(&[("start", 0)]);
}

fn finish(machine: &mut Machine) -> Seen {
    let lines = LINES.map(|line| machine.find(line));
    let [x, y, mark, at_work, done] = ["x", "y", "mark", "busy_370", "done"].map(|net| machine.find(net));
    let (mut drawn, mut pulses, mut before) = (Vec::new(), Vec::new(), [0; 4]);
    for _ in 0..1_000_000 {
        let point = [x, y].map(|net| machine.number(net));
        if machine.word(at_work) == 1 {
            drawn.push((point, machine.word(mark) == 1));
        } else {
            assert_eq!(machine.word(mark), 0, "a mark at rest");
        }
        let now = lines.map(|line| machine.word(line));
        pulses.extend((0..4).filter(|&line| (before[line], now[line]) == (0, 1)));
        before = now;
        if machine.word(done) == 1 {
            return Seen { drawn, pulses, end: point, error: machine.get("error") == 1 };
        }
        machine.tick();
    }
    panic!("done does not come");
}

fn draw(machine: &mut Machine, inputs: &[&[(&str, i64)]]) -> Seen {
    begin(machine, &inputs.concat());
    finish(machine)
}

#[test]
fn behind_the_window_the_clock_is_four_times_as_fast_and_every_pulse_is_the_same() {
    let window = [("x_min_390", 40), ("x_max_392", 250), ("y_min_394", -10), ("y_max_396", 115)];
    let inside = |[x, y]: [i64; 2]| (40..=250).contains(&x) && (-10..=115).contains(&y);
    let free = draw(&mut system(), &[&CASE_4, &window]);
    let clipped = draw(&mut system(), &[&CASE_4, &window, &[("control_388", 1)]]);
    assert_eq!((free.end, free.error, clipped.end, clipped.error), ([300, 100], false, [300, 100], false));
    assert_eq!(clipped.pulses, free.pulses);
    assert!(free.drawn.iter().all(|(_, mark)| *mark));
    assert!(clipped.drawn.iter().all(|(point, mark)| *mark == inside(*point)));
    let ticks = |seen: &Seen, wanted| seen.drawn.iter().filter(|(point, _)| inside(*point) == wanted).count();
    assert_eq!(ticks(&clipped, true), ticks(&free, true));
    let (before, now) = (ticks(&free, false), ticks(&clipped, false));
    assert!(before > 4000 && now.abs_diff(before / 4) <= 2, "{before}, {now}");
}

#[test]
fn a_character_is_turned_and_mirrored_as_a_whole_with_its_moves() {
    let straight = draw(&mut system(), &[&LETTER]);
    assert_eq!((straight.end, straight.error), ([79, 10], false));
    assert!(straight.drawn.iter().all(|(_, mark)| *mark));
    let maps: [(&[(&str, i64)], Map); 6] = [
        (&[("control_382", 3), ("control_464", 1)], |point| point),
        (&[("control_382", 1), ("control_450", 1)], |[x, y]| [-y, x]),
        (&[("control_382", 2), ("control_456", 1)], |[x, y]| [-x, y]),
        (&[("control_382", 3), ("control_454", 1), ("control_462", 1)], |[x, y]| [x, -y]),
        (&[("control_382", 4), ("angle_410", 0x4000)], |[x, y]| [-y, x]),
        (&[("control_382", 16), ("offset_x_488", 900), ("offset_y_490", -7)], |[x, y]| [x + 900, y - 7]),
    ];
    for (controls, map) in maps {
        let seen = draw(&mut system(), &[&LETTER, controls]);
        let mapped = |[x, y]: [i64; 2]| {
            let [right, up] = map([x - 20, y - 10]);
            [right + 20, up + 10]
        };
        let expected: Vec<_> = straight.drawn.iter().map(|(point, mark)| (mapped(*point), *mark)).collect();
        assert!(seen.drawn == expected, "{controls:?}");
        assert_eq!((seen.end, seen.error), (mapped([79, 10]), false), "{controls:?}");
    }
}

#[test]
fn what_makes_no_sense_is_an_error_until_the_next_start_and_draws_nothing() {
    let bad: [&[(&str, i64)]; 15] = [
        &[("case_364", 0)],
        &[("case_364", 7)],
        &[("case_364", 4), ("s3", 0), ("y3", 0), ("y1", 0)],
        &[("quarters", 0)],
        &[("quarters", 5)],
        &[("control_382", 1)],
        &[("control_382", 1), ("control_450", 1), ("control_454", 1)],
        &[("control_382", 1), ("control_456", 1)],
        &[("control_382", 2), ("control_450", 1)],
        &[("control_382", 2), ("control_458", 1), ("control_464", 1)],
        &[("control_382", 8), ("factor_471", 3 * 4096)],
        &[("control_382", 16), ("offset_x_488", -32768), ("x0", -1)],
        &[("control_388", 1), ("x_min_390", 5), ("x_max_392", 4)],
        &[("control_388", 1), ("y_min_394", -4), ("y_max_396", -5)],
        &[("case_364", 6), ("code_449", 0)],
    ];
    for inputs in bad {
        let mut machine = system();
        assert_eq!(draw(&mut machine, &[&CASE_4]).end, [300, 100]);
        let seen = draw(&mut machine, &[inputs]);
        assert_eq!((seen.error, seen.drawn.len(), seen.pulses.len()), (true, 0, 0), "{inputs:?}");
        for _ in 0..20 {
            machine.tick();
            assert_eq!(["error", "busy", "mark"].map(|net| machine.get(net)), [1, 0, 0], "{inputs:?}");
        }
        let zeros: Vec<_> = inputs.iter().map(|(name, _)| (*name, 0)).collect();
        let good = draw(&mut machine, &[&zeros, &CASE_4]);
        assert_eq!((good.end, good.error), ([300, 100], false), "after {inputs:?}");
    }
}

#[test]
fn a_stroke_that_leaves_the_coordinates_loses_its_mark_there_and_ends_with_an_error() {
    let beyond = [("x0", 32600), ("x1", 32767), ("x3", 32700), ("control_382", 8), ("factor_471", 8192)];
    let seen = draw(&mut system(), &[&CASE_4, &beyond]);
    assert!(seen.error);
    let (marked, blank) = seen.drawn.split_at(seen.drawn.partition_point(|(_, mark)| *mark));
    assert!(marked.iter().all(|(point, _)| point[0] >= 32600) && !blank.is_empty());
    assert!(blank.iter().all(|(_, mark)| !mark));
}

#[test]
fn inputs_count_in_the_tick_of_the_start_and_a_start_while_busy_is_ignored() {
    let switched = [("control_382", 31), ("control_450", 1), ("control_456", 1), ("control_388", 1)];
    let window = [("x_min_390", -100), ("x_max_392", 50), ("y_min_394", -200), ("y_max_396", 900)];
    let places = [("angle_410", 777), ("offset_x_488", 9)];
    let given = [&switched[..], &window, &places].concat();
    for what in [&CASE_4[..], &LETTER] {
        let expected = draw(&mut system(), &[&CASE_4, what, &given]);
        assert!(!expected.error);
        let mut machine = system();
        begin(&mut machine, &[&CASE_4, what, &given].concat());
        for (name, _) in CASE_4.iter().chain(&LETTER).chain(&given) {
            machine.set(&[(name, 0)]);
        }
        machine.tick();
        machine.set(&[("start", 1)]);
        machine.tick();
        machine.set(&[("start", 0)]);
        assert_eq!(finish(&mut machine), expected);
    }
}
