//! Bad input to FIG. 9: never a wrong curve without a sign.

use super::machine::{Machine, SMALL, Stroke, draw, shipped_session};

const CIRCUIT: &str = "us3809868/fig09_function_generator";

const GOOD: Stroke = Stroke { jklm: [100, -50, 25, 511], from: [3, 4], quarters: 1 };

/// Starts, and looks at the tick after: error, done, busy.
fn start(machine: &mut Machine, stroke: &Stroke) -> [u64; 3] {
    machine.set(&stroke.inputs());
    machine.tick();
    machine.set(&[("start", 0)]);
    ["error", "done", "busy"].map(|output| machine.get(output))
}

#[test]
fn a_coefficient_beyond_the_multipliers_is_refused_and_nothing_moves() {
    for (parameters, most) in [(&[][..], 4095), (SMALL, 511), (&[("GUARD", 3)][..], 511)] {
        let mut machine = Machine::shipped(CIRCUIT, parameters);
        for place in 0..4 {
            for wrong in [-most - 1, most + 1, 32767, -32768] {
                let mut stroke = Stroke { jklm: [1, 2, 3, 4], from: [77, 88], quarters: 1 };
                stroke.jklm[place] = wrong;
                assert_eq!(start(&mut machine, &stroke), [1, 1, 0], "{stroke:?}");
                assert_eq!([machine.get_signed("x"), machine.get_signed("y")], [0, 0]);
                machine.tick();
                assert_eq!(machine.get("done"), 0, "done is a pulse");
                assert_eq!(machine.get("error"), 1, "error stays");
            }
        }
    }
}

#[test]
fn no_quarter_and_more_than_four_are_refused() {
    let mut machine = Machine::shipped(CIRCUIT, SMALL);
    for quarters in [0, 5, 6, 7] {
        assert_eq!(start(&mut machine, &Stroke { quarters, ..GOOD }), [1, 1, 0]);
    }
}

#[test]
fn an_accepted_start_clears_the_error() {
    let mut machine = Machine::shipped(CIRCUIT, SMALL);
    assert_eq!(start(&mut machine, &Stroke { quarters: 0, ..GOOD }), [1, 1, 0]);
    let drawn = draw(&mut machine, &GOOD);
    assert_eq!((drawn.end, drawn.error), (GOOD.end(), false));
}

#[test]
fn a_start_while_busy_is_refused_with_a_sign_and_the_stroke_goes_on_unharmed() {
    for second in [Stroke::new([5; 4], 2), Stroke { quarters: 0, ..GOOD }, Stroke::new([-512; 4], 1)] {
        let mut machine = Machine::shipped(CIRCUIT, SMALL);
        assert_eq!(start(&mut machine, &GOOD), [0, 0, 1]);
        (0..100).for_each(|_| machine.tick());
        assert_eq!(start(&mut machine, &second), [1, 0, 1]);
        let mut rest = 0;
        while machine.get("busy") == 1 {
            machine.tick();
            rest += 1;
        }
        assert_eq!(rest, 2 * 2048 - 101);
        assert_eq!([machine.get_signed("x"), machine.get_signed("y")], GOOD.end());
        assert_eq!((machine.get("done"), machine.get("error")), (1, 1));
    }
}

#[test]
fn a_counter_carried_beyond_its_word_is_reported() {
    for (from, jklm, beyond) in [
        ([32700, 0], [0, 511, 0, 0], true),
        ([0, -32700], [0, 0, 0, -511], true),
        ([32767 - 511, 0], [0, 511, 0, 0], false),
        ([-32768 + 511, 0], [0, -511, 0, 0], false),
    ] {
        let stroke = Stroke { jklm, from, quarters: 1 };
        let drawn = draw(&mut Machine::shipped(CIRCUIT, SMALL), &stroke);
        assert_eq!(drawn.error, beyond, "{stroke:?}");
        assert_eq!(drawn.end == stroke.end(), !beyond);
    }
}

#[test]
fn pulses_never_coincide_in_the_interleavers() {
    let nets = ["generator_16.coincident_290", "generator_16.coincident_292"];
    let mut machine = Machine::new(&shipped_session(CIRCUIT, SMALL, &nets));
    start(&mut machine, &Stroke::new([511; 4], 4));
    while machine.get("busy") == 1 {
        assert_eq!(nets.map(|net| machine.get(net)), [0, 0]);
        machine.tick();
    }
}
