//! Every numeral of FIG. 3 to 8, 11 to 18 and 20 of US 3,809,868 is the ending of an instance's or a net's name in its
//! circuit.

use stepwright::simulation::Circuit;

/// The names of all instances and nets of a circuit, those inside its modules included.
fn names(circuit: &str) -> Vec<String> {
    let circuit = Circuit::shipped(&format!("us3809868/{circuit}")).expect("the circuit");
    let netlist = circuit.elaborate(&[]).unwrap_or_else(|report| panic!("{report}"));
    let scopes = netlist.scopes.iter().map(|scope| scope.name.clone());
    let cells = netlist.cells.iter().map(|cell| cell.name.clone());
    scopes.chain(cells).chain(netlist.nets.iter().map(|net| net.name.clone())).collect()
}

fn assert_named(circuit: &str, numerals: impl IntoIterator<Item = u32>) {
    let names = names(circuit);
    let missing: Vec<_> = numerals
        .into_iter()
        .filter(|numeral| !names.iter().any(|name| name.ends_with(&format!("_{numeral}"))))
        .collect();
    assert!(missing.is_empty(), "{circuit} has no {missing:?}");
}

#[test]
fn every_numeral_of_figures_3_and_5_to_8_is_a_name() {
    assert_named("fig03_case1", (50..=78).step_by(2));
    assert_named("fig05_case2", (102..=142).step_by(2));
    let taken_over = [110, 114, 116, 118, 120, 122, 124, 126, 132, 134, 136, 138, 140];
    assert_named("fig06_case3", taken_over.into_iter().chain((144..=160).step_by(2)));
    assert_named("fig07_case4", (162..=234).step_by(2));
    assert_named("fig08_case5", (236..=260).step_by(2));
}

#[test]
fn every_numeral_of_figures_4_and_4a_inside_the_generator_is_a_name() {
    assert_named("fig04_function_generator", (80..=88).step_by(2).chain(89..=103).chain([105, 107, 109, 111]));
}

#[test]
fn every_numeral_of_figures_12_to_15_and_20_is_a_name() {
    assert_named("fig12_rotation", (410..=438).step_by(2));
    assert_named("fig13_quarter_turns", (440..=464).step_by(2));
    assert_named("fig14_scaling", [470, 471, 472, 474, 476]);
    assert_named("fig15_offset", [480, 486, 488, 490]);
    // Two circuits: FIG. 20 without and with its generators.
    assert_named("fig20_rotation3d", (612..=638).step_by(2));
    assert_named("fig20_display", (612..=642).step_by(2));
}

#[test]
fn every_numeral_of_figures_16_and_17_is_a_name() {
    assert_named("fig16_clipping", [100, 109, 390, 392, 394, 396, 492, 494, 496, 498]);
    assert_named("fig17_characters", [449, 500, 502, 503, 504, 505, 506, 507, 508, 509, 510, 512, 514]);
}

#[test]
fn every_numeral_of_figure_11_is_a_name() {
    assert_named("fig11_system", (350..=406).step_by(2).filter(|&numeral| numeral != 398));
}

#[test]
fn every_numeral_of_figure_18_inside_the_machine_is_a_name() {
    // 550, 552, 570 and 584 are outside: keyboard, computer, display, readers.
    assert_named("fig18_processor", (554..=568).step_by(2));
}
