//! The vectors of the patent's reading: random arcs and the named edge cases.

use serde_json::Value;

use super::formulas::coefficients;
use super::rig::deviation;
use super::{CIRCUITS, Converter, Data};

fn read(case: usize) -> Value {
    let path = format!("{}/tests/vectors/us3809868/case{case}.json", env!("CARGO_MANIFEST_DIR"));
    serde_json::from_str(&std::fs::read_to_string(path).expect("a vector file")).expect("JSON")
}

/// The data of an entry, rounded to words; `None` when a slope is infinite, which no word holds.
fn data(entry: &Value) -> Option<Data> {
    let fields = entry["in"].as_object().expect("an object");
    let reals: Option<Vec<_>> = fields.iter().map(|(name, value)| Some((name.as_str(), value.as_f64()?))).collect();
    reals.map(Data::rounded)
}

/// How far a coefficient may be off: within 1 count below 2048, within 2 up to 4095.
fn bound(truth: [f64; 4]) -> f64 {
    let largest = truth.iter().map(|value| value.abs()).fold(0.0, f64::max);
    if largest < 2048.0 { 1.0 } else { 2.0 }
}

#[test]
fn every_random_vector_comes_out_within_a_count() {
    for (case, circuit) in (1..).zip(CIRCUITS) {
        let mut converter = Converter::shipped(circuit);
        let file = read(case);
        let random = file["random"].as_array().expect("entries");
        assert!(random.len() >= 60);
        for entry in random {
            let data = data(entry).expect("finite slopes");
            let (got, _) = converter.convert(&data);
            match (got, coefficients(case, &data)) {
                (Some(got), Some(truth)) => {
                    assert!(deviation(got, truth) <= bound(truth), "case {case}: {data:?}: {got:?}, not {truth:?}");
                }
                (got, truth) => assert_eq!(got.is_none(), truth.is_none(), "case {case}: {data:?}: {got:?}, {truth:?}"),
            }
        }
    }
}

#[test]
fn every_edge_case_does_what_its_entry_says() {
    let mut judged = 0;
    for (case, circuit) in (1..).zip(CIRCUITS) {
        let mut converter = Converter::shipped(circuit);
        for entry in read(case)["edges"].as_array().expect("entries") {
            let Some(data) = data(entry) else { continue };
            let (got, _) = converter.convert(&data);
            let name = format!("case {case}, {}: {got:?}", entry["name"]);
            match (entry.get("error"), coefficients(case, &data)) {
                (Some(_), _) => assert_eq!(got, None, "{name}"),
                (None, Some(truth)) => {
                    let got = got.unwrap_or_else(|| panic!("{name}"));
                    assert!(deviation(got, truth) <= 1.0, "{name}, not {truth:?}");
                }
                (None, None) => panic!("{name}: the formula has no answer"),
            }
            judged += 1;
        }
    }
    assert_eq!(judged, 33, "entries with finite slopes");
}
