//! A stroke in real numbers: what the computer finds before it is formatted for the registers.

use super::{LARGEST, Refusal, Stroke};

/// X and Y, in counts.
pub type Point = [f64; 2];

/// X(t) = J (cos t - 1) + K sin t + X0, Y(t) = L (cos t - 1) + M sin t + Y0, in counts, over some quarters from t = 0 on.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Curve {
    /// X0, Y0.
    pub from: Point,
    /// J, K, L, M.
    pub jklm: [f64; 4],
    /// 1 to 4 quarters of an ellipse: ITYPE of Appendix A.
    pub quarters: u8,
}

impl Curve {
    /// A circle as CIRCLE of Appendix A has it: from its leftmost point on, clockwise.
    #[must_use]
    pub fn circle([x, y]: Point, radius: f64) -> Self {
        Self { from: [x - radius, y], jklm: [-radius, 0.0, 0.0, radius], quarters: 4 }
    }

    /// Half a circle as SEMI of Appendix A has it: J and L are fixed by the end, K and M by the way round.
    #[must_use]
    pub fn half_circle(from: Point, to: Point, counter_clockwise: bool) -> Self {
        let [a, b] = [0, 1].map(|axis| (to[axis] - from[axis]) / 2.0);
        let [k, m] = if counter_clockwise { [b, -a] } else { [-b, a] };
        Self { from, jklm: [-a, k, -b, m], quarters: 2 }
    }

    /// The point at `t`, in radians.
    #[must_use]
    pub fn at(&self, t: f64) -> Point {
        let ([j, k, l, m], (sine, cosine)) = (self.jklm, t.sin_cos());
        [j * (cosine - 1.0) + k * sine + self.from[0], l * (cosine - 1.0) + m * sine + self.from[1]]
    }

    /// Where it ends; exact at the ends of quarters.
    #[must_use]
    pub fn end(&self) -> Point {
        let [j, k, l, m] = self.jklm;
        let end = |from, cosine, sine| match self.quarters {
            1 => from - cosine + sine,
            2 => from - 2.0 * cosine,
            3 => from - cosine - sine,
            _ => from,
        };
        [end(self.from[0], j, k), end(self.from[1], l, m)]
    }

    /// The direction in which it leaves, (K, M); its length is the velocity in counts per radian.
    #[must_use]
    pub fn leaves(&self) -> [f64; 2] {
        let [_, k, _, m] = self.jklm;
        [k, m]
    }

    /// The direction in which it arrives: (-J, -L) after one quarter. That is why the slope of its end is L/J.
    #[must_use]
    pub fn arrives(&self) -> [f64; 2] {
        let [j, k, l, m] = self.jklm;
        match self.quarters {
            1 => [-j, -l],
            2 => [-k, -m],
            3 => [j, l],
            _ => [k, m],
        }
    }

    /// Operation 590, the format of registers 556 to 566: whole counts, halves away from zero.
    ///
    /// Of J and K only J is rounded, and K follows from the rounded points, so that the stroke ends just on the nearest
    /// count to its end, and a chain of them has no gaps (chosen: the text has "known formatting techniques"). Two or
    /// four quarters end without K, so that K is rounded as well.
    ///
    /// # Errors
    /// [`Refusal::TooLarge`]: a coordinate leaves its 16 bits, a coefficient the generator's 12, or is no number.
    pub fn words(&self) -> Result<Stroke, Refusal> {
        let [from, end] = [self.from, self.end()].map(|point| point.map(f64::round));
        let [j, k, l, m] = self.jklm.map(f64::round);
        let partner = |cosine: f64, sine: f64, axis: usize| match self.quarters {
            1 => cosine + end[axis] - from[axis],
            3 => from[axis] - end[axis] - cosine,
            _ => sine,
        };
        let coordinates = ["X0", "Y0", "X1", "Y1"].into_iter().zip([from, end].concat());
        let coefficients = [j, partner(j, k, 0), l, partner(l, m, 1)];
        fits(coordinates, f64::from(i16::MIN), f64::from(i16::MAX))?;
        let largest = f64::from(LARGEST);
        fits(["J", "K", "L", "M"].into_iter().zip(coefficients), -largest, largest)?;
        let word = |value: f64| value as i16;
        Ok(Stroke { from: from.map(word), jklm: coefficients.map(word), quarters: self.quarters, pen: true })
    }
}

/// Whether all words are in their range; no number is in none.
fn fits(words: impl Iterator<Item = (&'static str, f64)>, low: f64, high: f64) -> Result<(), Refusal> {
    let mut wrong = words.filter(|(_, value)| !(low..=high).contains(value));
    wrong.next().map_or(Ok(()), |(word, value)| Err(Refusal::TooLarge { word, value, low, high }))
}
