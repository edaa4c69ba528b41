//! The reference: what the patent's formulas (with errata) give in f64 for the words the hardware sees.

/// Fraction bits of a slope.
const SLOPE_ONE: f64 = (1 << 18) as f64;

/// What goes into a converter: points in whole counts, slopes in units of 2^-18.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Data {
    /// Input port and word.
    pub words: Vec<(String, i64)>,
}

impl Data {
    /// Rounds real points and slopes to words.
    pub fn rounded<'a>(entries: impl IntoIterator<Item = (&'a str, f64)>) -> Self {
        let word = |(name, value): (&str, f64)| {
            let name = name.to_lowercase();
            let unit = if name.starts_with('s') { SLOPE_ONE } else { 1.0 };
            (name, (value * unit).round() as i64)
        };
        Data { words: entries.into_iter().map(word).collect() }
    }

    /// The number that the word of a port stands for.
    fn real(&self, port: &str) -> f64 {
        let word = self.words.iter().find(|(name, _)| name == port).unwrap_or_else(|| panic!("no {port}")).1 as f64;
        if port.starts_with('s') { word / SLOPE_ONE } else { word }
    }

    /// X and Y from one point to another.
    fn between(&self, from: char, to: char) -> (f64, f64) {
        let along = |axis: char| self.real(&format!("{axis}{to}")) - self.real(&format!("{axis}{from}"));
        (along('x'), along('y'))
    }

    /// X1 and Y1.
    pub fn end(&self) -> (i64, i64) {
        (self.real("x1") as i64, self.real("y1") as i64)
    }

    /// X1 - X0 and Y1 - Y0, exactly.
    pub fn chord(&self) -> (i64, i64) {
        let (a, b) = self.between('0', '1');
        (a as i64, b as i64)
    }
}

/// J, K, L, M of a case, or `None` where the formula has no answer.
pub fn coefficients(case: usize, data: &Data) -> Option<[f64; 4]> {
    let (a, b) = data.between('0', '1');
    let result = match case {
        1 => case_1(a, b, data.real("s0"), data.real("s1")),
        2 => case_2(a, b, data.between('3', '1'), data.real("s0"))?,
        3 => case_3(a, b, data.between('0', '3'), data.real("s1"))?,
        4 => case_4(a, b, data.between('0', '3'), data.between('1', '3'), data.real("s3"))?,
        _ => case_5(a, b, data.between('0', '2')),
    };
    result.iter().all(|value| value.is_finite()).then_some(result)
}

fn case_1(a: f64, b: f64, s0: f64, s1: f64) -> [f64; 4] {
    let j = (s0 * a - b) / (s1 - s0);
    [j, j + a, s1 * j, s1 * j + b]
}

fn case_2(a: f64, b: f64, (c, d): (f64, f64), s0: f64) -> Option<[f64; 4]> {
    let e = (s0 * c - d) / (s0 * a - b);
    let f = other_leg(e)?;
    let k = (a * e - c) / (e + f - 1.0);
    Some([k - a, k, s0 * k - b, s0 * k])
}

fn case_3(a: f64, b: f64, (c, d): (f64, f64), s1: f64) -> Option<[f64; 4]> {
    let e = (s1 * c - d) / (s1 * a - b);
    let f = other_leg(e)?;
    let k = ((c - a) + a * f) / (e + f - 1.0);
    let j = k - a;
    Some([j, k, s1 * j, s1 * j + b])
}

fn case_4(a: f64, b: f64, (c, d): (f64, f64), (h, i): (f64, f64), s3: f64) -> Option<[f64; 4]> {
    let g = (s3 * c - d) / (s3 * h - i);
    if g.is_nan() || g <= 0.0 {
        return None;
    }
    let e = (1.0 + g * ((2.0 * g).sqrt() - 1.0)) / (1.0 + g * g);
    let f = other_leg(e)?;
    let (j, l) = ((c - a * f) / (e + f - 1.0), (d - b * f) / (e + f - 1.0));
    Some([j, j + a, l, l + b])
}

fn case_5(a: f64, b: f64, (c, d): (f64, f64)) -> [f64; 4] {
    let (r, t) = (0.5_f64.sqrt(), 1.0 / (2.0_f64.sqrt() - 1.0));
    let (j, l) = ((c - a * r) * t, (d - b * r) * t);
    [j, j + a, l, l + b]
}

/// sqrt(1 - e^2) for 0 < e < 1.
fn other_leg(e: f64) -> Option<f64> {
    (0.0 < e && e < 1.0).then(|| (1.0 - e * e).sqrt())
}
