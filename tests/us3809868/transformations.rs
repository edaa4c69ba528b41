//! What FIG. 12, 14 and 20 have in common: starts and errors.

use super::transform::Transformer;

/// The circuits with a start, set up so that J = 30000 and L = -30000 give a J' beyond its word.
const STARTED: [(&str, &[(&str, i64)]); 3] = [
    ("fig12_rotation", &[("angle_410", 0x2000)]),
    ("fig14_scaling", &[("factor_471", 2 << 12)]),
    ("fig20_rotation3d", &[("order_616", 3), ("angle_636", 0x2000)]),
];

/// Each of them, with these settings.
fn started() -> impl Iterator<Item = Transformer> {
    STARTED.into_iter().map(|(name, settings)| {
        let mut circuit = Transformer::shipped(name, &["j_out", "k_out", "l_out", "m_out"], &[]);
        circuit.machine.set(settings);
        circuit
    })
}

#[test]
fn an_error_stays_until_the_next_start_which_is_free_of_it() {
    for mut circuit in started() {
        assert_eq!(circuit.run(&[("j", 30_000), ("l", -30_000)]), None);
        for _ in 0..50 {
            circuit.machine.tick();
            assert_eq!((circuit.result(), circuit.machine.get("done")), (None, 1));
        }
        circuit.start(&[("j", 100), ("l", -100)]);
        assert_eq!(circuit.machine.get("error"), 0);
        assert!(circuit.finish().is_some());
    }
}

#[test]
fn inputs_count_in_the_tick_of_the_start_and_a_start_while_busy_is_ignored() {
    for mut circuit in started() {
        let expected = circuit.run(&[("j", 100), ("l", -100)]);
        circuit.start(&[("j", 100), ("l", -100)]);
        circuit.machine.tick();
        circuit.start(&[("j", 7), ("l", 9)]);
        assert_eq!(circuit.finish(), expected);
    }
}
