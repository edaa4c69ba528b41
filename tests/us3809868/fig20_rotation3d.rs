//! FIG. 20 against three rotations of a point in f64, and its sequence state by state.

use std::f64::consts::TAU;

use super::machine::Random;
use super::transform::{Transformer, angle_word, assert_documented, deviation, fits};
use super::vectors::{list, read, real, reals};

const INPUTS: [&str; 6] = ["j", "k", "l", "m", "n", "p"];
const OUTPUTS: [&str; 6] = ["j_out", "k_out", "l_out", "m_out", "n_out", "p_out"];

/// What is to be turned, and how.
#[derive(Clone, Copy, Debug)]
struct Turn {
    /// J, K, L, M, N, P.
    words: [i64; 6],
    /// Axis of each rotation, first one first: 1 to 3 for X to Z, 0 for none.
    codes: [i64; 3],
    /// About X, Y, Z; 2^16 is a full turn.
    angles: [i64; 3],
}

impl Turn {
    fn inputs(&self) -> Vec<(&'static str, i64)> {
        let [first, second, third] = self.codes;
        let order = first + 4 * second + 16 * third;
        let angles = ["angle_628", "angle_632", "angle_636"].into_iter().zip(self.angles);
        INPUTS.into_iter().zip(self.words).chain(angles).chain([("order_616", order)]).collect()
    }

    /// The exact coefficients after each rotation.
    fn exact(&self) -> [[f64; 6]; 3] {
        let radians = self.angles.map(|angle| angle as f64 / 65536.0 * TAU);
        turned(self.words.map(|word| word as f64), self.codes, radians)
    }
}

/// The points (J, L, N) and (K, M, P) turned right-handed, first code first: y to z, z to x, x to y. What they are
/// after each rotation.
fn turned([j, k, l, m, n, p]: [f64; 6], codes: [i64; 3], radians: [f64; 3]) -> [[f64; 6]; 3] {
    let mut points = [[j, l, n], [k, m, p]];
    codes.map(|code| {
        if code > 0 {
            let axis = code as usize - 1;
            points = points.map(|point| about(axis, radians[axis], point));
        }
        let [[j, l, n], [k, m, p]] = points;
        [j, k, l, m, n, p]
    })
}

/// A point turned about an axis, 0 for X.
fn about(axis: usize, radians: f64, mut point: [f64; 3]) -> [f64; 3] {
    let (from, to) = ((axis + 1) % 3, (axis + 2) % 3);
    let (sine, cosine) = radians.sin_cos();
    (point[from], point[to]) = (point[from] * cosine - point[to] * sine, point[from] * sine + point[to] * cosine);
    point
}

fn shipped(nets: &[&str]) -> Transformer {
    Transformer::shipped("fig20_rotation3d", &OUTPUTS, nets)
}

#[test]
fn every_vector_of_the_reading_comes_out_within_two_counts() {
    let mut circuit = shipped(&[]);
    let file = read("fig20_rot3.json");
    for entry in list(&file["rot3"]) {
        let coefficients: [f64; 6] = reals(&entry["q"]).try_into().expect("six");
        let order = entry["order"].as_str().expect("three letters");
        let codes: Vec<i64> = order.bytes().map(|axis| i64::from(axis - b'X') + 1).collect();
        let codes = codes.try_into().expect("three");
        let radians = ["X", "Y", "Z"].map(|axis| real(&entry["angles"][axis]));
        let [.., truth] = turned(coefficients, codes, radians);
        assert!(truth.iter().zip(reals(&entry["out"])).all(|(ours, theirs)| (ours - theirs).abs() < 1e-9));

        let words = coefficients.map(|value| value.round() as i64);
        let turn = Turn { words, codes, angles: radians.map(|radians| angle_word(radians).0) };
        let got = circuit.run(&turn.inputs()).expect("small");
        assert!(deviation(&got, &turn.exact()[2]) <= 2.0, "{turn:?}: {got:?}");
        // Whole inputs may be half a count off in each of three terms, each angle half a unit.
        assert!(deviation(&got, &truth) <= 3.0, "{entry}: {got:?}");
    }
}

