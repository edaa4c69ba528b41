//! Figure 1, block by block: every numeral of the drawing is in the circuit.

use super::machine::interpolator;

/// What block 1, 2, 3 ... 22 is.
const BLOCKS: [&str; 22] = [
    "ones_complement_accumulator",
    "shift_register",
    "shift_register",
    "trigger",
    "trigger",
    "or",
    "or",
    "or",
    "or",
    "or",
    "or",
    "or",
    "delay_element",
    "subtracting_counter",
    "clock_generator",
    "and",
    "and",
    "and",
    "and",
    "pulse_distributor",
    "multiplexer",
    "delay_element",
];

#[test]
fn every_block_tap_input_and_output_of_figure_1_bears_its_numeral() {
    let design = interpolator(&[]).elaborate().unwrap_or_else(|report| panic!("{report}"));
    let netlist = design.netlist();
    for (numeral, block) in (1..).zip(BLOCKS) {
        let ending = format!("_{numeral}");
        let cells: Vec<_> = netlist.cells.iter().filter(|cell| cell.name.ends_with(&ending)).collect();
        assert_eq!(cells.iter().map(|cell| cell.module()).collect::<Vec<_>>(), [block], "block {numeral}");
    }
    for tap in 23..=31 {
        assert!(netlist.top_net(&format!("tap_{tap}")).is_some(), "tap {tap}");
    }
    let ports = netlist.inputs.iter().chain(&netlist.outputs).map(|net| netlist.net_name(*net));
    let expected =
        ["major_32", "start_33", "minor_34", "x_is_major_35", "step_x_36", "step_y_37", "step_xy_38", "busy"];
    assert_eq!(ports.collect::<Vec<_>>(), expected);
}
