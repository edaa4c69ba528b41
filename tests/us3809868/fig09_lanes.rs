//! Strokes of FIG. 9 by the hundred thousand, on the lanes engine.

use std::ops::ControlFlow;

use stepwright::base::StoppedBy;
use stepwright::base::word::{decode, encode};
use stepwright::simulation::{Circuit, Row};

use super::machine::{Parameters, Random, SMALL, Stroke};

/// A start pulse, and then until the stroke is done.
const STROKE: &str =
    "circuit = \"\"\n[[at]]\ntick = 1\nset = { start = 0 }\n[stop]\nuntil = \"done\"\nlimit = 100_000\n";

/// Draws so many random strokes; how many were drawn and which of them went wrong.
fn draw_all(parameters: Parameters, most: i64, quarters: Option<i64>, count: usize) -> (u64, Vec<String>) {
    let circuit = Circuit::shipped("us3809868/fig09_function_generator").expect("a shipped circuit");
    let session = circuit.scenario("stroke", STROKE).expect("a scenario");
    let session = parameters.iter().fold(session, |session, (name, value)| session.parameter(name, *value));
    let design = session.elaborate().unwrap_or_else(|report| panic!("{report}"));
    let batch = design.batch();
    let input = |name: &str| batch.input(name).expect("an input").place();
    let output = |name: &str| batch.outputs().iter().position(|port| port.name == name).expect("an output");
    let [x, y, error] = ["x", "y", "error"].map(output);
    let lines = ["up_304", "down_306", "up_314", "down_316"]
        .map(|line| batch.counted().position(|port| port.name == line).expect("a line"));

    let mut random = Random(count as u64);
    let mut strokes = (0..count).map(|_| {
        let stroke = random.stroke(most);
        Stroke { quarters: quarters.unwrap_or(stroke.quarters), ..stroke }
    });
    let feed = |words: &mut [u64]| {
        let Some(stroke) = strokes.next() else { return false };
        for (name, value) in stroke.inputs() {
            let port = input(name);
            let (width, signed) = (batch.inputs()[port].width, batch.inputs()[port].signed);
            words[port] = encode(value.into(), width, signed).expect("a number that fits");
        }
        true
    };
    let mut wrong = Vec::new();
    let sink = |row: Row<'_>| {
        let given = |name: &str| decode(row.inputs[input(name)], 16, true) as i64;
        let stroke = Stroke {
            jklm: ["j", "k", "l", "m"].map(given),
            from: ["x0", "y0"].map(given),
            quarters: row.inputs[input("quarters")] as i64,
        };
        let end = [x, y].map(|place| decode(row.outputs[place], 16, true) as i64);
        let edges = lines.map(|line| row.pulses[line] as i64);
        if (end, edges, row.outputs[error], row.stopped_by) != (stroke.end(), stroke.counts(), 0, StoppedBy::Until) {
            wrong.push(format!("{stroke:?} ended at {end:?} after {edges:?} rising edges"));
        }
        ControlFlow::Continue(())
    };
    let done = batch.run(feed, sink).expect("threads");
    (done.rows, wrong)
}

#[test]
fn a_hundred_thousand_random_strokes_of_twelve_bits_end_exactly_with_an_edge_for_every_count() {
    let (rows, wrong) = draw_all(&[], 4095, Some(1), 100_000);
    assert_eq!(rows, 100_000);
    assert!(wrong.is_empty(), "{} wrong, first {}", wrong.len(), wrong[0]);
}

#[test]
fn twenty_thousand_random_strokes_of_the_small_model_do_so_after_one_to_four_quarters() {
    let (rows, wrong) = draw_all(SMALL, 511, None, 20_000);
    assert_eq!(rows, 20_000);
    assert!(wrong.is_empty(), "{} wrong, first {}", wrong.len(), wrong[0]);
}
