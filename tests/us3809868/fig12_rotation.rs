//! FIG. 12 against the rotation of a point in f64, and what FIG. 9 draws with it.

use std::f64::consts::TAU;

use super::machine::{Machine, Random, SMALL, Stroke, draw};
use super::transform::{Transformer, angle_word, assert_documented, deviation, fits};
use super::vectors::{list, read, real, reals};

/// J, K, L, M.
type Coefficients = [i64; 4];

struct Rotation(Transformer);

impl Rotation {
    fn shipped(nets: &[&str]) -> Self {
        Self(Transformer::shipped("fig12_rotation", &["j_out", "k_out", "l_out", "m_out"], nets))
    }

    fn turn(&mut self, [j, k, l, m]: Coefficients, angle: i64) -> Option<Vec<i64>> {
        self.0.run(&[("angle_410", angle), ("j", j), ("k", k), ("l", l), ("m", m)])
    }
}

/// (J, L) and (K, M) turned as points of the plane.
fn turned([j, k, l, m]: [f64; 4], radians: f64) -> [f64; 4] {
    let (sine, cosine) = radians.sin_cos();
    [j * cosine - l * sine, k * cosine - m * sine, j * sine + l * cosine, k * sine + m * cosine]
}

fn exact(jklm: Coefficients, angle: i64) -> [f64; 4] {
    turned(jklm.map(|value| value as f64), angle as f64 / 65536.0 * TAU)
}

#[test]
fn every_vector_of_the_reading_comes_out_within_a_count() {
    let mut rotation = Rotation::shipped(&[]);
    let file = read("fig12_rotate.json");
    for entry in list(&file["rotate"]) {
        let coefficients: [f64; 4] = reals(&entry["p"]).try_into().expect("four");
        let radians = real(&entry["theta"]);
        let truth = turned(coefficients, radians);
        assert!(truth.iter().zip(reals(&entry["out"])).all(|(ours, theirs)| (ours - theirs).abs() < 1e-9));

        let words = coefficients.map(|value| value.round() as i64);
        let (angle, _) = angle_word(radians);
        let got = rotation.turn(words, angle).expect("small");
        assert!(deviation(&got, &exact(words, angle)) <= 1.0, "{words:?} by {angle}: {got:?}");
        // Whole inputs may be half a count off in each of two terms, the angle half a unit.
        assert!(deviation(&got, &truth) <= 1.3, "{entry}: {got:?}");
    }
}

/// The worst deviation of 10,000 random rotations that fit; errors must be just those that do not.
fn worst_of_ten_thousand(most: i64) -> (f64, u32) {
    let mut rotation = Rotation::shipped(&[]);
    let mut random = Random(most as u64);
    let (mut worst, mut refused) = (0.0_f64, 0);
    for _ in 0..10_000 {
        let (words, angle) = ([0; 4].map(|_| random.within(most)), (random.word() >> 48) as i64);
        let (got, truth) = (rotation.turn(words, angle), exact(words, angle));
        if let Some(fits) = fits(&truth, 0.6) {
            assert_eq!(got.is_some(), fits, "{words:?} by {angle}: {truth:?}");
        }
        match got {
            Some(got) => worst = worst.max(deviation(&got, &truth)),
            None => refused += 1,
        }
    }
    (worst, refused)
}

#[test]
fn ten_thousand_rotations_are_right_to_the_count_and_documented() {
    let mut rows = Vec::new();
    for most in [4095, 32767] {
        let (worst, refused) = worst_of_ten_thousand(most);
        assert!(worst <= 0.53, "{worst} up to {most}");
        rows.push(format!("| `fig12_rotation` | {most} | {worst:.4} | {refused} |"));
    }
    assert_documented(&rows.join("\n"));
}

#[test]
fn sine_and_cosine_of_all_angles_are_as_near_as_documented() {
    let mut rotation = Rotation::shipped(&["cosine_412", "sine_414"]);
    let [cosine, sine] = ["cosine_412", "sine_414"].map(|net| rotation.0.machine.find(net));
    let mut worst = [0.0_f64; 2];
    for angle in 0..1 << 16 {
        rotation.turn([0; 4], angle);
        let (true_sine, true_cosine) = (angle as f64 / 65536.0 * TAU).sin_cos();
        for (worst, (place, truth)) in worst.iter_mut().zip([(cosine, true_cosine), (sine, true_sine)]) {
            let value = rotation.0.machine.number(place) as f64 / f64::from(1 << 24);
            *worst = worst.max((value - truth).abs());
        }
    }
    assert_documented(&format!("412: {:.2e}, 414: {:.2e}", worst[0], worst[1]));
}

#[test]
fn angle_zero_and_quarter_turns_are_exact_at_the_ends_of_the_words() {
    let mut rotation = Rotation::shipped(&[]);
    for [j, k, l, m] in [[32767, -32767, 1, -1], [-32768, 5, 0, 32767], [0, 0, -32768, -32768], [12, 345, -678, 9]] {
        let quarters = [[j, k, l, m], [-l, -m, j, k], [-j, -k, -l, -m], [l, m, -j, -k]];
        for (quarter, expected) in (0..).zip(quarters) {
            let expected = expected.iter().all(|word| *word <= 32767).then_some(expected.to_vec());
            assert_eq!(rotation.turn([j, k, l, m], quarter << 14), expected, "{quarter} quarter turns");
        }
    }
}

#[test]
fn half_a_turn_more_changes_just_the_signs() {
    let mut rotation = Rotation::shipped(&[]);
    let mut random = Random(12);
    for _ in 0..1000 {
        let (words, angle) = ([0; 4].map(|_| random.within(20_000)), (random.word() >> 49) as i64);
        let opposite = rotation.turn(words, angle + (1 << 15)).map(|got| got.iter().map(|word| -word).collect());
        assert_eq!(rotation.turn(words, angle), opposite, "{words:?} by {angle}");
    }
}

#[test]
fn the_drawn_end_of_a_turned_stroke_is_the_turned_end_of_the_drawn_stroke() {
    let mut rotation = Rotation::shipped(&[]);
    let mut generator = Machine::shipped("us3809868/fig09_function_generator", SMALL);
    let mut random = Random(9);
    for _ in 0..40 {
        let stroke = random.stroke(350);
        let angle = (random.word() >> 48) as i64;
        let jklm = rotation.turn(stroke.jklm, angle).expect("small").try_into().expect("four");
        let [x0, y0] = stroke.from;
        let drawn = draw(&mut generator, &stroke).end;
        let (x, y) = ((drawn[0] - x0) as f64, (drawn[1] - y0) as f64);
        let [x, _, y, _] = turned([x, 0.0, y, 0.0], angle as f64 / 65536.0 * TAU);
        let end = draw(&mut generator, &Stroke { jklm, ..stroke }).end;
        let off = deviation(&end, &[x0 as f64 + x, y0 as f64 + y]);
        assert!(off <= 2.0, "{stroke:?} by {angle}: {off} counts");
    }
}
