//! No shipped circuit is too slow for the limit of its own default scenario, whatever the inputs are.

use std::ops::ControlFlow;

use rayon::prelude::*;
use stepwright::base::{Port, StoppedBy, word};
use stepwright::simulation::{Batch, Design, Session, shipped};

/// All words of a short input; of a longer one the ends of its range, and the longest coefficient that a multiplier of
/// the circuit's WIDTH takes, because it may refuse longer ones at once.
fn edges(design: &Design, port: &Port) -> Vec<u64> {
    let width = design.netlist().parameters.iter().find(|one| one.name == "WIDTH").map_or(12, |one| one.value);
    let (low, high) = word::range(port.width, port.signed);
    let values = if port.width < 4 { (low..=high).collect() } else { vec![low, high, (1 << width) - 1] };
    values.into_iter().filter_map(|value| word::encode(value, port.width, port.signed)).collect()
}

/// The ticks that each of some words on an input takes, the others held.
fn ticks(batch: &Batch<'_>, held: &[u64], input: usize, edges: &[u64]) -> Vec<u64> {
    let mut edges = edges.iter();
    let mut ticks = Vec::new();
    let feed = |words: &mut [u64]| {
        words.copy_from_slice(held);
        edges.next().map(|&edge| words[input] = edge).is_some()
    };
    let done = batch.run(feed, |row| {
        let story: Vec<_> = batch.inputs().iter().map(|port| &port.name).zip(row.inputs).collect();
        assert_ne!(row.stopped_by, StoppedBy::Limit, "raise the limit: {story:?}");
        ticks.push(row.ticks);
        ControlFlow::Continue(())
    });
    done.unwrap_or_else(|report| panic!("{report}"));
    ticks
}

/// What stops a clock from outside for as long as it is high.
const HOLDING: [&str; 2] = ["hold", "inhibit"];

/// Moves the inputs that the scenario does not work itself, one after another, to the edge with which it runs longest.
fn judge(name: &str) {
    let design =
        Session::open(name).and_then(|session| session.engine("native".parse().expect("an engine")).elaborate());
    let design = design.unwrap_or_else(|report| panic!("{report}"));
    let batch = design.batch();
    let mut held = design.stimulus().initial.clone();
    for (input, port) in batch.inputs().iter().enumerate() {
        let is_free = design.stimulus().changes.iter().all(|change| change.input != input);
        if is_free && !HOLDING.contains(&port.name.as_str()) {
            let edges = edges(&design, port);
            let ticks = ticks(&batch, &held, input, &edges);
            let longest = ticks.into_iter().zip(edges).max();
            held[input] = longest.map_or(held[input], |(_, edge)| edge);
        }
    }
}

#[test]
fn no_default_scenario_stops_by_its_limit_with_any_input_at_an_edge() {
    let circuits: Vec<_> = shipped::names("v").collect();
    assert!(!circuits.is_empty());
    circuits.into_par_iter().for_each(judge);
}
