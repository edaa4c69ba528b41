//! FIG. 11: any case through any subset of the transformations, clipped or not, by the hundred.

use std::ops::ControlFlow;

use stepwright::base::StoppedBy;
use stepwright::base::word::{decode, encode};
use stepwright::simulation::{Circuit, Row};

use super::machine::Stroke;
use crate::converters::arcs::{Numbers, next_arc};

const CIRCUIT: &str = "us3809868/fig11_system";

/// A start pulse, and then until the stroke is done.
const STROKE: &str =
    "circuit = \"\"\n[[at]]\ntick = 1\nset = { start = 0 }\n[stop]\nuntil = \"done\"\nlimit = 1_000_000\n";

/// What a control of FIG. 13 makes of a point.
type Map = fn([f64; 2]) -> [f64; 2];

const TURNS: [(&str, Map); 4] = [
    ("control_450", |[x, y]| [-y, x]),
    ("control_452", |[x, y]| [-x, -y]),
    ("control_454", |[x, y]| [y, -x]),
    ("control_464", |point| point),
];

const REFLECTIONS: [(&str, Map); 4] = [
    ("control_456", |[x, y]| [-x, y]),
    ("control_458", |[x, y]| [x, -y]),
    ("control_460", |[x, y]| [y, x]),
    ("control_462", |[x, y]| [-y, -x]),
];

/// A stroke that is asked for, and what must come of it.
struct Job {
    inputs: Vec<(String, i64)>,
    /// J, K, L, M after all transformations in real numbers, and how far roundings on the way may carry each of them.
    truth: [f64; 4],
    doubt: f64,
    from: [i64; 2],
    quarters: i64,
    /// X1, Y1 where no transformation but the offset has a hand in it.
    end: Option<[i64; 2]>,
}

/// A whole number from 0 to `below`.
fn draw(numbers: &mut Numbers, below: u64) -> usize {
    (numbers.next() % below) as usize
}

impl Job {
    fn random(number: usize, numbers: &mut Numbers) -> Self {
        let case = number % 5 + 1;
        let (data, [j, k, l, m]) = next_arc(case, numbers);
        let switched = number / 5 % 32;
        let mut inputs = data.words.clone();
        let mut set = |name: &str, value: f64| inputs.push((name.to_owned(), value as i64));
        let mut pairs = [[j, l], [k, m]];
        let mut doubt = 0.51;
        let mut from = [0, 0];
        for (place, name) in ["x0", "y0"].into_iter().enumerate() {
            from[place] = data.words.iter().find(|(port, _)| port == name).expect("a start").1;
        }
        let (mut end, quarters) = (Some([data.end().0, data.end().1]), draw(numbers, 4) as i64 + 1);

        let factor = (numbers.between(-1.5, 1.5) * 4096.0).round();
        let angle = numbers.between(0.0, 65536.0).floor();
        let ((turn, turned), (mirror, mirrored)) = (TURNS[draw(numbers, 4)], REFLECTIONS[draw(numbers, 4)]);
        let offset = [(); 2].map(|()| numbers.between(-9000.0, 9000.0).round());
        set("factor_471", factor);
        set("angle_410", angle);
        set("offset_x_488", offset[0]);
        set("offset_y_490", offset[1]);
        // Controls of what is not switched in must not matter, but 464 is shared.
        if turn != "control_464" || switched & 2 == 0 {
            set(turn, 1.0);
        }
        if turn != "control_464" || switched & 1 == 0 || switched & 2 == 0 {
            set(mirror, 1.0);
        }
        if switched & 8 != 0 {
            pairs = pairs.map(|pair| pair.map(|word| word * factor / 4096.0));
            doubt = doubt * (factor / 4096.0).abs() + 0.5;
        }
        let alone = turn == "control_464" && switched & 3 == 3;
        if alone {
            set("control_464", 1.0);
        }
        if switched & 1 != 0 {
            pairs = pairs.map(turned);
        }
        if switched & 2 != 0 && !alone {
            pairs = pairs.map(mirrored);
        }
        if switched & 4 != 0 {
            let (sine, cosine) = (angle / 65536.0 * std::f64::consts::TAU).sin_cos();
            pairs = pairs.map(|[x, y]| [x * cosine - y * sine, x * sine + y * cosine]);
            doubt = doubt * std::f64::consts::SQRT_2 + 0.51;
        }
        if switched & 16 != 0 {
            for axis in 0..2 {
                from[axis] += offset[axis] as i64;
                end = end.map(|mut end| {
                    end[axis] += offset[axis] as i64;
                    end
                });
            }
        }
        if switched & 15 != 0 || quarters > 1 {
            end = None;
        }
        set("case_364", case as f64);
        set("quarters", quarters as f64);
        set("control_382", switched as f64);
        set("control_388", (number % 3 == 0).into());
        for (limit, sign) in [("x_min_390", -1.0), ("x_max_392", 1.0), ("y_min_394", -1.0), ("y_max_396", 1.0)] {
            set(limit, sign * numbers.between(0.0, 5000.0));
        }
        set("start", 1.0);
        let [[j, l], [k, m]] = pairs;
        Job { inputs, truth: [j, k, l, m], doubt, from, quarters, end }
    }

    /// What is wrong with what came of it, if anything.
    fn judge(&self, jklm: [i64; 4], end: [i64; 2], error: bool) -> Option<String> {
        let largest = self.truth.iter().fold(0.0, |largest: f64, word| largest.max(word.abs()));
        if (largest - 4095.5).abs() <= self.doubt {
            return None;
        }
        if error || largest > 4095.5 {
            return (error != (largest > 4095.5)).then(|| format!("error {error}, largest coefficient {largest}"));
        }
        let off = jklm.iter().zip(self.truth).map(|(&got, truth)| (got as f64 - truth).abs()).fold(0.0, f64::max);
        let formula = Stroke { jklm, from: self.from, quarters: self.quarters }.end();
        let right = off <= self.doubt && end == formula && self.end.is_none_or(|point| point == end);
        (!right).then(|| format!("{jklm:?} at {end:?}, wanted {:?} at {formula:?} or {:?}", self.truth, self.end))
    }
}

#[test]
fn any_case_through_any_subset_of_the_transformations_ends_exactly_where_its_formula_says() {
    let mut numbers = Numbers(11);
    let jobs: Vec<_> = (0..5 * 32 * 2).map(|number| Job::random(number, &mut numbers)).collect();
    let circuit = Circuit::shipped(CIRCUIT).expect("a shipped circuit");
    let session = circuit.scenario("stroke", STROKE).expect("a scenario").parameter("HALF", 2);
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
        let judged = job.judge(jklm.map(number), end.map(number), row.outputs[error] == 1);
        wrong.extend(judged.map(|what| format!("{what}: {:?}", job.inputs)));
        ControlFlow::Continue(())
    };
    let done = batch.run(feed, sink).expect("threads");
    assert_eq!(done.rows, jobs.len() as u64);
    assert!(wrong.is_empty(), "{} of {} wrong, first {}", wrong.len(), jobs.len(), wrong[0]);
}
