//! FIG. 13: the eight maps, the controls, and the ends of the words.

use super::machine::{Machine, Random};
use super::vectors::{numbers, read};

const CONTROLS: [&str; 8] = [
    "control_450",
    "control_452",
    "control_454",
    "control_456",
    "control_458",
    "control_460",
    "control_462",
    "control_464",
];

/// J, K, L, M.
type Coefficients = [i64; 4];

struct Matrix(Machine);

impl Matrix {
    fn shipped() -> Self {
        Self(Machine::shipped("us3809868/fig13_quarter_turns", &[]))
    }

    /// The result with these controls closed, bit 0 for 450; `None` with an error, when all must be 0.
    fn map(&mut self, controls: usize, [j, k, l, m]: Coefficients) -> Option<Coefficients> {
        let closed: Vec<_> = (0..).zip(CONTROLS).map(|(bit, name)| (name, (controls >> bit & 1) as i64)).collect();
        self.0.set(&closed);
        self.0.set(&[("j", j), ("k", k), ("l", l), ("m", m)]);
        let words = ["j_out", "k_out", "l_out", "m_out"].map(|output| self.0.get_signed(output));
        let error = self.0.get("error") == 1;
        assert!(!error || words == [0; 4], "nothing comes out with an error: {words:?}");
        (!error).then_some(words)
    }
}

/// The map of each control as the reading's vectors have it: for 1, 2, 3, 4 the number and the sign of what comes out.
fn maps() -> Vec<Vec<i64>> {
    let file = read("fig13_qturn.json");
    let maps = CONTROLS.map(|control| &file["maps"][control.trim_start_matches("control_")]);
    assert!(maps.iter().all(|map| numbers(&map["example_in"]) == [1, 2, 3, 4]));
    maps.iter().map(|map| numbers(&map["out"])).collect()
}

#[test]
fn every_control_makes_its_map_of_any_coefficients() {
    let mut matrix = Matrix::shipped();
    let mut random = Random(13);
    for (control, map) in maps().into_iter().enumerate() {
        for round in 0..500 {
            let words = if round == 0 { [32767, -32767, 0, 1] } else { [0; 4].map(|_| random.within(32767)) };
            let expected = [0, 1, 2, 3].map(|i: usize| map[i].signum() * words[map[i].unsigned_abs() as usize - 1]);
            assert_eq!(matrix.map(1 << control, words), Some(expected), "{}", CONTROLS[control]);
        }
    }
}

#[test]
fn a_map_moves_the_end_of_the_stroke_as_the_vectors_move_a_point() {
    let mut matrix = Matrix::shipped();
    let file = read("fig13_qturn.json");
    for (control, name) in CONTROLS.into_iter().enumerate() {
        let point = &file["maps"][name.trim_start_matches("control_")]["P_point(1,2)"];
        let [j, k, l, m] = matrix.map(1 << control, [3, 4, -5, -3]).expect("small");
        assert_eq!(vec![k - j, m - l], numbers(point), "{name}");
    }
}

#[test]
fn two_quarter_turns_are_a_half_turn_and_every_reflection_undoes_itself() {
    let mut matrix = Matrix::shipped();
    let words = [101, -202, 303, -404];
    let mut twice = |first: usize, second: usize| {
        let once = matrix.map(1 << first, words).expect("small");
        matrix.map(1 << second, once).expect("small")
    };
    let [j, k, l, m] = words;
    assert_eq!((twice(0, 0), twice(2, 2)), ([-j, -k, -l, -m], [-j, -k, -l, -m]));
    assert_eq!((twice(0, 2), twice(1, 1)), (words, words));
    for (reflection, name) in CONTROLS.iter().enumerate().skip(3) {
        assert_eq!(twice(reflection, reflection), words, "{name}");
    }
}

#[test]
fn no_control_or_several_are_an_error() {
    let mut matrix = Matrix::shipped();
    for controls in 0..256_usize {
        let single = controls.count_ones() == 1;
        assert_eq!(matrix.map(controls, [1, 2, 3, 4]).is_some(), single, "{controls:08b}");
    }
}

#[test]
fn the_least_word_is_an_error_just_where_its_negative_would_come_out() {
    let mut matrix = Matrix::shipped();
    for least in 0..4 {
        let mut words = [7; 4];
        words[least] = -32768;
        for (control, map) in maps().into_iter().enumerate() {
            let negated = map.contains(&-(least as i64 + 1));
            assert_eq!(matrix.map(1 << control, words).is_none(), negated, "{} of {words:?}", CONTROLS[control]);
        }
    }
}
