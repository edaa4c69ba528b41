//! The computer of FIG. 18: FIG. 19, the conversions, the FORTRAN of Appendix A, and what it draws through the bus.

mod appendix;
mod cases;
mod chain;
mod drawn;
mod listing;
mod page;
mod words;

use serde_json::Value;
use stepwright::host::{Chain, Entry, Point};

use super::vectors::{list, read, reals};

#[path = "../../../examples/linked_chain.rs"]
#[expect(dead_code, reason = "its main function is not wanted here")]
mod linked_chain;

fn point(value: &Value) -> Point {
    reals(value).try_into().expect("two numbers")
}

/// The chain of the reading's vectors.
fn given() -> Chain {
    let file = read("fig19_linked.json");
    let chain = Chain::new(point(&file["P0"]), file["S0"].as_f64().expect("a slope"));
    let entry = |step: &Value| match list(step) {
        [end, slope] if slope[0] == "S1" => {
            Some(Entry::One { p1: point(end), s1: slope[1].as_f64().expect("a slope") })
        }
        [between, end] => Some(Entry::Two { p3: point(between), p1: point(end) }),
        _ => None,
    };
    list(&file["steps"]).iter().filter_map(entry).fold(chain, Chain::then)
}

/// Whether two numbers are equal but for the rounding of `f64`.
fn is_near(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-9 * (1.0 + b.abs())
}

fn assert_near(got: &[f64], wanted: &[f64], name: &str) {
    assert!(
        got.len() == wanted.len() && got.iter().zip(wanted).all(|(got, wanted)| is_near(*got, *wanted)),
        "{name}: {got:?}, not {wanted:?}"
    );
}

/// A spiral of sections of so many degrees, each with a point half way.
fn spiral(degrees: f64) -> Chain {
    let radius = |turned: f64| 150.0 + 25.0 * turned;
    let at = |turned: f64| [turned.cos(), turned.sin()].map(|x| (radius(turned) * x).round());
    let step = (degrees / 2.0).to_radians();
    let from = 10.0_f64.to_radians();
    let slope = (25.0 * from.sin() + radius(from) * from.cos()) / (25.0 * from.cos() - radius(from) * from.sin());
    let entry = |n: i32| {
        let turned = from + f64::from(2 * n) * step;
        Entry::Two { p3: at(turned + step), p1: at(turned + 2.0 * step) }
    };
    (0..9).map(entry).fold(Chain::new(at(from), slope), Chain::then)
}
