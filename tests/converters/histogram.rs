//! Ten thousand random arcs a case: their errors, and the histogram in the documentation.

use super::arcs::{Numbers, next_arc};
use super::rig::deviation;
use super::{CIRCUITS, Converter};

const ARCS: u32 = 10_000;

/// What the arcs of one case came to.
#[derive(Default)]
struct Errors {
    /// Arcs by their largest deviation, in tenths of a count.
    tenths: [u32; 5],
    worst: f64,
    refused: u32,
    longest: u64,
}

fn measure(case: usize, circuit: &str) -> Errors {
    let mut converter = Converter::shipped(circuit);
    let mut numbers = Numbers(case as u64);
    let mut errors = Errors::default();
    for _ in 0..ARCS {
        let (data, truth) = next_arc(case, &mut numbers);
        let (got, ticks) = converter.convert(&data);
        errors.longest = errors.longest.max(ticks);
        let Some(got) = got else {
            errors.refused += 1;
            continue;
        };
        let error = deviation(got, truth);
        assert!(error < 0.51, "case {case}: {data:?}: {got:?}, not {truth:?}");
        errors.worst = errors.worst.max(error);
        errors.tenths[((error * 10.0) as usize).min(4)] += 1;
    }
    errors
}

impl Errors {
    fn row(&self, circuit: &str) -> String {
        let bins = self.tenths.map(|count| count.to_string()).join(" | ");
        format!("| `{circuit}` | {bins} | {:.4} | {} | {} |", self.worst, self.refused, self.longest)
    }
}

#[test]
fn ten_thousand_arcs_a_case_are_right_to_the_last_count_and_documented() {
    let mut rows = Vec::new();
    for (case, circuit) in (1..).zip(CIRCUITS) {
        let errors = measure(case, circuit);
        assert!(errors.refused <= 3, "{} well-conditioned arcs of case {case} are refused", errors.refused);
        rows.push(errors.row(circuit));
    }
    let table = rows.join("\n");
    let page = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/docs/converters.md")).expect("the page");
    assert!(page.contains(&table), "docs/converters.md should have these rows:\n{table}");
}
