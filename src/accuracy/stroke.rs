//! How accurate a generator of elliptical strokes is: sampled full strokes, followed pulse by pulse.

use std::f64::consts::PI;

use rayon::prelude::*;

use crate::base::word::decode;
use crate::base::{Diagnostic, Report, Signal, StoppedBy, ValueId};
use crate::simulation::Session;
use crate::trace::{Frame, Observer};

/// The coefficients of a stroke: X(t) = J (cos t - 1) + K sin t + X0, and likewise Y with L and M.
pub type Coefficients = [i64; 4];

/// What is measured of one full stroke.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Stroke {
    /// J, K, L, M.
    pub coefficients: Coefficients,
    /// The greatest distance of a node from the ellipse, in counts.
    pub deviation: f64,
    /// How far from its start the full turn ends, along the axis where that is more, in counts.
    pub end_error: u64,
    /// How often an axis turns back, the four times that any ellipse does it included.
    pub reversals: u64,
    /// Steps of both axes.
    pub steps: u64,
}

/// Most ticks of a stroke.
const LIMIT: u64 = 1 << 26;

/// Whether a session's circuit is driven as the function generator of FIG. 9 is, by its ports.
///
/// # Errors
/// All that is wrong with circuit and scenario.
pub fn draws_strokes(session: Session) -> Result<bool, Report> {
    let design = session.elaborate()?;
    let inputs: Vec<_> = design.inputs().map(|net| net.name.as_str()).collect();
    let outputs: Vec<_> = design.outputs().map(|net| net.name.as_str()).collect();
    let has = |all: &[&str], wanted: &[&str]| wanted.iter().all(|name| all.contains(name));
    Ok(has(&inputs, &["start", "j", "k", "l", "m", "x0", "y0", "quarters"]) && has(&outputs, &["x", "y", "done"]))
}

/// The strokes that stand for all of a range: ellipses of five shapes, four directions and two starting points on them, whose
/// greater half axis is `range` counts.
#[must_use]
pub fn sample(range: u64) -> Vec<Coefficients> {
    let mut all = Vec::new();
    for ratio in [1.0, 0.75, 0.5, 0.25, 0.0625] {
        for direction in [0.0, 20.0, 45.0, 70.0_f64] {
            for phase in [0.0, 35.0_f64] {
                let ((sin, cos), (across, along)) = (direction.to_radians().sin_cos(), phase.to_radians().sin_cos());
                let (greater, lesser) = (range as f64, range as f64 * ratio);
                let of_cosine = [greater * along, lesser * across];
                let of_sine = [-greater * across, lesser * along];
                let x = |[a, b]: [f64; 2]| (a * cos - b * sin).round() as i64;
                let y = |[a, b]: [f64; 2]| (a * sin + b * cos).round() as i64;
                all.push([x(of_cosine), x(of_sine), y(of_cosine), y(of_sine)]);
            }
        }
    }
    all
}

/// Runs strokes, each a full turn around the origin, on all cores.
///
/// # Errors
/// `A002` a stroke that the circuit refuses or does not end; all that is wrong with circuit and scenario.
pub fn strokes(session: &Session, coefficients: &[Coefficients]) -> Result<Vec<Stroke>, Report> {
    coefficients.par_iter().map(|&coefficients| stroke(session, coefficients)).collect()
}

fn stroke(session: &Session, coefficients: Coefficients) -> Result<Stroke, Report> {
    let [j, k, l, m] = coefficients;
    let start = [("j", j), ("k", k), ("l", l), ("m", m), ("x0", j), ("y0", l), ("quarters", 4)];
    let session = start.into_iter().fold(session.clone(), |session, (name, value)| session.input(name, value));
    let design = session.until("done").limit(LIMIT).elaborate()?;
    let mut follower = Follower::of(coefficients);
    let outcome = design.start_with(vec![Box::new(&mut follower)])?.finish()?;
    if outcome.stopped_by != StoppedBy::Until || follower.steps == 0 {
        let message = format!("the circuit does not draw J = {j}, K = {k}, L = {l}, M = {m}");
        return Err(Diagnostic::new("A002", message).help("take a lesser --max, or wider multipliers").into());
    }
    let [x, y] = follower.last.unwrap_or([i64::MAX; 2]);
    Ok(Stroke {
        coefficients,
        deviation: follower.deviation,
        end_error: x.abs_diff(j).max(y.abs_diff(l)),
        reversals: follower.reversals,
        steps: follower.steps,
    })
}

/// Follows the counters X and Y.
struct Follower {
    ellipse: [f64; 4],
    ports: Vec<(u32, bool)>,
    last: Option<[i64; 2]>,
    /// The last direction of each axis.
    direction: [i64; 2],
    deviation: f64,
    reversals: u64,
    steps: u64,
}

impl Follower {
    fn of(coefficients: Coefficients) -> Self {
        let ellipse = coefficients.map(|coefficient| coefficient as f64);
        Self { ellipse, ports: Vec::new(), last: None, direction: [0; 2], deviation: 0.0, reversals: 0, steps: 0 }
    }

