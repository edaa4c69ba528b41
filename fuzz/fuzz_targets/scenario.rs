//! Any text as a scenario of a small circuit.
#![no_main]

use std::sync::LazyLock;

use stepwright::base::Report;
use stepwright::simulation::Circuit;

const CIRCUIT: &str = "
module held #(parameter WIDTH = 4) (
    input wire clk,
    input wire go,
    (* fraction = 2 *) input wire signed [5:0] slope,
    output wire [WIDTH-1:0] count,
    output wire busy
);
    register #(.WIDTH(WIDTH)) register_1 (.clk(clk), .word({{WIDTH-1{1'b0}}, go}), .enable(go), .clear(slope[0]), .q(count));
    buf buf_1 (busy, go);
endmodule";

static HELD: LazyLock<Circuit> = LazyLock::new(|| {
    let circuit = Circuit::text("held.v", CIRCUIT);
    circuit.session().elaborate().unwrap_or_else(|report| panic!("{report}"));
    circuit
});

libfuzzer_sys::fuzz_target!(|text: &str| check(text));

/// What is read says what to do, or what in it the circuit has not; what is not says why and where.
fn check(text: &str) {
    let session = match HELD.scenario("fuzzed.toml", text) {
        Ok(session) => session,
        Err(report) => return is_told(&report, text),
    };
    if let Err(report) = session.elaborate() {
        is_told(&report, text);
    }
}

fn is_told(report: &Report, text: &str) {
    assert!(!report.diagnostics.is_empty(), "a text is refused without a reason");
    for diagnostic in &report.diagnostics {
        let places = &diagnostic.labels;
        assert!(places.iter().all(|(span, _)| span.start <= span.end), "{diagnostic:?}");
    }
    assert!(report.render(false).starts_with("error["), "{text}");
    assert!(!report.render(true).is_empty());
}
