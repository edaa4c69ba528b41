//! FIG. 10 behind a converter and before a tool: claims 16 to 18 as wholes.

use super::machine::{Machine, Parameters, SMALL};
use super::velocity::velocity_table::peak_acceleration;

const CIRCUIT: &str = "us3809868/fig10_system";
/// Fraction bits of a slope.
const SLOPE: f64 = 262_144.0;

/// A case of the converter, with its data, and where the stroke ends.
type Given<'a> = (i64, &'a [(&'a str, i64)], [i64; 2]);

/// What the tool did: its place after each tick, and in which ticks it moved.
struct Moved {
    path: Vec<[i64; 2]>,
    steps: Vec<usize>,
}

/// Draws from (10, -20), and follows the windings of the motors by the drive table.
fn moved(parameters: Parameters, inputs: &[(&str, i64)], (case, data, end): Given) -> Moved {
    const DRIVE: [u64; 4] = [0b0011, 0b0110, 0b1100, 0b1001];
    let mut machine = Machine::shipped(CIRCUIT, &[SMALL, parameters].concat());
    let windings = ["windings_328a", "windings_328b"].map(|net| machine.find(net));
    let place = ["x_328c", "y_328c"].map(|net| machine.find(net));
    let (mark, done) = (machine.find("mark"), machine.find("done"));
    machine.set(&[("case_number", case), ("quarters", 1), ("x0", 10), ("y0", -20)]);
    machine.set(data);
    machine.set(inputs);
    machine.set(&[("start", 1)]);
    machine.tick();
    machine.set(&[("start", 0)]);
    while machine.word(mark) == 0 {
        machine.tick();
    }
    let step_of = |word: u64| DRIVE.iter().position(|pair| *pair == word).expect("two windings side by side") as i64;
    let mut moved = Moved { path: Vec::new(), steps: Vec::new() };
    let (mut shafts, mut before) = ([10, -20], windings.map(|net| step_of(machine.word(net))));
    while machine.word(done) == 0 {
        machine.tick();
        let now = windings.map(|net| step_of(machine.word(net)));
        for axis in 0..2 {
            let turned = (now[axis] - before[axis]).rem_euclid(4);
            assert_ne!(turned, 2, "never two steps at once");
            shafts[axis] += if turned == 3 { -1 } else { turned };
        }
        if now != before {
            moved.steps.push(moved.path.len());
        }
        before = now;
        assert_eq!(place.map(|net| machine.number(net)), shafts);
        moved.path.push(shafts);
    }
    assert_eq!((shafts, machine.get("error")), (end, 0), "case {case}, {parameters:?}");
    moved
}

fn slope(value: f64) -> i64 {
    (value * SLOPE) as i64
}

#[test]
fn the_tool_comes_to_the_last_point_of_every_case_in_every_mode() {
    let half = slope(0.5);
    let cases: [Given; 3] = [
        (1, &[("x1", 210), ("y1", 130), ("s0", slope(2.0)), ("s1", -half)], [210, 130]),
        (4, &[("x1", -290), ("y1", 80), ("x3", -90), ("y3", 80), ("s3", -half)], [-290, 80]),
        (5, &[("x1", 150), ("y1", -220), ("x2", 120), ("y2", -60)], [150, -220]),
    ];
    for case in cases {
        for mode in 0..=4 {
            let control = [("MODE", mode), ("WINDOW", 256), ("MAX_DELAY", 20), ("BLOCKS", 30), ("ENDS", 30)];
            moved(&control, &[("delay", 5), ("reference_340", 3)], case);
        }
    }
}

/// The stroke of the scenarios claim_16 to claim_18, moved to (10, -20).
const CASE_4: Given = (4, &[("x1", 310), ("y1", 80), ("x3", 110), ("y3", 80), ("s3", 131_072)], [310, 80]);

/// Claim 16 regulates the rate of elements: with the memory, pulses are far apart at the ends and close between.
#[test]
fn claim_16_the_memory_slows_the_tool_at_both_ends() {
    let steps = moved(&[("MODE", 3), ("RAMP", 8), ("BLOCKS", 38)], &[], CASE_4).steps;
    let ticks = |from: usize| steps[from + 20] - steps[from];
    let middle = ticks(steps.len() / 2);
    assert!(ticks(0) > 2 * middle && ticks(steps.len() - 21) > 2 * middle, "{} {middle}", ticks(0));
}

#[test]
fn claim_17_any_two_elements_are_the_interval_apart() {
    let steps = moved(&[("MODE", 4)], &[("delay", 9)], CASE_4).steps;
    assert!(steps.windows(2).all(|pair| pair[1] - pair[0] >= 9 + 2));
}

/// An independent meter of the tool's path: the loop keeps the greatest acceleration well below that of a free clock.
#[test]
fn claim_18_the_acceleration_of_the_tool_is_limited() {
    let free = peak_acceleration(&from_origin(moved(&[("MODE", 0)], &[], CASE_4).path));
    let looped = [("MODE", 2), ("WINDOW", 1000), ("MAX_DELAY", 120)];
    let limited = peak_acceleration(&from_origin(moved(&looped, &[("reference_340", 5)], CASE_4).path));
    assert!(limited < free / 4.0, "{limited} against {free}");
}

/// The meter takes the tool to be at rest at the origin before.
fn from_origin(path: Vec<[i64; 2]>) -> Vec<[i64; 2]> {
    path.into_iter().map(|[x, y]| [x - 10, y + 20]).collect()
}
