//! The path that a machine draws, gathered tick by tick.

use super::{Frame, Observer};
use crate::base::word::decode;
use crate::base::{Diagnostic, Report, Signal, Sources, ValueId};

/// Points that are kept of a path. Of a longer one, points are left out where it began.
const MOST_POINTS: usize = 1 << 17;

/// Where a coordinate comes from.
#[derive(Clone, PartialEq, Debug)]
pub enum Coordinate {
    /// The value of a signal.
    Signal(String),
    /// The sum of pulses so far, each net with the length of its step. A pulse of several ticks counts once.
    Steps(Vec<(String, f64)>),
}

impl Coordinate {
    fn names(&self) -> Vec<&str> {
        match self {
            Coordinate::Signal(name) => vec![name],
            Coordinate::Steps(steps) => steps.iter().map(|(name, _)| name.as_str()).collect(),
        }
    }
}

/// A path in the plane: strokes, each a row of points.
///
/// At power-on the counters of a machine stand at 0 wherever its first stroke begins; so the path begins in tick 1,
/// when a start pulse in tick 0 has put them there. With a pen there is a point for each tick in which the pen's net is
/// high, and one more, for the step that it made last.
#[derive(Clone, Debug)]
pub struct Path {
    axes: [Coordinate; 2],
    pen: Option<String>,
    readers: [Vec<Reader>; 2],
    sums: [f64; 2],
    was_down: bool,
    strokes: Vec<Vec<[f64; 2]>>,
    points: usize,
}

/// How a word becomes a length.
#[derive(Clone, Debug)]
struct Reader {
    width: u32,
    signed: bool,
    unit: f64,
}

impl Path {
    /// The path of two coordinates, drawn while `pen` is high, or always.
    #[must_use]
    pub fn new(axes: [Coordinate; 2], pen: Option<String>) -> Self {
        Self {
            axes,
            pen,
            readers: [Vec::new(), Vec::new()],
            sums: [0.0; 2],
            was_down: false,
            strokes: Vec::new(),
            points: 0,
        }
    }

    /// The strokes, each with the points where it goes; neighbours differ.
    #[must_use]
    pub fn strokes(&self) -> &[Vec<[f64; 2]>] {
        &self.strokes
    }

    fn names(&self) -> Vec<&str> {
        self.axes.iter().flat_map(Coordinate::names).chain(self.pen.as_deref()).collect()
    }

    /// The point of this tick.
    fn point(&mut self, frame: Frame<'_>) -> [f64; 2] {
        let mut first = 0;
        std::array::from_fn(|axis| {
            let readers = &self.readers[axis];
            let words = &frame.words[first..][..readers.len()];
            let before = frame.before.map(|before| &before[first..][..readers.len()]);
            first += readers.len();
            match &self.axes[axis] {
                Coordinate::Signal(_) => readers[0].length(words[0]),
                Coordinate::Steps(_) => {
                    let rises = |i: usize| words[i] != 0 && before.is_none_or(|before| before[i] == 0);
                    let steps = readers.iter().enumerate().filter(|(i, _)| rises(*i));
                    self.sums[axis] += steps.map(|(_, reader)| reader.unit).sum::<f64>();
                    self.sums[axis]
                }
            }
        })
    }

    fn add(&mut self, point: [f64; 2], begins: bool) {
        if begins {
            self.strokes.push(Vec::new());
        }
        let Some(stroke) = self.strokes.last_mut().filter(|stroke| stroke.last() != Some(&point)) else { return };
        stroke.push(point);
        self.points += 1;
        if self.points > MOST_POINTS {
            self.thin();
        }
    }

    /// Leaves out every second point, but none that begins or ends a stroke; of too many strokes the oldest.
    fn thin(&mut self) {
        for stroke in &mut self.strokes {
            let last = stroke.len().saturating_sub(1);
            let mut at = 0..;
            stroke.retain(|_| at.next().is_some_and(|i: usize| i.is_multiple_of(2) || i == last));
        }
        if self.strokes.len() > MOST_POINTS / 4 {
            self.strokes.drain(..self.strokes.len() / 2);
        }
        self.points = self.strokes.iter().map(Vec::len).sum();
    }
}

impl Reader {
    fn length(&self, word: u64) -> f64 {
        decode(word, self.width, self.signed) as f64 * self.unit
    }
}

impl Observer for Path {
    fn wants(&self, name: &str) -> bool {
        self.names().contains(&name)
    }

