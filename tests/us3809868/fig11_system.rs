//! FIG. 11 with each of its generators: any case through any subset of the transformations, clipped or not.

use std::f64::consts::{SQRT_2, TAU};
use std::ops::ControlFlow;

use stepwright::base::StoppedBy;
use stepwright::base::word::{decode, encode};
use stepwright::simulation::{Circuit, Row};

use super::machine::{Parameters, Stroke};
use crate::converters::arcs::{Numbers, next_arc};

/// A start pulse, and then until the stroke is done.
const STROKE: &str =
    "circuit = \"\"\n[[at]]\ntick = 1\nset = { start = 0 }\n[stop]\nuntil = \"done\"\nlimit = 1_000_000\n";

/// What a control of FIG. 13 makes of a point.
type Map = fn([f64; 2]) -> [f64; 2];

const TURNS: [(&str, Map); 3] =
    [("control_450", |[x, y]| [-y, x]), ("control_452", |[x, y]| [-x, -y]), ("control_454", |[x, y]| [y, -x])];

const REFLECTIONS: [(&str, Map); 4] = [
    ("control_456", |[x, y]| [-x, y]),
    ("control_458", |[x, y]| [x, -y]),
    ("control_460", |[x, y]| [y, x]),
    ("control_462", |[x, y]| [-y, -x]),
];

/// A stroke that is asked for, and what must come of it.
struct Job {
    inputs: Vec<(String, i64)>,
    /// J, L and K, M after all transformations in real numbers, and how far roundings may carry each of them.
    truth: [[f64; 2]; 2],
    doubt: f64,
    from: [i64; 2],
    quarters: i64,
    /// X1, Y1 where no transformation but the offset has a hand in it.
    end: Option<[i64; 2]>,
}

impl Job {
    /// All controls have numbers; those of what is not switched in must not matter.
    fn random(number: usize, numbers: &mut Numbers) -> Self {
        let (case, switched) = (number % 5 + 1, number / 5 % 32);
        let (data, [j, k, l, m]) = next_arc(case, numbers);
        let start = |name: &str| data.words.iter().find(|(port, _)| port == name).expect("a start").1;
        let (from, end) = ([start("x0"), start("y0")], [data.end().0, data.end().1]);
        let quarters = numbers.between(1.0, 5.0) as i64;
        let end = (switched & 15 == 0 && quarters == 1).then_some(end);
        let mut job = Job { inputs: data.words, truth: [[j, l], [k, m]], doubt: 0.51, from, quarters, end };
        job.give("case_364", case as f64);
        job.give("control_382", switched as f64);
        job.give("quarters", quarters as f64);
        job.give("start", 1.0);
        job.clip(number.is_multiple_of(3), numbers);
        job.scale(switched & 8 != 0, numbers);
        job.map(switched & 1 != 0, TURNS[numbers.between(0.0, 3.0) as usize]);
        job.map(switched & 2 != 0, REFLECTIONS[numbers.between(0.0, 4.0) as usize]);
        job.rotate(switched & 4 != 0, numbers);
        job.offset(switched & 16 != 0, numbers);
        job
    }

    fn give(&mut self, name: &str, word: f64) {
        self.inputs.push((name.to_owned(), word as i64));
    }

    fn clip(&mut self, on: bool, numbers: &mut Numbers) {
        self.give("control_388", on.into());
        for (limit, sign) in [("x_min_390", -1.0), ("x_max_392", 1.0), ("y_min_394", -1.0), ("y_max_396", 1.0)] {
            self.give(limit, sign * numbers.between(0.0, 5000.0));
        }
    }

    fn scale(&mut self, on: bool, numbers: &mut Numbers) {
        let word = numbers.between(-6000.0, 6000.0).round();
        self.give("factor_471", word);
        if on {
            let factor = word / 4096.0;
            self.truth = self.truth.map(|pair| pair.map(|word| word * factor));
            self.doubt = self.doubt * factor.abs() + 0.5;
        }
    }

    fn map(&mut self, on: bool, (control, map): (&str, Map)) {
        self.give(control, 1.0);
        if on {
            self.truth = self.truth.map(map);
        }
    }

    fn rotate(&mut self, on: bool, numbers: &mut Numbers) {
        let word = numbers.between(0.0, 65536.0).floor();
        self.give("angle_410", word);
        if on {
            let (sine, cosine) = (word / 65536.0 * TAU).sin_cos();
            self.truth = self.truth.map(|[x, y]| [x * cosine - y * sine, x * sine + y * cosine]);
            self.doubt = self.doubt * SQRT_2 + 0.51;
        }
    }

