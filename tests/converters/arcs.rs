//! Random arcs: well-conditioned data for each case, by the thousand.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

use super::Data;
use super::formulas::coefficients;

/// Numbers from a seed (SplitMix64).
pub struct Numbers(pub u64);

impl Numbers {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// A real number between two others.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (self.next() >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// The data of the next arc of a case, and what the formula makes of the rounded words: t3 between 0.12 and 1.45,
/// slopes and coordinates within their words, |J..M| up to 4095.
pub fn next_arc(case: usize, numbers: &mut Numbers) -> (Data, [f64; 4]) {
    loop {
        let size = [64.0, 512.0, 2048.0, 4095.0][(numbers.next() % 4) as usize];
        let jklm = [(); 4].map(|()| numbers.between(-size, size));
        let start = [(); 2].map(|()| numbers.between(-4000.0, 4000.0).round());
        let t3 = if case == 5 { FRAC_PI_4 } else { numbers.between(0.12, 1.45) };
        let area = jklm[0] * jklm[3] - jklm[1] * jklm[2];
        let Some(data) = arc_data(case, jklm, start, t3).filter(|_| area.abs() > 0.02 * size * size) else { continue };
        match coefficients(case, &data) {
            Some(truth) if truth.iter().all(|value| value.abs() <= 4095.0) => return (data, truth),
            _ => {}
        }
    }
}

fn arc_data(case: usize, [j, k, l, m]: [f64; 4], [x0, y0]: [f64; 2], t3: f64) -> Option<Data> {
    let point = |t: f64| (x0 + j * (t.cos() - 1.0) + k * t.sin(), y0 + l * (t.cos() - 1.0) + m * t.sin());
    let ((x1, y1), (x3, y3)) = (point(FRAC_PI_2), point(t3));
    let (s0, s1) = (m / k, l / j);
    let s3 = (m * t3.cos() - l * t3.sin()) / (k * t3.cos() - j * t3.sin());
    let extra: &[(&str, f64)] = match case {
        1 => &[("s0", s0), ("s1", s1)],
        2 => &[("x3", x3), ("y3", y3), ("s0", s0)],
        3 => &[("x3", x3), ("y3", y3), ("s1", s1)],
        4 => &[("x3", x3), ("y3", y3), ("s3", s3)],
        _ => &[("x2", x3), ("y2", y3)],
    };
    let fits = extra.iter().all(|(name, value)| !name.starts_with('s') || value.abs() < 8000.0);
    let ends = [("x0", x0), ("y0", y0), ("x1", x1), ("y1", y1)];
    fits.then(|| Data::rounded(ends.into_iter().chain(extra.iter().copied())))
}
