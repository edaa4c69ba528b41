//! FIG. 10: the path is the same in every mode of control, and pulses keep their distance.

use super::machine::{Machine, Random, SMALL, Stroke, draw};
use super::velocity::velocity_table::peak_acceleration;

const CIRCUIT: &str = "us3809868/fig10_tool_control";

/// The trailing edge of a pulse: its tick, counted from the first one after the start, its axis and its way.
type Edge = (u64, usize, i64);

struct Run {
    ticks: u64,
    edges: Vec<Edge>,
    /// X and Y after each tick.
    path: Vec<[i64; 2]>,
    end: [i64; 2],
}

fn run(parameters: &[(&str, i64)], stroke: &Stroke, inputs: &[(&str, i64)]) -> Run {
    let mut machine = Machine::shipped(CIRCUIT, parameters);
    let counts = ["x", "y"].map(|counter| machine.find(counter));
    let busy = machine.find("busy");
    machine.set(inputs);
    machine.set(&stroke.inputs());
    machine.tick();
    machine.set(&[("start", 0)]);
    let mut run = Run { ticks: 0, edges: Vec::new(), path: Vec::new(), end: stroke.from };
    while machine.word(busy) == 1 {
        machine.tick();
        run.ticks += 1;
        let now = counts.map(|counter| machine.number(counter));
        for (axis, (now, before)) in now.into_iter().zip(run.end).enumerate() {
            let way = now - before;
            assert!(way.abs() <= 1);
            if way != 0 {
                run.edges.push((run.ticks, axis, way));
            }
        }
        run.end = now;
        run.path.push(now);
    }
    assert_eq!(machine.get("error"), 0);
    run
}

/// The stroke of the reading's comparison: 10 bits, tables of 32 words of 6 bits, halves of 2 ticks, 1300 pulses.
const COMPARED: Stroke = Stroke { jklm: [-900, 0, 0, 400], from: [0, 0], quarters: 1 };

fn compared(mode: i64, more: &[(&str, i64)], inputs: &[(&str, i64)]) -> Run {
    let model = [("WIDTH", 10), ("ENTRIES", 32), ("ENTRY_WIDTH", 6), ("HALF", 2), ("MODE", mode)];
    run(&[&model[..], more].concat(), &COMPARED, inputs)
}

#[test]
fn constant_delays_take_the_ticks_of_the_reading() {
    assert_eq!(compared(0, &[], &[]).ticks, 8192);
    for (delay, ticks) in [(12, 14338), (24, 25754), (40, 41528), (60, 61248)] {
        assert_eq!(compared(1, &[], &[("delay", delay)]).ticks, ticks, "delay {delay}");
    }
    for (half, ticks) in [(6, 24576), (10, 40960)] {
        assert_eq!(compared(0, &[("HALF", half)], &[]).ticks, ticks, "half {half}");
    }
}

/// The reading's loop measures with windows of time, 338 here with integrators: it takes as long, and shakes as much.
#[test]
fn the_acceleration_loop_is_as_good_as_that_of_the_reading() {
    for (window, ticks, peak) in [(1000, 77498, 23.9), (2000, 96220, 14.8)] {
        let run = compared(2, &[("WINDOW", window)], &[("reference_340", 5)]);
        let (ratio, measured) = (run.ticks as f64 / f64::from(ticks), peak_acceleration(&run.path));
        assert!((ratio - 1.0).abs() < 0.015, "{} ticks every {window}", run.ticks);
        assert!((measured / peak - 1.0).abs() < 0.015, "peak {measured} every {window}");
    }
}

/// A pulse counts in 346 before the delay after it is looked up.
#[test]
fn the_memory_takes_the_ticks_of_the_reading() {
    for (middle, ramp, ticks) in [(20, 16, 28835), (12, 24, 21330)] {
        let trapezoid = [("ENDS", 120), ("MIDDLE", middle), ("RAMP", ramp), ("BLOCKS", 82)];
        assert_eq!(compared(3, &trapezoid, &[]).ticks, ticks, "ramp {ramp}");
    }
}