    fn offset(&mut self, on: bool, numbers: &mut Numbers) {
        for (axis, control) in ["offset_x_488", "offset_y_490"].into_iter().enumerate() {
            let word = numbers.between(-9000.0, 9000.0).round();
            self.give(control, word);
            if on {
                self.from[axis] += word as i64;
                self.end =
                    self.end.map(|end| std::array::from_fn(|at| end[at] + if at == axis { word as i64 } else { 0 }));
            }
        }
    }

    /// What is wrong with what came of it, if anything; a coefficient above `most` must be refused.
    fn judge(&self, most: f64, jklm: [i64; 4], end: [i64; 2], error: bool) -> Option<String> {
        let [[j, l], [k, m]] = self.truth;
        let truth = [j, k, l, m];
        let beyond = truth.iter().fold(0.0, |largest: f64, word| largest.max(word.abs())) - (most + 0.5);
        if beyond.abs() <= self.doubt {
            return None;
        }
        if error || beyond > 0.0 {
            return (error != (beyond > 0.0)).then(|| format!("error {error}, wanted {truth:?}"));
        }
        let off = jklm.iter().zip(truth).map(|(&got, truth)| (got as f64 - truth).abs()).fold(0.0, f64::max);
        let formula = Stroke { jklm, from: self.from, quarters: self.quarters }.end();
        let right = off <= self.doubt && end == formula && self.end.is_none_or(|point| point == end);
        (!right).then(|| format!("{jklm:?} at {end:?}, wanted {truth:?} at {formula:?} or {:?}", self.end))
    }
}

/// Draws so many random strokes; all must end as their formulas say.
fn draw_all(circuit: &str, parameters: Parameters, most: f64, count: usize) {
    let mut numbers = Numbers(count as u64);
    let jobs: Vec<_> = (0..count).map(|number| Job::random(number, &mut numbers)).collect();
    let circuit = Circuit::shipped(&format!("us3809868/{circuit}")).expect("a shipped circuit");
    let session = circuit.scenario("stroke", STROKE).expect("a scenario");
    let session = parameters.iter().fold(session, |session, (name, value)| session.parameter(name, *value));
    let design = session.elaborate().unwrap_or_else(|report| panic!("{report}"));
    let batch = design.batch();
    let output = |name: &str| batch.outputs().iter().position(|port| port.name == name).expect("an output");
    let (jklm, end, error) = (["j", "k", "l", "m"].map(output), ["x", "y"].map(output), output("error"));

    let mut asked = jobs.iter();
    let feed = |words: &mut [u64]| {
        let Some(job) = asked.next() else { return false };
        for (name, value) in &job.inputs {
            let place = batch.input(name).expect("an input").place();
            let port = &batch.inputs()[place];
            words[place] = encode((*value).into(), port.width, port.signed).expect("a number that fits");
        }
        true
    };
    let mut answered = jobs.iter();
    let mut wrong = Vec::new();
    let sink = |row: Row<'_>| {
        let job = answered.next().expect("as many rows as jobs");
        assert_eq!(row.stopped_by, StoppedBy::Until, "{:?}", job.inputs);
        let number = |place: usize| decode(row.outputs[place], 16, true) as i64;
        let judged = job.judge(most, jklm.map(number), end.map(number), row.outputs[error] == 1);
        wrong.extend(judged.map(|what| format!("{what}: {:?}", job.inputs)));
        ControlFlow::Continue(())
    };
    let done = batch.run(feed, sink).expect("threads");
    assert_eq!(done.rows, jobs.len() as u64);
    assert!(wrong.is_empty(), "{} of {} wrong, first {}", wrong.len(), jobs.len(), wrong[0]);
}

#[test]
fn any_case_through_any_subset_of_the_transformations_ends_exactly_where_its_formula_says() {
    draw_all("fig11_system", &[("HALF", 2)], 4095.0, 5 * 32 * 2);
}

#[test]
fn so_it_does_with_the_generator_of_figure_4_which_takes_longer_coefficients() {
    draw_all("fig11_display", &[], 32767.0, 5 * 32);
}

#[test]
fn so_it_does_with_that_of_figure_10() {
    draw_all("fig11_tool", &[], 4095.0, 5 * 32);
}
