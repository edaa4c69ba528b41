//! A transformation circuit under test: numbers in, a pulse on `start`, numbers out.

use stepwright::simulation::Net;

use super::machine::{Machine, shipped_session};

/// The longest transformation, FIG. 20, takes 23 ticks.
const LIMIT: u32 = 100;

/// A circuit that is ready for the next start.
pub struct Transformer {
    /// The circuit, to set and read beside a transformation.
    pub machine: Machine,
    outputs: Vec<Net>,
    done: Net,
    error: Net,
}

impl Transformer {
    /// A shipped circuit of US 3,809,868, with its outputs in order and the nets that are to be read beside.
    pub fn shipped(name: &str, outputs: &[&str], nets: &[&str]) -> Self {
        let machine = Machine::new(&shipped_session(&format!("us3809868/{name}"), &[], nets));
        let outputs = outputs.iter().map(|output| machine.find(output)).collect();
        let (done, error) = (machine.find("done"), machine.find("error"));
        Self { machine, outputs, done, error }
    }

    /// Transforms: what comes out, or `None` with an error, when all must be 0.
    pub fn run(&mut self, inputs: &[(&str, i64)]) -> Option<Vec<i64>> {
        self.start(inputs);
        self.finish()
    }

    /// The tick of the start.
    pub fn start(&mut self, inputs: &[(&str, i64)]) {
        self.machine.set(inputs);
        self.machine.set(&[("start", 1)]);
        self.machine.tick();
        self.machine.set(&[("start", 0)]);
    }

    /// From the tick after the start to `done`.
    pub fn finish(&mut self) -> Option<Vec<i64>> {
        for _ in 0..LIMIT {
            if self.machine.word(self.done) == 1 {
                return self.result();
            }
            self.machine.tick();
        }
        panic!("done does not come");
    }

    /// What stands at the outputs.
    pub fn result(&self) -> Option<Vec<i64>> {
        let words: Vec<i64> = self.outputs.iter().map(|&output| self.machine.number(output)).collect();
        let error = self.machine.word(self.error) == 1;
        assert!(!error || words.iter().all(|&word| word == 0), "nothing comes out with an error: {words:?}");
        (!error).then_some(words)
    }
}

/// The greatest deviation of a result from the truth.
pub fn deviation(got: &[i64], truth: &[f64]) -> f64 {
    assert_eq!(got.len(), truth.len());
    got.iter().zip(truth).map(|(&got, truth)| (got as f64 - truth).abs()).fold(0.0, f64::max)
}

/// Whether a result must be in its 16 bits, must be beyond them, or stands so near to the border that its rounding
/// decides.
pub fn fits(truth: &[f64], doubt: f64) -> Option<bool> {
    let beyond = truth.iter().map(|value| (value - 32767.0).max(-32768.0 - value)).fold(f64::MIN, f64::max);
    if beyond < -doubt {
        Some(true)
    } else if beyond > doubt {
        Some(false)
    } else {
        None
    }
}

/// An angle in radians as the nearest word, and what that word stands for.
pub fn angle_word(radians: f64) -> (i64, f64) {
    let turn = f64::from(1 << 16);
    let word = (radians / std::f64::consts::TAU * turn).round().rem_euclid(turn);
    (word as i64, word / turn * std::f64::consts::TAU)
}

/// Asserts that a table stands in the documentation.
pub fn assert_documented(table: &str) {
    let page = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/docs/transformations.md"));
    assert!(page.expect("the page").contains(table), "docs/transformations.md should have:\n{table}");
}