    fn node(&mut self, now: [i64; 2]) {
        let Some(last) = self.last.replace(now).filter(|last| *last != now) else { return };
        for axis in 0..2 {
            let step = (now[axis] - last[axis]).signum();
            self.steps += now[axis].abs_diff(last[axis]);
            self.reversals += u64::from(step * self.direction[axis] < 0);
            if step != 0 {
                self.direction[axis] = step;
            }
        }
        self.deviation = self.deviation.max(distance(self.ellipse, now.map(|coordinate| coordinate as f64)));
    }
}

impl Observer for Follower {
    fn wants(&self, name: &str) -> bool {
        ["x", "y"].contains(&name)
    }

    fn begin(&mut self, signals: &[Signal]) -> Result<Vec<ValueId>, Report> {
        let find = |name: &str| signals.iter().find(|signal| signal.name() == name);
        let found: Vec<_> = ["x", "y"].into_iter().filter_map(find).collect();
        self.ports = found.iter().map(|signal| (signal.width, signal.signed)).collect();
        Ok(found.iter().map(|signal| signal.value).collect())
    }

    fn tick(&mut self, frame: Frame<'_>) -> Result<(), Report> {
        // The counters are put at the start of the stroke by the start pulse in tick 0.
        if frame.tick > 0 && frame.before.is_none_or(|before| before != frame.words || frame.tick == 1) {
            let numbers = frame.words.iter().zip(&self.ports);
            let numbers: Vec<_> = numbers.map(|(&word, &(width, signed))| decode(word, width, signed) as i64).collect();
            if let [x, y] = numbers[..] {
                self.node([x, y]);
            }
        }
        Ok(())
    }

    fn end(&mut self) -> Result<(), Report> {
        Ok(())
    }
}

/// How far a point is from the ellipse (j cos t + k sin t, l cos t + m sin t): the least distance, by Newton's method from
/// the best of some points all around.
fn distance([j, k, l, m]: [f64; 4], [x, y]: [f64; 2]) -> f64 {
    let at = |t: f64| {
        let (sin, cos) = t.sin_cos();
        (j * cos + k * sin - x).hypot(l * cos + m * sin - y)
    };
    let starts = (0..STARTS).map(|i| PI * 2.0 * f64::from(i) / f64::from(STARTS));
    let mut t = starts.min_by(|a, b| at(*a).total_cmp(&at(*b))).unwrap_or(0.0);
    let mut best = at(t);
    for _ in 0..8 {
        let (sin, cos) = t.sin_cos();
        let (off, along, bend) = (
            [j * cos + k * sin - x, l * cos + m * sin - y],
            [k * cos - j * sin, m * cos - l * sin],
            [-j * cos - k * sin, -l * cos - m * sin],
        );
        let slope = off[0] * along[0] + off[1] * along[1];
        let curvature = along[0] * along[0] + along[1] * along[1] + off[0] * bend[0] + off[1] * bend[1];
        if curvature <= 0.0 {
            break;
        }
        t -= slope / curvature;
        best = best.min(at(t));
    }
    best
}

/// Points of the ellipse from which the nearest is looked for.
const STARTS: u32 = 64;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_distance_from_a_circle_is_the_difference_of_radii_and_that_of_an_axis_of_an_ellipse_is_known() {
        for radius in [1.0, 2.5, 7.0, 30.0] {
            for degrees in 0..12 {
                let (sin, cos) = f64::from(degrees * 31).to_radians().sin_cos();
                let off = distance([10.0, 0.0, 0.0, 10.0], [radius * cos, radius * sin]);
                assert!((off - (radius - 10.0_f64).abs()).abs() < 1e-9, "{radius} {degrees}: {off}");
            }
        }
        // Outside on the axes of an ellipse of half axes 8 and 2, turned by a right angle or not.
        for ellipse in [[8.0, 0.0, 0.0, 2.0], [0.0, 8.0, 2.0, 0.0]] {
            assert!((distance(ellipse, [9.5, 0.0]) - 1.5).abs() < 1e-9);
            assert!((distance(ellipse, [0.0, -3.0]) - 1.0).abs() < 1e-9);
        }
    }

    #[test]
    fn a_sample_has_strokes_of_all_shapes_within_its_range() {
        let all = sample(100);
        assert_eq!((all.len(), all[0]), (40, [100, 0, 0, 100]));
        for [j, k, l, m] in all {
            // The area of the ellipse is pi (j m - k l), the sum of the squares that of the squared half axes.
            let (area, squares) = ((j * m - k * l) as f64, (j * j + k * k + l * l + m * m) as f64);
            let ratio = area / 1e4;
            assert!((squares - 1e4 * (1.0 + ratio * ratio)).abs() < 300.0 && ratio > 0.05, "{j} {k} {l} {m}");
        }
    }
}
