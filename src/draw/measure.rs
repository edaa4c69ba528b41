//! What the pulses drew, held against the curves.

use kurbo::Point;
use sha2::{Digest, Sha256};

use super::cut::{at, curve_of};
use super::run::Done;
use super::smooth::Smooth;
use super::{Sheet, Stroke};

/// How far the pen was from the curves, in counts.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Deviation {
    /// At most.
    pub max: f64,
    /// Where the pen was then.
    pub at: [i32; 2],
    /// The root of the mean square over all pulses.
    pub rms: f64,
    /// At the end of a curve, at most.
    pub end: f64,
}

/// The figures of a drawing.
#[derive(Clone, PartialEq, Debug)]
pub struct Report {
    /// Strokes drawn.
    pub strokes: u64,
    /// Ticks of all strokes, one after another.
    pub ticks: u64,
    /// Pulses, those of X and Y counted singly.
    pub pulses: u64,
    /// Length of the strokes that the machine was told, in counts.
    pub length: f64,
    /// The box around all places of the pen, in counts: left, bottom, right, top.
    pub extent: [i32; 4],
    /// From the curves.
    pub deviation: Deviation,
    /// SHA-256 of all pulses: for each stroke its X0 and Y0, then tick and counts of each step.
    pub hash: String,
}

/// Takes stroke after stroke and keeps what a report and a picture need.
pub(super) struct Gauge {
    parts: Vec<Vec<Smooth>>,
    report: Report,
    squares: f64,
    hash: Sha256,
}

impl Gauge {
    pub fn new(sheet: &Sheet) -> Self {
        let report = Report {
            strokes: 0,
            ticks: 0,
            pulses: 0,
            length: 0.0,
            extent: [i32::MAX, i32::MAX, i32::MIN, i32::MIN],
            deviation: Deviation::default(),
            hash: String::new(),
        };
        let parts = sheet.curves.iter().map(Smooth::of).collect();
        Self { parts, report, squares: 0.0, hash: Sha256::new() }
    }

    /// Takes a stroke; calls `place` for each place of the pen, the first one included.
    pub fn take(&mut self, stroke: &Stroke, done: &Done<'_>, mut place: impl FnMut([i32; 2])) {
        let smooth = &self.parts[stroke.curve][stroke.part];
        let [from, to] = stroke.range;
        let mut at = stroke.words.from.map(i32::from);
        let report = &mut self.report;
        self.hash.update(at.map(i32::to_le_bytes).concat());
        (report.strokes, report.ticks) = (report.strokes + 1, report.ticks + done.ticks);
        report.length += length(stroke);
        let mut s = from;
        place(at);
        for (i, step) in done.steps.iter().enumerate() {
            at = [at[0] + step.by[0], at[1] + step.by[1]];
            self.hash.update(step.tick.to_le_bytes());
            self.hash.update(step.by.map(i32::to_le_bytes).concat());
            let pulses = step.by[0].unsigned_abs() + step.by[1].unsigned_abs();
            report.pulses += u64::from(pulses);
            let point = Point::new(f64::from(at[0]), f64::from(at[1]));
            let even = from + (to - from) * (i + 1) as f64 / done.steps.len() as f64;
            let guesses = [s, even].map(|guess| smooth.nearest(point, guess, from, to));
            s = guesses
                .into_iter()
                .min_by(|a, b| smooth.at(*a).distance(point).total_cmp(&smooth.at(*b).distance(point)))
                .unwrap_or(s);
            let distance = smooth.at(s).distance(point);
            self.squares += distance * distance * f64::from(pulses);
            if distance > report.deviation.max {
                (report.deviation.max, report.deviation.at) = (distance, at);
            }
            let [left, bottom, right, top] = report.extent;
            report.extent = [left.min(at[0]), bottom.min(at[1]), right.max(at[0]), top.max(at[1])];
            place(at);
        }
        if to == smooth.end() {
            let end = smooth.at(to).distance(Point::new(f64::from(at[0]), f64::from(at[1])));
            report.deviation.end = report.deviation.end.max(end);
        }
    }

    pub fn report(mut self) -> Report {
        let report = &mut self.report;
        if report.pulses > 0 {
            report.deviation.rms = (self.squares / report.pulses as f64).sqrt();
        } else {
            report.extent = [0; 4];
        }
        report.hash = self.hash.finalize().iter().map(|byte| format!("{byte:02x}")).collect();
        self.report
    }
}

/// The length of a stroke, in counts: chords of 64 parts of its quarter.
fn length(stroke: &Stroke) -> f64 {
    let curve = curve_of(&stroke.words);
    let at = |i: usize| at(&curve, i as f64 / 64.0);
    (0..64).map(|i| at(i).distance(at(i + 1))).sum()
}
