//! Pulses on lines 304, 306, 314, 316: every count has edges of its own, whatever holds the clock.

use std::io::BufReader;
use std::path::Path;

use stepwright::golden::read_golden;
use stepwright::simulation::shipped;

use super::machine::{Machine, Parameters, Random, SMALL, Stroke, shipped_session};

const LINES: [&str; 4] = ["up_304", "down_306", "up_314", "down_316"];

/// The edges on the four lines, and the counts of X and Y, by line, over a stroke.
#[derive(Default, Debug, PartialEq)]
struct Edges {
    rising: [i64; 4],
    trailing: [i64; 4],
    counts: [i64; 4],
}

/// Draws, with `hold` at each tick where the circuit has that input.
fn draw(machine: &mut Machine, stroke: &Stroke, mut hold: impl FnMut() -> Option<i64>) -> Edges {
    let lines = LINES.map(|line| machine.find(line));
    let (counters, busy) = (["x", "y"].map(|counter| machine.find(counter)), machine.find("busy"));
    machine.set(&stroke.inputs());
    machine.tick();
    machine.set(&[("start", 0)]);
    let mut edges = Edges::default();
    let (mut levels, mut position) = ([0; 4], stroke.from);
    while machine.word(busy) == 1 {
        if let Some(hold) = hold() {
            machine.set(&[("hold", hold)]);
        }
        let now = lines.map(|line| machine.word(line));
        for line in 0..4 {
            edges.rising[line] += i64::from((levels[line], now[line]) == (0, 1));
            edges.trailing[line] += i64::from((levels[line], now[line]) == (1, 0));
        }
        levels = now;
        machine.tick();
        let after = counters.map(|counter| machine.number(counter));
        for axis in 0..2 {
            match after[axis] - position[axis] {
                0 => {}
                1 => edges.counts[2 * axis] += 1,
                -1 => edges.counts[2 * axis + 1] += 1,
                far => panic!("{far} counts at once"),
            }
        }
        position = after;
    }
    assert_eq!((position, machine.get("error")), (stroke.end(), 0), "{stroke:?}");
    edges
}

fn all(counts: [i64; 4]) -> Edges {
    Edges { rising: counts, trailing: counts, counts }
}

#[test]
fn random_strokes_held_at_random_have_an_edge_for_every_count() {
    let mut random = Random(304);
    for half in [2, 3, 5] {
        let parameters = [SMALL, &[("HALF", half)]].concat();
        let mut machine = Machine::shipped("us3809868/incremental_generator", &parameters);
        for often in [0, 3, 30, 80] {
            let (stroke, mut holds) = (random.stroke(511), Random(random.word()));
            let edges = draw(&mut machine, &stroke, || Some(i64::from(holds.word() % 100 < often)));
            assert_eq!(edges, all(stroke.counts()), "half {half}, held {often} % of the time, {stroke:?}");
        }
    }
}

#[test]
fn strokes_of_every_mode_of_control_have_an_edge_for_every_count() {
    let mut random = Random(316);
    for mode in 0..=4 {
        for (half, guard) in [(2, 0), (3, 0), (2, 1), (3, 3)] {
            let control = [("MODE", mode), ("HALF", half), ("GUARD", guard), ("MAX_DELAY", 30), ("WINDOW", 300)];
            let mut machine = Machine::shipped("us3809868/fig10_tool_control", &[SMALL, &control].concat());
            for delay in [0, 1, 2, 7] {
                machine.set(&[("delay", delay), ("reference_340", 4)]);
                let stroke = random.stroke(511 >> guard);
                let edges = draw(&mut machine, &stroke, || None);
                assert_eq!(edges, all(edges.counts), "{control:?}, delay {delay}, {stroke:?}");
                if guard == 0 {
                    assert_eq!(edges.counts, stroke.counts());
                }
            }
        }
    }
}

/// The case that showed pulses melting into one another: 700 counts of X.
#[test]
fn a_sine_pulse_and_the_cosine_pulse_behind_it_do_not_touch() {
    let stroke = Stroke::new([-400, 300, -200, 350], 1);
    let edges = draw(&mut Machine::shipped("us3809868/fig09_function_generator", &[]), &stroke, || None);
    assert_eq!(edges, all([700, 0, 550, 0]));
}

#[test]
fn delays_341_and_342_begin_with_the_trailing_edge_on_their_lines() {
    let nets = ["x_pulse", "y_pulse", "busy_341", "busy_342"];
    let parameters: Parameters = &[("WIDTH", 9), ("ENTRIES", 32), ("ENTRY_WIDTH", 5), ("MODE", 1)];
    let mut machine = Machine::new(&shipped_session("us3809868/fig10_tool_control", parameters, &nets));
    machine.set(&[("delay", 5)]);
    machine.set(&Stroke::new([-400, 511, 300, -200], 1).inputs());
    machine.tick();
    machine.set(&[("start", 0)]);
    // Ticks since the trailing edge of each axis: busy in the five after that of the edge.
    let (mut before, mut since) = ([0; 2], [100; 2]);
    let mut seen = 0;
    while machine.get("busy") == 1 {
        for axis in 0..2 {
            let pulse = machine.get(nets[axis]);
            since[axis] = if (before[axis], pulse) == (1, 0) { 0 } else { since[axis] + 1 };
            before[axis] = pulse;
            assert_eq!(machine.get(nets[axis + 2]) == 1, (1..=5).contains(&since[axis]), "axis {axis}");
            seen += usize::from(since[axis] == 0);
        }
        machine.tick();
    }
    assert_eq!(seen, 911 + 500);
}

#[test]
fn golden_traces_have_an_edge_for_every_count() {
    let mut judged = 0;
    for scenario in shipped::names("toml") {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("traces/{scenario}.vcd"));
        let file = std::fs::File::open(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        let wave = read_golden(&path.to_string_lossy(), BufReader::new(file));
        let wave = wave.unwrap_or_else(|report| panic!("{report}"));
        for (axis, lines) in [("x", ["up_304", "down_306"]), ("y", ["up_314", "down_316"])] {
            let Some(position) = named(&wave, axis) else { continue };
            let Some(lines) = lines.map(|line| named(&wave, line)).into_iter().collect::<Option<Vec<_>>>() else {
                continue;
            };
            let levels = wave.span();
            let rises = |line: &stepwright::golden::Track| {
                let high = |tick: u64| line.at(tick).and_then(|value| value.word()) == Some(1);
                levels.clone().filter(|tick| high(*tick) && (*tick == levels.start || !high(tick - 1))).count()
            };
            let steps = levels.clone().skip(1).filter(|tick| is_step(position, *tick)).count();
            assert_eq!(rises(lines[0]) + rises(lines[1]), steps, "{scenario}, {axis}");
            judged += usize::from(steps > 0);
        }
    }
    assert!(judged > 30, "{judged} axes of golden traces move");
}

fn named<'a>(wave: &'a stepwright::golden::Waveform, net: &str) -> Option<&'a stepwright::golden::Track> {
    let top = wave.top()?;
    wave.track(&format!("{top}.{net}")).or_else(|| wave.track(net))
}

/// Whether a 16-bit count has moved by one; a preset jumps.
fn is_step(position: &stepwright::golden::Track, tick: u64) -> bool {
    let word = |tick| position.at(tick).and_then(|value| value.word()).unwrap_or(0);
    let moved = word(tick).wrapping_sub(word(tick - 1)) as u16;
    moved == 1 || moved == u16::MAX
}
