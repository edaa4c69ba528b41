//! Strokes of FIG. 9 by the hundred thousand, on the lanes engine.

use std::ops::ControlFlow;

use stepwright::base::word::{mask, signed};
use stepwright::compile::{Observe, Program, Until, compile};
use stepwright::engine::StoppedBy;
use stepwright::engine::batch::{End, InputChange, Options, Plan, Row, run_batch};
use stepwright::netlist::load;
use stepwright::simulation::shipped::{self, Shelf};

use super::machine::{Parameters, Random, SMALL, Stroke};

const CIRCUIT: &str = "us3809868/fig09_function_generator";

/// The circuit, stopping at `done`.
fn program(parameters: Parameters) -> Program {
    let text = shipped::text(&format!("{CIRCUIT}.v")).expect("a shipped circuit");
    let parameters: Vec<_> = parameters.iter().map(|(name, value)| ((*name).to_owned(), *value)).collect();
    let netlist = load(CIRCUIT, text, None, &Shelf { near: CIRCUIT }, &parameters);
    let netlist = netlist.unwrap_or_else(|report| panic!("{report}"));
    let until = netlist.top_net("done").map(|net| Until { net, high: true });
    compile(&netlist, &Observe { until, ..Observe::OUTPUTS })
}

/// The place of an input or output.
fn place<'a>(mut names: impl Iterator<Item = &'a String>, name: &str) -> usize {
    names.position(|known| known == name).unwrap_or_else(|| panic!("no port {name}"))
}

/// Draws so many random strokes; how many were drawn and which of them went wrong.
fn draw_all(parameters: Parameters, most: i64, quarters: Option<i64>, count: usize) -> (u64, Vec<String>) {
    let program = program(parameters);
    let input = |name: &str| place(program.inputs.iter().map(|port| &port.name), name);
    let output = |name: &str| place(program.outputs.iter().map(|port| &port.name), name);
    let (start, [x, y, error]) = (input("start"), ["x", "y", "error"].map(output));
    let plan =
        Plan { changes: vec![InputChange { tick: 1, input: start, word: 0 }], end: End::Until { limit: 100_000 } };

    let mut random = Random(count as u64);
    let mut strokes = (0..count).map(|_| {
        let stroke = random.stroke(most);
        Stroke { quarters: quarters.unwrap_or(stroke.quarters), ..stroke }
    });
    let feed = |words: &mut [u64]| {
        let Some(stroke) = strokes.next() else { return false };
        for (name, value) in stroke.inputs() {
            let port = input(name);
            words[port] = value as u64 & mask(program.inputs[port].width);
        }
        true
    };
    let mut wrong = Vec::new();
    let sink = |row: Row<'_>| {
        let given = |name: &str| signed(row.inputs[input(name)], program.inputs[input(name)].width);
        let stroke = Stroke {
            jklm: ["j", "k", "l", "m"].map(given),
            from: ["x0", "y0"].map(given),
            quarters: row.inputs[input("quarters")] as i64,
        };
        let end = [x, y].map(|place| signed(row.outputs[place], 16));
        if (end, row.outputs[error], row.stopped_by) != (stroke.end(), 0, StoppedBy::Until) {
            wrong.push(format!("{stroke:?} ended at {end:?}"));
        }
        ControlFlow::Continue(())
    };
    let done = run_batch(&program, &plan, feed, sink, Options::default()).expect("threads");
    (done.rows, wrong)
}

#[test]
fn a_hundred_thousand_random_strokes_of_twelve_bits_end_exactly() {
    let (rows, wrong) = draw_all(&[], 4095, Some(1), 100_000);
    assert_eq!(rows, 100_000);
    assert!(wrong.is_empty(), "{} wrong, first {}", wrong.len(), wrong[0]);
}

#[test]
fn twenty_thousand_random_strokes_of_the_small_model_end_exactly_after_one_to_four_quarters() {
    let (rows, wrong) = draw_all(SMALL, 511, None, 20_000);
    assert_eq!(rows, 20_000);
    assert!(wrong.is_empty(), "{} wrong, first {}", wrong.len(), wrong[0]);
}