#[test]
fn at_about_the_same_peak_acceleration_memory_beats_constant_delay_beats_the_loop() {
    let memory = compared(3, &[("MIDDLE", 20), ("RAMP", 16)], &[]);
    let constant = compared(1, &[], &[("delay", 40)]);
    let regulated = compared(2, &[("WINDOW", 1000)], &[("reference_340", 5)]);
    // Peaks of the reading's own meter, which looks less often.
    for (run, peak) in [(&memory, 25.2), (&constant, 27.1), (&regulated, 24.1)] {
        let measured = peak_acceleration(&run.path);
        assert!((measured - peak).abs() < 0.2, "{measured} instead of {peak}");
    }
    assert!(memory.ticks < constant.ticks && constant.ticks < regulated.ticks);
    let uncontrolled = peak_acceleration(&compared(0, &[], &[]).path);
    assert!((uncontrolled - 190.9).abs() < 0.5, "{uncontrolled}");
}

#[test]
fn the_path_is_the_same_pulse_for_pulse_in_every_mode() {
    let mut random = Random(10);
    for _ in 0..3 {
        let stroke = random.stroke(511);
        let plain = draw(&mut Machine::shipped("us3809868/fig09_function_generator", SMALL), &stroke);
        let pulses: Vec<_> = plain.pulses.iter().map(|pulse| (pulse.axis, pulse.way)).collect();
        for mode in 0..=4 {
            let parameters = [SMALL, &[("MODE", mode), ("WINDOW", 300), ("MAX_DELAY", 30)]].concat();
            let controlled = run(&parameters, &stroke, &[("delay", 9), ("reference_340", 4)]);
            let edges: Vec<_> = controlled.edges.iter().map(|(_, axis, way)| (*axis, *way)).collect();
            assert_eq!(edges, pulses, "mode {mode}, {stroke:?}");
            assert_eq!(controlled.end, stroke.end());
            // Pulses of one tick of the generator stay together.
            let together = |ticks: Vec<u64>| ticks.windows(2).map(|pair| pair[0] == pair[1]).collect::<Vec<_>>();
            let at = together(plain.pulses.iter().map(|pulse| pulse.at).collect());
            assert_eq!(together(controlled.edges.iter().map(|edge| edge.0).collect()), at);
        }
    }
}

/// The least number of ticks between two trailing edges on one axis.
fn least_spacing(run: &Run) -> u64 {
    let spacings = [0, 1].map(|axis| {
        let ticks: Vec<_> = run.edges.iter().filter(|edge| edge.1 == axis).map(|edge| edge.0).collect();
        ticks.windows(2).map(|pair| pair[1] - pair[0]).min().expect("two pulses")
    });
    spacings[0].min(spacings[1])
}

#[test]
fn two_trailing_edges_on_one_axis_are_never_closer_than_delay_and_half_a_clock() {
    for (delay, half) in [(12, 2), (40, 2), (9, 4), (7, 3), (1, 2)] {
        let parameters = [SMALL, &[("MODE", 1), ("HALF", half)]].concat();
        let stroke = Stroke::new([-400, 511, 300, 511], 2);
        let spacing = least_spacing(&run(&parameters, &stroke, &[("delay", delay)]));
        assert!(spacing >= (delay + half) as u64, "{spacing} with delay {delay} and half {half}");
        if delay > 2 * half {
            assert_eq!(spacing, (delay + half) as u64, "dense strokes reach the limit");
        }
    }
}

#[test]
fn claim_17_inhibits_the_clock_after_each_pulse() {
    let run = run(&[SMALL, &[("MODE", 4)]].concat(), &Stroke::new([-400, 511, 300, 511], 1), &[("delay", 9)]);
    let mut ticks: Vec<_> = run.edges.iter().map(|edge| edge.0).collect();
    ticks.dedup();
    let halves_with_pulses = ticks.len() as u64;
    assert!(ticks.windows(2).all(|pair| pair[1] - pair[0] >= 9 + 2), "any two pulses keep the distance");
    assert_eq!(run.ticks, 2 * 2048 + 9 * halves_with_pulses, "each pulse costs its delay");
}