/// The worst deviation of 10,000 random turns of any order and any codes, and how many were refused: just those that
/// leave their words after a rotation.
fn worst_of_ten_thousand(most: i64) -> (f64, u32) {
    let mut circuit = shipped(&[]);
    let mut random = Random(most as u64 + 20);
    let (mut worst, mut refused) = (0.0_f64, 0);
    for _ in 0..10_000 {
        let words = [0; 6].map(|_| random.within(most));
        let codes = [0; 3].map(|_| (random.word() >> 62) as i64);
        let turn = Turn { words, codes, angles: [0; 3].map(|_| (random.word() >> 48) as i64) };
        let (got, truth) = (circuit.run(&turn.inputs()), turn.exact());
        if let Some(fits) = fits(truth.as_flattened(), 2.0) {
            assert_eq!(got.is_some(), fits, "{turn:?}: {truth:?}");
        }
        match got {
            Some(got) => worst = worst.max(deviation(&got, &truth[2])),
            None => refused += 1,
        }
    }
    (worst, refused)
}

#[test]
fn ten_thousand_turns_in_any_order_are_right_to_two_counts_and_documented() {
    let mut rows = Vec::new();
    for most in [4095, 32767] {
        let (worst, refused) = worst_of_ten_thousand(most);
        assert!(worst <= 2.0, "{worst} up to {most}");
        rows.push(format!("| `fig20_rotation3d` | {most} | {worst:.4} | {refused} |"));
    }
    assert_documented(&rows.join("\n"));
}

#[test]
fn quarter_turns_are_exact_and_right_handed() {
    let mut circuit = shipped(&[]);
    let words = [1, 10, 2, 20, 3, 30];
    for (axis, expected) in [(1, [1, 10, -3, -30, 2, 20]), (2, [3, 30, 2, 20, -1, -10]), (3, [-2, -20, 1, 10, 3, 30])] {
        for place in 0..3 {
            let mut codes = [0; 3];
            codes[place] = axis;
            let turn = Turn { words, codes, angles: [1 << 14; 3] };
            assert_eq!(circuit.run(&turn.inputs()), Some(expected.to_vec()), "{turn:?}");
        }
    }
}

#[test]
fn state_one_loads_and_rotates_and_the_result_stands_at_638_in_state_three() {
    let nets = ["state_614", "lines_616", "load_618", "j_612", "j_618", "j_638", "combine"];
    let mut circuit = shipped(&nets);
    let turn = Turn { words: [1000, 0, 0, 0, 0, 0], codes: [3, 2, 1], angles: [0x2000; 3] };
    circuit.start(&turn.inputs());
    let read = |circuit: &Transformer, net| circuit.machine.get_signed(net);
    assert_eq!((read(&circuit, "j_618"), circuit.machine.get("state_614")), (1000, 0), "loaded in the first state");
    let (mut states, mut loads) = (Vec::new(), Vec::new());
    while circuit.machine.get("done") == 0 {
        if circuit.machine.get("combine") == 1 {
            states.push([circuit.machine.get("state_614"), circuit.machine.get("lines_616")]);
        }
        if circuit.machine.get("load_618") == 1 {
            loads.push([read(&circuit, "j_612"), read(&circuit, "j_638")]);
        }
        circuit.machine.tick();
    }
    assert_eq!(states, [[0, 0b1000], [1, 0b0100], [2, 0b0010]], "each state opens its gate");
    assert_eq!(loads, [[707, 707], [500, 500]], "612 connects 638 in the later states");
    assert_eq!((read(&circuit, "j_638"), read(&circuit, "j_out")), (500, 500));
}

#[test]
fn a_word_that_leaves_its_bits_on_the_way_is_an_error_to_the_end() {
    let mut circuit = shipped(&[]);
    let bad = Turn { words: [30_000, 0, -30_000, 0, 0, 0], codes: [3, 3, 3], angles: [0, 0, 0x2000] };
    assert_eq!(circuit.run(&bad.inputs()), None);
    let good = Turn { words: [7, 6, 5, 4, 3, 2], codes: [0; 3], angles: [0; 3] };
    assert_eq!(circuit.run(&good.inputs()), Some(good.words.to_vec()), "the next start is free of it");
}
