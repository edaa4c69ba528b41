//! Curves cut into strokes: quarter ellipses that share the curve's tangents at their ends.
//!
//! A quarter ellipse from P0 to P1 = P0 + u + v leaves along u and arrives along v; so the two tangents and the two ends
//! determine it. The ends are whole counts; u is rounded to whole counts, and v follows, so that the next stroke begins
//! just where this one ends.

use kurbo::{Point, Vec2};

use super::Sheet;
use super::smooth::Smooth;
use crate::host;

/// Points of a stroke that are held against the curve.
const SAMPLES: usize = 40;
/// How finely the longest stroke is sought, in steps of halving.
const HALVINGS: usize = 8;
/// How often the shortest length that is tried is halved before the way is taken straight.
const SHORTEST: usize = 10;

/// A stroke, and the part of the curve that it stands for.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Stroke {
    /// What the machine is told.
    pub words: host::Stroke,
    /// Which curve of the sheet it belongs to.
    pub curve: usize,
    /// Which of that curve's parts without a corner.
    pub(super) part: usize,
    /// Its parameters there.
    pub(super) range: [f64; 2],
}

/// The strokes of all curves, as few of them as stay within `tolerance` counts of the curve, in the order of drawing.
/// Where a curve is too small for that, such as a turn within a count, a stroke takes the straight way between counts.
#[must_use]
pub fn cut(sheet: &Sheet, tolerance: f64) -> Vec<Stroke> {
    let mut strokes = Vec::new();
    for (curve, path) in sheet.curves.iter().enumerate() {
        for (part, smooth) in Smooth::of(path).iter().enumerate() {
            let mut from = 0.0;
            while from < smooth.end() {
                let (to, words) = longest(smooth, from, tolerance);
                strokes.extend(words.map(|words| Stroke { words, curve, part, range: [from, to] }));
                from = to;
            }
        }
    }
    strokes
}

/// The longest stroke from a parameter on; no words where it would not leave its count.
///
/// A quarter ellipse fits an arc that is short, and one that turns by about a right angle, but few between them; so it
/// is the longest that is sought among lengths of all sizes, and then made a little longer.
fn longest(smooth: &Smooth, from: f64, tolerance: f64) -> (f64, Option<host::Stroke>) {
    let try_to = |to: f64| stroke(smooth, [from, to], tolerance);
    let mut bad = smooth.end();
    for to in candidates(from, smooth.end()) {
        if let Some(words) = try_to(to) {
            return lengthened((to, words), bad, try_to);
        }
        bad = to;
    }
    for _ in 0..SHORTEST {
        bad = (from + bad) / 2.0;
        if let Some(words) = try_to(bad) {
            return (bad, words);
        }
    }
    (bad, straight(whole(smooth.at(from)), whole(smooth.at(bad))))
}

/// Parameters where a stroke may end, the farthest first: ends of pieces, where a drawing program has begun a new arc;
/// parts of the rest; parts of a piece.
fn candidates(from: f64, end: f64) -> Vec<f64> {
    let pieces = (1..=16).map(|i| from.floor() + f64::from(i));
    let shares = (0..10).map(|i| from + (end - from) * 0.5f64.powi(i));
    let parts = (1..32).map(|i| from + f64::from(i) / 8.0);
    let mut all: Vec<_> = pieces.chain(shares).chain(parts).filter(|to| *to > from && *to <= end).collect();
    all.sort_by(|one, other| other.total_cmp(one));
    all.dedup();
    all
}

/// A stroke that is good made longer, short of an end that is bad.
fn lengthened<W>(mut good: (f64, W), mut bad: f64, try_to: impl Fn(f64) -> Option<W>) -> (f64, W) {
    if good.0.fract() == 0.0 {
        // The end of a piece: the next arc is to begin where its program began it.
        return good;
    }
    for _ in 0..HALVINGS {
        let middle = (good.0 + bad) / 2.0;
        match try_to(middle) {
            Some(words) => good = (middle, words),
            None => bad = middle,
        }
    }
    good
}

/// The stroke for a part of a curve, if one is within the tolerance; inside, none if it would not leave its count.
fn stroke(smooth: &Smooth, [from, to]: [f64; 2], tolerance: f64) -> Option<Option<host::Stroke>> {
    let [start, end] = [from, to].map(|s| whole(smooth.at(s)));
    let way = end - start;
    let (leaves, arrives) = (smooth.direction(from), smooth.direction(to));
    let turn = leaves.cross(arrives);
    let [along, across] = [way.cross(arrives) / turn, leaves.cross(way) / turn];
    let bent = (turn.abs() > 1e-3 && along > 0.0 && across > 0.0)
        .then(|| words(start, (leaves * along).round(), way))
        .flatten()
        .filter(|words| is_near(smooth, words, [from, to], tolerance));
    if let Some(words) = bent {
        return Some(Some(words));
    }
    if way == Vec2::ZERO {
        let stays = (0..=SAMPLES).all(|i| {
            let s = from + (to - from) * i as f64 / SAMPLES as f64;
            smooth.at(s).distance(start) <= tolerance
        });
        return stays.then_some(None);
    }
    let line = words(start, way, way)?;
    is_near(smooth, &line, [from, to], tolerance).then_some(Some(line))
}

/// The nearest whole counts, halves upwards.
fn whole(point: Point) -> Point {
    Point::new((point.x + 0.5).floor(), (point.y + 0.5).floor())
}

fn straight(start: Point, end: Point) -> Option<host::Stroke> {
    (start != end).then(|| words(start, end - start, end - start)).flatten()
}

