//! How many segments minus zero changes, on many lanes: two interpolators side by side tell.

use std::ops::ControlFlow;

use stepwright::simulation::Circuit;

/// Both interpolators side by side, and a trigger that is set when they take different steps at the same time.
const CIRCUIT: &str = "\
module both (
    input wire clk, input wire start, input wire [11:0] major, input wire [11:0] minor,
    output wire busy, output wire differs
);
    wire plus, minus, unlike;
    interpolator #(.MINUS_ZERO(0)) machine_plus (
        .clk(clk), .major_32(major), .start_33(start), .minor_34(minor), .x_is_major_35(1'b1),
        .step_x_36(), .step_y_37(), .step_xy_38(plus), .busy(busy)
    );
    interpolator #(.MINUS_ZERO(1)) machine_minus (
        .clk(clk), .major_32(major), .start_33(start), .minor_34(minor), .x_is_major_35(1'b1),
        .step_x_36(), .step_y_37(), .step_xy_38(minus), .busy()
    );
    xor unlike_steps (unlike, plus, minus);
    trigger kept (.clk(clk), .set(unlike), .reset(start), .q(differs));
endmodule
";

const FRAME: &str = "circuit = \"both\"\n[[at]]\ntick = 0\nset = { start = 1 }\n\
    [[at]]\ntick = 1\nset = { start = 0 }\n[stop]\nuntil = \"!busy\"\nlimit = 100000\n";

/// How many segments 0 < X <= `max` there are, and how many of them take their steps in another order.
fn changed(max: u64) -> (u64, u64) {
    let session = Circuit::text("both.v", CIRCUIT).scenario("both.toml", FRAME).expect("a scenario");
    let design = session.elaborate().unwrap_or_else(|report| panic!("{report}"));
    let batch = design.batch();
    let [major, minor] = ["major", "minor"].map(|name| batch.input(name).expect("an input").place());
    let mut segments = (1..=max).flat_map(|major| (0..=major).map(move |minor| (major, minor)));
    let feed = |words: &mut [u64]| match segments.next() {
        Some(segment) => {
            (words[major], words[minor]) = segment;
            true
        }
        None => false,
    };
    let differs = batch.outputs().iter().position(|port| port.name == "differs").expect("an output");
    let mut changed = (0, 0);
    batch
        .run(feed, |row| {
            changed = (changed.0 + 1, changed.1 + row.outputs[differs]);
            ControlFlow::Continue(())
        })
        .unwrap_or_else(|report| panic!("{report}"));
    changed
}

#[test]
fn minus_zero_changes_the_order_of_as_many_segments_as_the_page_says() {
    // The reading has 682 of 8384.
    assert_eq!(changed(128), (8384, 682));
    let page = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/docs/hazards.md")).expect("the page");
    let (all, some) = changed(1023);
    assert!(page.contains(&format!("{some} of the {all} segments up to 1023")), "{some} of {all}");
}
