//! What FIG. 12 to 15 and 20 have in common: numerals, starts, errors.

use super::machine::shipped_session;
use super::transform::Transformer;

/// Every numeral of the figures; those of FIG. 20 are in two circuits.
const NUMERALS: [(&str, &[u32]); 6] = [
    ("fig12_rotation", &[410, 412, 414, 416, 418, 420, 422, 424, 426, 428, 430, 432, 434, 436, 438]),
    ("fig13_quarter_turns", &[440, 442, 444, 446, 448, 450, 452, 454, 456, 458, 460, 462, 464]),
    ("fig14_scaling", &[470, 471, 472, 474, 476]),
    ("fig15_offset", &[480, 486, 488, 490]),
    ("fig20_rotation3d", &[612, 614, 616, 618, 620, 622, 624, 626, 628, 630, 632, 634, 636, 638]),
    ("fig20_display", &[640, 642]),
];

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
fn every_numeral_is_an_instance_or_a_net_of_its_circuit() {
    for (name, numerals) in NUMERALS {
        let design = shipped_session(&format!("us3809868/{name}"), &[], &[]).elaborate();
        let design = design.unwrap_or_else(|report| panic!("{report}"));
        let netlist = design.netlist();
        let top = netlist.nets.first().expect("a net").scope;
        let cells = netlist.cells.iter().filter(|cell| cell.scope == top).map(|cell| cell.name.as_str());
        let scopes = netlist.scopes.iter().filter(|scope| scope.parent == Some(top)).map(|scope| scope.name.as_str());
        let nets = netlist.nets.iter().filter(|net| net.scope == top && net.port.is_some());
        let names: Vec<_> = cells.chain(scopes).chain(nets.map(|net| net.name.as_str())).collect();
        for numeral in numerals {
            let ending = format!("_{numeral}");
            assert!(names.iter().any(|name| name.ends_with(&ending)), "{name}: {numeral}");
        }
    }
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
