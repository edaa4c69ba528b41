//! Curves without corners, by one parameter.

use kurbo::{BezPath, CubicBez, ParamCurve, ParamCurveDeriv, PathSeg, Point, Vec2};

/// Directions that differ by more than this, in radians, make a corner.
const CORNER: f64 = 0.02;

/// A curve without corners: pieces one after the other, piece `i` from parameter `i` to `i + 1`.
#[derive(Clone, Debug)]
pub(super) struct Smooth {
    pieces: Vec<CubicBez>,
}

impl Smooth {
    /// The curves that a path consists of between its corners, in its order.
    pub fn of(path: &BezPath) -> Vec<Self> {
        let mut all: Vec<Self> = Vec::new();
        for piece in path
            .segments()
            .map(cubic)
            .filter(|piece| (piece.p3 - piece.p0).hypot() + (piece.p2 - piece.p1).hypot() > 1e-9)
        {
            let goes_on = all.last().is_some_and(|last| {
                let before = last.direction(last.end());
                let after = Self { pieces: vec![piece] }.direction(0.0);
                last.at(last.end()).distance(piece.p0) < 1e-9
                    && before.cross(after).atan2(before.dot(after)).abs() < CORNER
            });
            match all.last_mut().filter(|_| goes_on) {
                Some(last) => last.pieces.push(piece),
                None => all.push(Self { pieces: vec![piece] }),
            }
        }
        all
    }

    /// The parameter of its end.
    pub fn end(&self) -> f64 {
        self.pieces.len() as f64
    }

    fn piece(&self, s: f64) -> (&CubicBez, f64) {
        let at = (s.max(0.0) as usize).min(self.pieces.len() - 1);
        (&self.pieces[at], (s - at as f64).clamp(0.0, 1.0))
    }

    pub fn at(&self, s: f64) -> Point {
        let (piece, t) = self.piece(s);
        piece.eval(t)
    }

    fn derivative(&self, s: f64) -> Vec2 {
        let (piece, t) = self.piece(s);
        piece.deriv().eval(t).to_vec2()
    }

    /// The direction, of length 1; where the parameter stands still that of the way nearby.
    pub fn direction(&self, s: f64) -> Vec2 {
        let (piece, t) = self.piece(s);
        let derivative = self.derivative(s);
        let way = [1e-4, 1e-2, 1.0].map(|near| piece.eval((t + near).min(1.0)) - piece.eval((t - near).max(0.0)));
        let long = |way: &Vec2| way.hypot() > 1e-12;
        let found = Some(derivative).filter(|d| d.hypot() > 1e-6).or_else(|| way.into_iter().find(long));
        found.map_or(Vec2::new(1.0, 0.0), Vec2::normalize)
    }

    /// The parameter, between `from` and `to`, of the point near `guess` that is nearest to `point`.
    pub fn nearest(&self, point: Point, guess: f64, from: f64, to: f64) -> f64 {
        let mut s = guess.clamp(from, to);
        for _ in 0..8 {
            let (way, derivative) = (self.at(s) - point, self.derivative(s));
            let square = derivative.hypot2();
            if square < 1e-12 {
                s = (s + 1e-3).min(to);
                continue;
            }
            // Not more than half a piece at once, so that it stays near the guess.
            let next = (s - (way.dot(derivative) / square).clamp(-0.5, 0.5)).clamp(from, to);
            if (next - s).abs() < 1e-7 {
                return next;
            }
            s = next;
        }
        s
    }
}

/// A piece as a cubic whose parameter moves evenly where the piece is straight.
fn cubic(piece: PathSeg) -> CubicBez {
    match piece {
        PathSeg::Line(line) => CubicBez::new(line.p0, line.eval(1.0 / 3.0), line.eval(2.0 / 3.0), line.p1),
        PathSeg::Quad(quad) => quad.raise(),
        PathSeg::Cubic(cubic) => cubic,
    }
}
