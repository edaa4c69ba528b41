//! A converter circuit on an engine: data in, a pulse on `start`, coefficients out.

use stepwright::simulation::{Circuit, Net, Run};
use stepwright::trace::Select;

use super::Data;

/// The longest conversion takes about 200 ticks, a stroke drawn after it 32,768 more.
const LIMIT: u64 = 40_000;

/// A converter that is ready for the next data.
pub struct Converter {
    run: Run<'static>,
    done: Net,
}

impl Converter {
    /// A shipped circuit of US 3,809,868.
    pub fn shipped(name: &str) -> Self {
        Self::of(&Circuit::shipped(&format!("us3809868/{name}")).expect("a shipped circuit"))
    }

    /// A circuit.
    pub fn of(circuit: &Circuit) -> Self {
        let outputs = Select::new::<&str>([]).expect("no globs");
        let run = circuit.session().observe(outputs).start().unwrap_or_else(|report| panic!("{report}"));
        Self { done: run.net("done").expect("an output"), run }
    }

    /// The number at an output.
    pub fn output(&self, name: &str) -> i64 {
        self.run.read(self.run.net(name).expect("an output")) as i64
    }

    fn set(&mut self, name: &str, value: i64) {
        let set = self.run.input(name).and_then(|input| self.run.set(input, value));
        set.unwrap_or_else(|report| panic!("{value} in {name}: {report}"));
    }

    /// Converts; returns J, K, L, M, or `None` when `error` is raised, and how many ticks it took. What must hold
    /// in every conversion is asserted.
    pub fn convert(&mut self, data: &Data) -> (Option<[i64; 4]>, u64) {
        let ticks = self.run(data);
        for (name, word) in data.words.iter().filter(|(name, _)| ["x0", "y0"].contains(&name.as_str())) {
            assert_eq!(self.output(&format!("{name}_out")), *word);
        }
        let result = self.result();
        if let Some([j, k, l, m]) = result {
            assert_eq!((k - j, m - l), data.chord(), "the drawn end is (X1, Y1): {data:?}");
        }
        (result, ticks)
    }

    /// Converts, whatever comes of it.
    pub fn convert_unchecked(&mut self, data: &Data) -> Option<[i64; 4]> {
        self.run(data);
        self.result()
    }

    fn run(&mut self, data: &Data) -> u64 {
        data.words.iter().for_each(|(name, word)| self.set(name, *word));
        self.set("start", 1);
        let start = self.run.tick();
        self.run.step(1);
        self.set("start", 0);
        if self.run.word(self.done) == 0 {
            self.run.until(self.done, LIMIT);
        }
        let ticks = self.run.tick() - start;
        assert_eq!(self.output("done"), 1, "done always comes: {data:?}");
        ticks
    }

    fn result(&self) -> Option<[i64; 4]> {
        let result = ["j", "k", "l", "m"].map(|name| self.output(name));
        let error = self.output("error") == 1;
        assert!(!error || result == [0; 4], "nothing comes out with an error");
        (!error).then_some(result)
    }
}

/// The largest deviation of a coefficient from the formula.
pub fn deviation(got: [i64; 4], truth: [f64; 4]) -> f64 {
    got.iter().zip(truth).map(|(&got, truth)| (got as f64 - truth).abs()).fold(0.0, f64::max)
}