    /// # Errors
    /// `S014` for each name that is no signal of the circuit.
    fn begin(&mut self, signals: &[Signal]) -> Result<Vec<ValueId>, Report> {
        let names: Vec<_> = signals.iter().map(Signal::name).collect();
        let (mut found, mut wrong) = (Vec::new(), Vec::new());
        for name in self.names() {
            match names.iter().position(|known| known == name) {
                Some(at) => found.push(&signals[at]),
                None => wrong.push(
                    Diagnostic::new(
                        "S014",
                        format!("the picture asks for `{name}`, which is no signal of the circuit"),
                    )
                    .nearest(name, names.iter().map(String::as_str)),
                ),
            }
        }
        if !wrong.is_empty() {
            return Err(Report::new(Sources::default(), wrong));
        }
        let mut left = found.iter();
        self.readers = self.axes.each_ref().map(|axis| match axis {
            Coordinate::Signal(_) => left.next().map(|signal| Reader::of(signal)).into_iter().collect(),
            Coordinate::Steps(steps) => {
                let unit = |((_, length), signal): (&(String, f64), _)| Reader { unit: *length, ..Reader::of(signal) };
                steps.iter().zip(left.by_ref().copied()).map(unit).collect()
            }
        });
        Ok(found.into_iter().map(|signal| signal.value).collect())
    }

    fn tick(&mut self, frame: Frame<'_>) -> Result<(), Report> {
        let point = self.point(frame);
        let is_down = self.pen.is_none() || frame.words.last().is_some_and(|&pen| pen != 0);
        if frame.tick > 0 {
            if is_down || self.was_down {
                self.add(point, !self.was_down);
            }
            self.was_down = is_down;
        }
        Ok(())
    }

    fn end(&mut self) -> Result<(), Report> {
        Ok(())
    }
}

impl Reader {
    fn of(signal: &Signal) -> Self {
        let unit = 2f64.powi(-(signal.fraction.unwrap_or(0) as i32));
        Self { width: signal.width, signed: signal.signed, unit }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn signal(name: &str, width: u32, value: usize) -> Signal {
        let path = vec!["top".into(), name.into()];
        Signal { path, width, signed: width > 1, fraction: None, value: ValueId::new(value) }
    }

    fn path(axes: [Coordinate; 2], pen: Option<&str>, ticks: &[&[u64]]) -> Path {
        let signals = [signal("x", 8, 0), signal("y", 8, 1), signal("busy", 1, 2)];
        let mut path = Path::new(axes, pen.map(str::to_owned));
        path.begin(&signals).expect("all are there");
        for (tick, words) in ticks.iter().enumerate() {
            let before = tick.checked_sub(1).map(|before| ticks[before]);
            path.tick(Frame { tick: tick as u64, words, before }).expect("nothing is written");
        }
        path
    }

    fn counters() -> [Coordinate; 2] {
        ["x", "y"].map(|name| Coordinate::Signal(name.to_owned()))
    }

    #[test]
    fn a_path_begins_where_the_counters_stand_when_they_have_been_set() {
        let drawn = path(counters(), None, &[&[0, 0], &[30, 0xFE], &[31, 0xFE], &[31, 0xFE]]);
        assert_eq!(drawn.strokes(), [[[30.0, -2.0], [31.0, -2.0]]]);
    }

    #[test]
    fn with_a_pen_the_step_of_the_last_pulse_still_counts_and_moves_in_the_air_do_not() {
        let ticks: [&[u64]; 6] = [&[9, 9, 0], &[0, 0, 1], &[1, 0, 0], &[7, 7, 0], &[7, 7, 1], &[8, 7, 0]];
        let drawn = path(counters(), Some("busy"), &ticks);
        assert_eq!(drawn.strokes(), [[[0.0, 0.0], [1.0, 0.0]], [[7.0, 7.0], [8.0, 7.0]]]);
    }

    #[test]
    fn steps_add_up_and_a_long_pulse_is_one_step() {
        let steps = |length| Coordinate::Steps(vec![("busy".to_owned(), length)]);
        let drawn = path([steps(1.0), steps(-0.75)], None, &[&[0, 0], &[0, 0], &[1, 1], &[1, 1], &[0, 0], &[1, 1]]);
        assert_eq!(drawn.strokes(), [[[0.0, 0.0], [1.0, -0.75], [2.0, -1.5]]]);
    }

    #[test]
    fn a_path_of_any_length_keeps_its_ends_and_a_bounded_number_of_points() {
        let mut path = Path::new(counters(), None);
        for i in 0..5 * MOST_POINTS {
            path.add([i as f64, 0.0], i == 0);
        }
        let stroke = &path.strokes()[0];
        assert!(stroke.len() <= MOST_POINTS && stroke.len() > MOST_POINTS / 4, "{}", stroke.len());
        assert_eq!((stroke[0][0], stroke[stroke.len() - 1][0]), (0.0, (5 * MOST_POINTS - 1) as f64));
    }
}