/// Guard stages keep elements back from the lines, but the multipliers give them all the same.
#[test]
fn claim_17_inhibits_the_clock_after_each_element_that_guard_stages_keep_back() {
    let stroke = Stroke::new([-100, 127, 75, 120], 1);
    let elements = Stroke { jklm: stroke.jklm.map(|c| 4 * c), ..stroke };
    let plain = draw(&mut Machine::shipped("us3809868/fig09_function_generator", SMALL), &elements);
    let mut halves: Vec<_> = plain.pulses.iter().map(|pulse| pulse.at).collect();
    halves.dedup();
    let run = run(&[SMALL, &[("MODE", 4), ("GUARD", 2)]].concat(), &stroke, &[("delay", 9)]);
    assert_eq!(run.end, stroke.end());
    assert_eq!(run.ticks, 2 * 2048 + 9 * halves.len() as u64);
}

/// The reading's sample: delay 9, half 2; tick, half, pulse on Y, hold, ticks of delay left after the tick, Y. The
/// reading's pulses last to the end of their half; here they are off in its last tick (`.`).
#[test]
fn hold_and_delay_work_tick_by_tick_as_in_the_reading() {
    let parameters = [("WIDTH", 10), ("ENTRIES", 32), ("ENTRY_WIDTH", 6), ("MODE", 1)];
    let nets = ["y_pulse", "delay_342.remaining", "generator_16.phase_a", "generator_16.phase_b"];
    let mut machine = Machine::new(&super::machine::shipped_session(CIRCUIT, &parameters, &nets));
    machine.set(&[("delay", 9)]);
    machine.set(&COMPARED.inputs());
    machine.tick();
    machine.set(&[("start", 0)]);
    let rows = [
        (5, 'A', 1, 0, 0, 0),
        (6, '.', 0, 0, 0, 0),
        (7, 'B', 0, 0, 8, 1),
        (17, 'A', 1, 0, 0, 1),
        (19, 'B', 0, 0, 8, 2),
        (25, 'A', 1, 1, 2, 2),
        (26, 'A', 1, 1, 1, 2),
        (27, 'A', 1, 1, 0, 2),
        (28, 'A', 1, 0, 0, 2),
        (29, '.', 0, 0, 0, 2),
        (30, 'B', 0, 0, 8, 3),
    ];
    let mut tick = 1;
    for row in rows {
        while tick < row.0 {
            machine.tick();
            tick += 1;
        }
        let half = match ["generator_16.phase_a", "generator_16.phase_b"].map(|phase| machine.get(phase)) {
            [0, 0] => '.',
            [1, 0] => 'A',
            _ => 'B',
        };
        let left = machine.get("delay_342.remaining").saturating_sub(1);
        let seen = (tick, half, machine.get("y_pulse"), machine.get("hold_345"), left, machine.get_signed("y"));
        assert_eq!(seen, row);
    }
}

#[test]
fn the_memory_slows_both_ends_and_what_is_preset_takes_effect() {
    let trapezoid = compared(3, &[], &[]);
    assert_eq!(trapezoid.end, COMPARED.end());
    let constant = |word: i64| compared(3, &[("ENDS", word), ("MIDDLE", word)], &[]).ticks;
    assert_eq!(constant(24), compared(1, &[], &[("delay", 24)]).ticks, "all words alike are a constant delay");
    assert!(trapezoid.ticks > constant(20) && trapezoid.ticks < constant(120));
    // A write during the stroke to a word that comes later stretches it.
    let preset = [("preset_write", 1), ("preset_address", 40), ("preset_word", 250)];
    assert!(compared(3, &[], &preset).ticks > trapezoid.ticks);
}
