//! The five conversions in real numbers, as the patent's equations have them once their errata are mended.

use std::f64::consts::{FRAC_1_SQRT_2, SQRT_2};

use super::{Curve, Point, Refusal};

/// What is known of a stroke of one quarter besides its ends P0 and P1. A slope is dY/dX; a vertical tangent has none.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Case {
    /// The slopes at both ends.
    I {
        /// At P0.
        s0: f64,
        /// At P1.
        s1: f64,
    },
    /// A point between and the slope at P0.
    II {
        /// The point.
        p3: Point,
        /// The slope at P0.
        s0: f64,
    },
    /// A point between and the slope at P1.
    III {
        /// The point.
        p3: Point,
        /// The slope at P1.
        s1: f64,
    },
    /// A point between and the slope there.
    IV {
        /// The point.
        p3: Point,
        /// The slope at it.
        s3: f64,
    },
    /// The point farthest from the chord.
    V {
        /// The point.
        p2: Point,
    },
}

fn less(a: Point, b: Point) -> Point {
    [a[0] - b[0], a[1] - b[1]]
}

/// Whether E is strictly between 0 and 1: at both ends E + F - 1 is 0, which the patent divides by.
fn is_inside(e: f64) -> bool {
    e > 0.0 && e < 1.0
}

impl Case {
    /// The stroke from P0 to P1. Data that nearly have no solution give coefficients beyond any register, which
    /// [`Curve::words`] refuses.
    ///
    /// # Errors
    /// The data of the case have no solution: [`Refusal::Vertical`], [`Refusal::EqualSlopes`], [`Refusal::Inflection`],
    /// [`Refusal::Tangent`].
    pub fn curve(self, p0: Point, p1: Point) -> Result<Curve, Refusal> {
        if self.slopes().iter().any(|slope| !slope.is_finite()) {
            return Err(Refusal::Vertical);
        }
        let [a, b] = less(p1, p0);
        let jklm = match self {
            Self::I { s0, s1 } => {
                if s0 == s1 {
                    return Err(Refusal::EqualSlopes);
                }
                let j = (s0 * a - b) / (s1 - s0);
                let l = s1 * j;
                [j, a + j, l, b + l]
            }
            Self::II { p3, s0 } => {
                let found = CaseTwo::of(p0, p1, p3, s0);
                return if found.is_good() { Ok(found.curve()) } else { Err(found.refusal()) };
            }
            Self::III { p3, s1 } => case_3([a, b], less(p3, p0), less(p3, p1), s1)?,
            Self::IV { p3, s3 } => case_4([a, b], less(p3, p0), less(p3, p1), s3)?,
            Self::V { p2 } => {
                // R = 1/sqrt 2 and T = sqrt 2 + 1: the tangent at P2 is parallel to the chord, so that t = pi/4 there.
                let [c, d] = less(p2, p0);
                let [j, l] = [(c, a), (d, b)].map(|(point, end)| (point - end * FRAC_1_SQRT_2) * (SQRT_2 + 1.0));
                [j, j + a, l, l + b]
            }
        };
        Ok(Curve { from: p0, jklm, quarters: 1 })
    }

    fn slopes(&self) -> [f64; 2] {
        match *self {
            Self::I { s0, s1 } => [s0, s1],
            Self::II { s0: slope, .. } | Self::III { s1: slope, .. } | Self::IV { s3: slope, .. } => [slope, 0.0],
            Self::V { .. } => [0.0, 0.0],
        }
    }
}

fn case_3([a, b]: Point, [c, d]: Point, [h, _]: Point, s1: f64) -> Result<[f64; 4], Refusal> {
    let e = (s1 * c - d) / (s1 * a - b);
    if !is_inside(e) {
        return Err(Refusal::Inflection { e });
    }
    let f = (1.0 - e * e).sqrt();
    let k = (h + a * f) / (e + f - 1.0);
    let j = k - a;
    let l = s1 * j;
    Ok([j, k, l, l + b])
}

fn case_4([a, b]: Point, [c, d]: Point, [h, i]: Point, s3: f64) -> Result<[f64; 4], Refusal> {
    let g = (s3 * c - d) / (s3 * h - i);
    if !(g > 0.0 && g.is_finite()) {
        return Err(Refusal::Tangent { g });
    }
    let e = (1.0 + g * ((2.0 * g).sqrt() - 1.0)) / (1.0 + g * g);
    let f = (1.0 - e * e).sqrt();
    let [j, l] = [(c, a), (d, b)].map(|(point, end)| (point - end * f) / (e + f - 1.0));
    Ok([j, j + a, l, l + b])
}

/// Case II as FIG. 19 computes it: A to E in operation 584, tested in 586, F and J to M in 588.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct CaseTwo {
    p0: Point,
    pub(super) p1: Point,
    s0: f64,
    /// X1 - X0.
    pub a: f64,
    /// Y1 - Y0.
    pub b: f64,
    /// X1 - X3.
    pub c: f64,
    /// Y1 - Y3.
    pub d: f64,
    /// cos t3 = (S0 C - D)/(S0 A - B); the patent prints S1 for the second S0, which is no input of this case.
    pub e: f64,
}

impl CaseTwo {
    /// Operation 584.
    #[must_use]
    pub fn of(p0: Point, p1: Point, p3: Point, s0: f64) -> Self {
        let ([a, b], [c, d]) = (less(p1, p0), less(p1, p3));
        Self { p0, p1, s0, a, b, c, d, e: (s0 * c - d) / (s0 * a - b) }
    }

    /// Test 586: whether 0 < E < 1.
    #[must_use]
    pub fn is_good(&self) -> bool {
        is_inside(self.e)
    }

    /// Why E is not good.
    pub(super) fn refusal(&self) -> Refusal {
        if self.s0.is_finite() { Refusal::Inflection { e: self.e } } else { Refusal::Vertical }
    }

    /// F = sin t3, of operation 588.
    #[must_use]
    pub fn f(&self) -> f64 {
        (1.0 - self.e * self.e).sqrt()
    }

    /// J, K, L, M of operation 588; of worth only when E is good.
    #[must_use]
    pub fn curve(&self) -> Curve {
        let k = (self.a * self.e - self.c) / (self.e + self.f() - 1.0);
        let m = self.s0 * k;
        Curve { from: self.p0, jklm: [k - self.a, k, m - self.b, m], quarters: 1 }
    }
}
