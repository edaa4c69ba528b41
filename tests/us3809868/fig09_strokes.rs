//! Strokes of FIG. 9, pulse for pulse: the end is exact, and every pulse is where the reading has it.

use std::fmt::Write as _;

use sha2::{Digest, Sha256};

use super::machine::{Drawn, Machine, Parameters, Pulse, Random, SMALL, Stroke, draw};
use super::vectors::{list, number, numbers, read};

const CIRCUIT: &str = "us3809868/fig09_function_generator";

fn drawn(parameters: Parameters, stroke: &Stroke) -> Drawn {
    draw(&mut Machine::shipped(CIRCUIT, parameters), stroke)
}

fn four(value: &serde_json::Value) -> [i64; 4] {
    numbers(value).try_into().expect("J, K, L, M")
}

/// `clock,half,axis,+-1`, joined by semicolons, hashed.
fn hash(pulses: &[Pulse]) -> String {
    let mut text = String::new();
    for (i, Pulse { at, axis, way }) in pulses.iter().enumerate() {
        let separator = if i == 0 { "" } else { ";" };
        let axis = ["X", "Y"][*axis];
        write!(text, "{separator}{},{},{axis},{way:+}", at / 2, at % 2).expect("a string takes all");
    }
    Sha256::digest(text.as_bytes()).iter().fold(String::new(), |hex, byte| hex + &format!("{byte:02x}"))
}

#[test]
fn twelve_bit_strokes_end_exactly_and_their_pulses_have_the_hash_of_the_reading() {
    let vectors = read("brm_ends_n12.json");
    let mut machine = Machine::shipped(CIRCUIT, &[]);
    for vector in list(&vectors["strokes"]) {
        let stroke = Stroke::new(four(&vector["JKLM"]), 1);
        let drawn = draw(&mut machine, &stroke);
        assert_eq!(drawn.end.as_slice(), numbers(&vector["end"]), "{stroke:?}");
        assert_eq!(drawn.end, stroke.end());
        assert_eq!(drawn.pulses.len() as i64, number(&vector["n_events"]), "{stroke:?}");
        assert_eq!(hash(&drawn.pulses), vector["sha256"].as_str().expect("a hash"), "{stroke:?}");
        assert_eq!((drawn.path.len(), drawn.error), (16384, false));
    }
}

#[test]
fn small_strokes_have_every_pulse_of_the_reading() {
    let vectors = read("brm_traces_small.json");
    for vector in list(&vectors["strokes"]) {
        let size = |name| number(&vector[name]);
        let parameters = [("WIDTH", size("n")), ("ENTRIES", size("N")), ("ENTRY_WIDTH", size("w"))];
        let stroke = Stroke { jklm: four(&vector["JKLM"]), from: [size("X0"), size("Y0")], quarters: size("quarters") };
        let drawn = drawn(&parameters, &stroke);
        assert_eq!(drawn.end.as_slice(), numbers(&vector["end"]));
        let expected: Vec<Pulse> = list(&vector["events"])
            .iter()
            .map(|event| Pulse {
                at: (2 * number(&event[0]) + number(&event[1])) as u64,
                axis: usize::from(event[2] == "Y"),
                way: number(&event[3]),
            })
            .collect();
        assert_eq!(drawn.pulses, expected);
    }
}

#[test]
fn one_to_four_quarters_end_where_the_equations_say_with_every_sign_and_at_both_extremes() {
    let mut machine = Machine::shipped(CIRCUIT, &[]);
    for quarters in 1..=4 {
        for jklm in [[4095; 4], [-4095; 4], [4095, -4095, -4095, 4095], [-1, 4095, 0, -4095], [0; 4]] {
            let stroke = Stroke { jklm, from: [-70, 55], quarters };
            let drawn = draw(&mut machine, &stroke);
            assert_eq!((drawn.end, drawn.error), (stroke.end(), false), "{stroke:?}");
            assert_eq!(drawn.path.len() as i64, 16384 * quarters);
        }
    }
}

#[test]
fn all_sixteen_combinations_of_signs_end_exactly_after_each_quarter() {
    let mut machine = Machine::shipped(CIRCUIT, SMALL);
    for signs in 0..16 {
        let sign = |bit: i64| if signs >> bit & 1 == 1 { -1 } else { 1 };
        let jklm = [300 * sign(0), 171 * sign(1), 255 * sign(2), 511 * sign(3)];
        for quarters in 1..=4 {
            let stroke = Stroke { jklm, from: [10, -20], quarters };
            assert_eq!(draw(&mut machine, &stroke).end, stroke.end(), "{stroke:?}");
        }
    }
}

#[test]
fn random_strokes_end_exactly_in_every_model_that_the_theorem_covers() {
    let models: &[(Parameters, i64, usize)] = &[
        (SMALL, 511, 300),
        (&[("WIDTH", 10), ("ENTRIES", 32), ("ENTRY_WIDTH", 6)], 1023, 40),
        (&[("WIDTH", 12), ("ENTRIES", 32), ("ENTRY_WIDTH", 8)], 4095, 6),
        (&[("WIDTH", 9), ("ENTRIES", 32), ("ENTRY_WIDTH", 6)], 511, 20),
        (&[("GUARD", 1)], 2047, 4),
        (&[("GUARD", 3)], 511, 4),
        (&[("WIDTH", 12), ("ENTRIES", 1024), ("ENTRY_WIDTH", 3)], 4095, 4),
    ];
    let mut random = Random(1971);
    for (parameters, most, count) in models {
        let mut machine = Machine::shipped(CIRCUIT, parameters);
        for _ in 0..*count {
            let stroke = random.stroke(*most);
            let drawn = draw(&mut machine, &stroke);
            assert_eq!((drawn.end, drawn.error), (stroke.end(), false), "{parameters:?} {stroke:?}");
        }
    }
}

#[test]
fn inputs_that_change_during_a_stroke_do_not_change_it() {
    let stroke = Stroke { jklm: [-312, -72, 314, 508], from: [20, -30], quarters: 1 };
    let mut machine = Machine::shipped(CIRCUIT, SMALL);
    machine.set(&stroke.inputs());
    machine.tick();
    machine.set(&[("start", 0), ("j", 1), ("k", -2), ("l", 3), ("m", -4), ("x0", 9), ("y0", 9), ("quarters", 4)]);
    while machine.get("busy") == 1 {
        machine.tick();
    }
    assert_eq!([machine.get_signed("x"), machine.get_signed("y")], stroke.end());
}

#[test]
fn a_chain_of_strokes_ends_where_the_last_one_does() {
    let mut machine = Machine::shipped(CIRCUIT, SMALL);
    let mut random = Random(7);
    let mut from = [0, 0];
    for _ in 0..12 {
        let stroke = Stroke { from, ..random.stroke(511) };
        from = draw(&mut machine, &stroke).end;
        assert_eq!(from, stroke.end());
    }
}
