//! How far the path of FIG. 9 is from the ideal ellipse.

use std::f64::consts::FRAC_PI_2;

use super::machine::{Drawn, Machine, Parameters, Random, Stroke, draw};

const CIRCUIT: &str = "us3809868/fig09_function_generator";

/// The greatest distance on either axis from the ideal point of the same time, over the stroke, judged at the end of
/// each clock.
fn deviation(stroke: &Stroke, drawn: &Drawn) -> f64 {
    let [j, k, l, m] = stroke.jklm.map(|c| c as f64);
    let [x0, y0] = stroke.from.map(|c| c as f64);
    let total = drawn.path.len() as f64 / stroke.quarters as f64;
    let mut worst = 0.0_f64;
    for (i, [x, y]) in drawn.path.iter().enumerate().skip(1).step_by(2) {
        let t = (i + 1) as f64 / total * FRAC_PI_2;
        let dx = *x as f64 - (j * (t.cos() - 1.0) + k * t.sin() + x0);
        let dy = *y as f64 - (l * (t.cos() - 1.0) + m * t.sin() + y0);
        worst = worst.max(dx.abs()).max(dy.abs());
    }
    worst
}

/// The greatest and the median deviation of so many random strokes.
fn survey(parameters: Parameters, range: i64, strokes: usize) -> (f64, f64) {
    let mut machine = Machine::shipped(CIRCUIT, parameters);
    let mut random = Random(3_809_868 + range as u64);
    let mut all: Vec<f64> = (0..strokes)
        .map(|_| {
            let stroke = Stroke { quarters: 1, ..random.stroke(range) };
            deviation(&stroke, &draw(&mut machine, &stroke))
        })
        .collect();
    all.sort_by(f64::total_cmp);
    let (most, median) = (all[all.len() - 1], all[all.len() / 2]);
    println!("{parameters:?}, coefficients up to {range}: {strokes} strokes, deviation {most:.2}, median {median:.2}");
    (most, median)
}

/// The bound of the reading: two terms an axis of (3n+7)/18 each, and the outer multiplier's jitter.
fn bound(bits: f64, range: f64) -> f64 {
    2.0 * (3.0 * bits + 7.0) / 18.0 + 1.97 * 2.0 * range / bits.exp2()
}

#[test]
fn twelve_bit_paths_stay_within_the_bound_and_near_the_guide_values() {
    for (range, guide, median_guide) in [(512, 3.5, 2.6), (2048, 4.5, 3.3), (4095, 6.0, 4.1)] {
        let (most, median) = survey(&[], range, 16);
        assert!(most <= bound(12.0, range as f64), "{most} for {range}");
        assert!(most <= guide, "{most} for {range}");
        assert!(median <= median_guide, "{median} for {range}");
    }
}

#[test]
fn guard_stages_bring_the_path_within_about_one_count() {
    for (guard, guide) in [(1, 2.2), (2, 1.5), (3, 1.2)] {
        let (most, _) = survey(&[("GUARD", guard)], 511, 12);
        assert!(most <= guide, "{most} with {guard} guard stages");
    }
}
