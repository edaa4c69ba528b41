//! A picture of the path that a machine draws, in the characters of a terminal.

use std::fmt;

use textplots::{Chart, Plot as _, Shape};

use crate::base::word::decode;
use crate::base::{Diagnostic, Report, Signal, ValueId};
use crate::scenario::{Axis, Named, Plot};

/// Dots across and down; a character holds 2 by 4 of them.
const SIZE: (u32, u32) = (120, 96);

/// A path, gathered tick by tick.
pub(super) struct Picture {
    axes: [Coordinate; 2],
    points: Vec<(f32, f32)>,
}

enum Coordinate {
    Signal(Signal),
    Steps(Vec<(ValueId, f64)>, f64),
}

impl Picture {
    /// # Errors
    /// `S014` for a signal that the circuit does not have.
    pub fn new(plot: &Plot, signals: &[Signal]) -> Result<Self, Report> {
        let axes = [Coordinate::new(&plot.x, signals)?, Coordinate::new(&plot.y, signals)?];
        Ok(Self { axes, points: Vec::new() })
    }

    /// Takes the point of a tick.
    pub fn sample(&mut self, read: impl Fn(ValueId) -> u64) {
        let [x, y] = &mut self.axes;
        let point = (x.next(&read) as f32, y.next(&read) as f32);
        if self.points.last() != Some(&point) {
            self.points.push(point);
        }
    }
}

impl Coordinate {
    fn new(axis: &Axis, signals: &[Signal]) -> Result<Self, Report> {
        Ok(match axis {
            Axis::Signal(signal) => Coordinate::Signal(find(signal, signals)?.clone()),
            Axis::Steps(steps) => {
                let found = steps.iter().map(|step| Ok((find(step, signals)?.value, step.value)));
                Coordinate::Steps(found.collect::<Result<_, Report>>()?, 0.0)
            }
        })
    }

    fn next(&mut self, read: impl Fn(ValueId) -> u64) -> f64 {
        match self {
            Coordinate::Signal(signal) => {
                let value = decode(read(signal.value), signal.width, signal.signed) as f64;
                value / 2f64.powi(signal.fraction.unwrap_or(0) as i32)
            }
            Coordinate::Steps(steps, sum) => {
                *sum += steps.iter().map(|(value, length)| read(*value) as f64 * length).sum::<f64>();
                *sum
            }
        }
    }
}

fn find<'s, T>(wanted: &Named<T>, signals: &'s [Signal]) -> Result<&'s Signal, Report> {
    signals.iter().find(|signal| signal.name() == wanted.name).ok_or_else(|| {
        let message = format!("the picture asks for `{}`, which is no signal of the circuit", wanted.name);
        Diagnostic::new("S014", message).into()
    })
}

impl fmt::Display for Picture {
    /// Both axes to the same scale, so that a circle is round.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let bounds = |of: fn(&(f32, f32)) -> f32| {
            let all = self.points.iter().map(of);
            all.fold((f32::INFINITY, f32::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)))
        };
        let (x, y) = (bounds(|point| point.0), bounds(|point| point.1));
        let scale = ((x.1 - x.0) / SIZE.0 as f32).max((y.1 - y.0) / SIZE.1 as f32);
        if scale <= 0.0 || !scale.is_finite() {
            return Ok(());
        }
        let dots = |(low, high): (f32, f32)| (((high - low) / scale).ceil() as u32).max(32);
        let middle = |(low, high): (f32, f32), dots: u32| {
            let (middle, half) = ((low + high) / 2.0, scale * dots as f32 / 2.0);
            (middle - half, middle + half)
        };
        let (width, height) = (dots(x), dots(y));
        let (x, y) = (middle(x, width), middle(y, height));
        let mut chart = Chart::new_with_y_range(width, height, x.0, x.1, y.0, y.1);
        let path = Shape::Lines(&self.points);
        let chart = chart.lineplot(&path);
        chart.figures();
        writeln!(f, "{chart}")
    }
}
