//! How many segments minus zero changes, on many lanes: a checksum of the steps beside the interpolator tells.

use std::ops::ControlFlow;

use stepwright::simulation::Circuit;

/// The interpolator with a checksum of its steps, which differ in their order when the checksum does.
const CIRCUIT: &str = "\
module ordered #(parameter MINUS_ZERO = 0) (
    input wire clk, input wire start, input wire [11:0] major, input wire [11:0] minor,
    output wire busy, output wire [31:0] sum
);
    wire x, y, xy;
    interpolator #(.MINUS_ZERO(MINUS_ZERO)) machine (
        .clk(clk), .major_32(major), .start_33(start), .minor_34(minor), .x_is_major_35(1'b1),
        .step_x_36(x), .step_y_37(y), .step_xy_38(xy), .busy(busy)
    );
    checksum #(.WIDTH(3)) steps (.clk(clk), .word({xy, y, x}), .sum(sum));
endmodule
";

const FRAME: &str = "circuit = \"ordered\"\n[[at]]\ntick = 0\nset = { start = 1 }\n\
    [[at]]\ntick = 1\nset = { start = 0 }\n[stop]\nuntil = \"!busy\"\nlimit = 100000\n";

/// The checksum of each segment 0 < X <= `max`.
fn sums(max: u64, minus_zero: i64) -> Vec<u64> {
    let session = Circuit::text("ordered.v", CIRCUIT).scenario("ordered.toml", FRAME).expect("a scenario");
    let design = session.parameter("MINUS_ZERO", minus_zero).elaborate().unwrap_or_else(|report| panic!("{report}"));
    let batch = design.batch();
    let inputs = ["major", "minor"].map(|name| batch.input(name).expect("an input").place());
    let mut segments = (1..=max).flat_map(|major| (0..=major).map(move |minor| [major, minor]));
    let feed = |words: &mut [u64]| {
        segments
            .next()
            .map(|words_of| inputs.into_iter().zip(words_of).for_each(|(input, word)| words[input] = word))
            .is_some()
    };
    let place = batch.outputs().iter().position(|port| port.name == "sum").expect("an output");
    let mut sums = Vec::new();
    batch
        .run(feed, |row| {
            sums.push(row.outputs[place]);
            ControlFlow::Continue(())
        })
        .unwrap_or_else(|report| panic!("{report}"));
    sums
}

#[test]
fn minus_zero_changes_the_order_of_as_many_segments_as_the_page_says() {
    let changed = |max: u64| {
        let (plus, minus) = (sums(max, 0), sums(max, 1));
        (plus.len(), plus.iter().zip(&minus).filter(|(plus, minus)| plus != minus).count())
    };
    // The reading has 682 of 8384.
    assert_eq!(changed(128), (8384, 682));
    let page = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/docs/hazards.md")).expect("the page");
    let (all, some) = changed(1023);
    assert!(page.contains(&format!("{some} of the {all} segments up to 1023")), "{some} of {all}");
}