/// The words of the stroke that leaves along `u` and goes `way` in all, if they fit.
fn words(start: Point, u: Vec2, way: Vec2) -> Option<host::Stroke> {
    let v = way - u;
    let curve = host::Curve { from: [start.x, start.y], jklm: [-v.x, u.x, -v.y, u.y], quarters: 1 };
    curve.words().ok()
}

/// Whether the stroke and the part of the curve keep within the tolerance of each other, all along.
fn is_near(smooth: &Smooth, words: &host::Stroke, [from, to]: [f64; 2], tolerance: f64) -> bool {
    let curve = curve_of(words);
    let distance = |i: usize| {
        let share = i as f64 / SAMPLES as f64;
        let point = at(&curve, share);
        let s = smooth.nearest(point, from + (to - from) * share, from, to);
        smooth.at(s).distance(point)
    };
    // Most that are too far are so in the middle.
    distance(SAMPLES / 2) <= tolerance
        && (0..=SAMPLES).all(|i| distance(i) <= tolerance)
        && covers(smooth, &curve, [from, to], tolerance)
}

/// The point of a stroke after a share of its quarter.
pub(super) fn at(curve: &host::Curve, share: f64) -> Point {
    let [x, y] = curve.at(std::f64::consts::FRAC_PI_2 * share);
    Point::new(x, y)
}

/// Whether the curve nowhere leaves the stroke, as a loop between two samples would.
fn covers(smooth: &Smooth, curve: &host::Curve, [from, to]: [f64; 2], tolerance: f64) -> bool {
    const DENSE: usize = 2 * SAMPLES;
    let stroke: [Point; DENSE + 1] = std::array::from_fn(|i| at(curve, i as f64 / DENSE as f64));
    let longest = stroke.windows(2).map(|ends| ends[0].distance(ends[1])).fold(0.0, f64::max);
    let mut near = 0;
    (1..DENSE).all(|i| {
        let point = smooth.at(from + (to - from) * i as f64 / DENSE as f64);
        // The nearest sample moves on with the point.
        while near < DENSE && stroke[near + 1].distance(point) <= stroke[near].distance(point) {
            near += 1;
        }
        stroke[near].distance(point) <= tolerance + longest
    })
}

/// The stroke in real numbers.
pub(super) fn curve_of(words: &host::Stroke) -> host::Curve {
    host::Curve { from: words.from.map(f64::from), jklm: words.jklm.map(f64::from), quarters: words.quarters }
}

#[cfg(test)]
mod tests {
    use kurbo::{BezPath, Shape as _};

    use super::*;

    fn sheet(curves: Vec<BezPath>) -> Sheet {
        Sheet { curves, counts_per_millimetre: 1.0 }
    }

    #[test]
    fn a_circle_and_an_ellipse_are_four_strokes_and_a_line_is_one() {
        let circle = kurbo::Circle::new((2000.0, 2000.0), 2000.0).to_path(0.6);
        let strokes = cut(&sheet(vec![circle]), 1.0);
        let words: Vec<_> = strokes.iter().map(|stroke| (stroke.words.from, stroke.words.jklm)).collect();
        let r = 2000;
        let expected = [
            ([4000, 2000], [r, 0, 0, r]),
            ([2000, 4000], [0, -r, r, 0]),
            ([0, 2000], [-r, 0, 0, -r]),
            ([2000, 0], [0, r, -r, 0]),
        ];
        assert_eq!(words, expected);
        let ellipse = kurbo::Ellipse::new((0.0, 0.0), (900.0, 300.0), 0.4).to_path(0.01);
        assert!(cut(&sheet(vec![ellipse]), 1.0).len() <= 8);
        let line = kurbo::Line::new((-3.0, 4.0), (3000.0, 77.2)).to_path(0.1);
        assert_eq!(cut(&sheet(vec![line]), 1.0).len(), 1);
    }

    #[test]
    fn strokes_of_a_curve_meet_and_keep_within_the_tolerance() {
        let mut random = 7u64;
        let mut next = || {
            random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            ((random >> 33) % 4000) as f64
        };
        for _ in 0..40 {
            let mut path = BezPath::new();
            path.move_to((next(), next()));
            for _ in 0..3 {
                path.curve_to((next(), next()), (next(), next()), (next(), next()));
            }
            let strokes = cut(&sheet(vec![path.clone()]), 1.0);
            for ends in strokes.windows(2) {
                assert_eq!(ends[0].words.end(), ends[1].words.from.map(i32::from));
            }
            // Measured by another program's nearest point, over the whole path.
            for stroke in &strokes {
                for i in 0..=10 {
                    let point = at(&curve_of(&stroke.words), f64::from(i) / 10.0);
                    let squares = path.segments().map(|piece| kurbo::ParamCurveNearest::nearest(&piece, point, 1e-3));
                    let distance = squares.map(|near| near.distance_sq).fold(f64::INFINITY, f64::min).sqrt();
                    assert!(distance <= 1.05, "{distance} at {point:?} of {stroke:?}");
                }
            }
        }
    }

    #[test]
    fn what_is_smaller_than_a_count_draws_nothing_or_goes_straight() {
        let small = kurbo::Circle::new((10.0, 10.0), 0.3).to_path(0.01);
        assert!(cut(&sheet(vec![small]), 1.0).is_empty());
        let corner = BezPath::from_svg("M0 0 C 0.2 5 0.3 5 0.4 0").expect("a path");
        assert!(cut(&sheet(vec![corner]), 0.75).len() <= 4);
    }
}
