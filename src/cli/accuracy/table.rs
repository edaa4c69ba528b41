//! What was measured of segments, as a table, as CSV, as JSON.

use std::fmt::Write;

use serde_json::{Value, json};

use super::Measured;
use crate::accuracy::{Claim, Frame, Printed, Tally};
use crate::picture::Svg;
use crate::plot::{Axis, Chart, Series, Style};

/// A measurement to show.
pub struct Shown {
    /// What was measured.
    pub name: String,
    /// What its two projections are called.
    pub inputs: [String; 2],
    /// The greatest projection.
    pub max: u64,
    /// What it is held against.
    pub claim: Claim,
    /// Ticks that were run, by a circuit.
    pub ticks: Option<u64>,
    /// What was found.
    pub tally: Tally,
}

impl Shown {
    fn row(&self, frame: &Frame) -> String {
        let Frame { major, minor, .. } = frame;
        format!("      {major:>7}{minor:>7} {:>10.6} {:>10.6}", frame.deviation(), self.claim.law.at(frame.angle()))
    }

    /// The law over the angle, and the frame that deviates most of each degree.
    fn chart(&self) -> Chart {
        let degrees = |i: u32| f64::from(i) / 4.0;
        let curve = (0..=180).map(degrees).map(|angle| [angle, self.claim.law.at(angle.to_radians())]);
        let law = Series { name: "law".into(), colour: [30, 90, 200], style: Style::Line, points: curve.collect() };
        let slopes = self.tally.slopes.iter().filter(|slope| slope.frames > 0).map(|slope| slope.worst);
        let points: Vec<_> = slopes.map(|frame| [frame.angle().to_degrees(), frame.deviation()]).collect();
        let name = format!("greatest of each degree, X up to {}", self.max);
        let measured = Series { name, colour: [200, 40, 30], style: Style::Dots, points };
        let heights = law.points.iter().chain(&measured.points).map(|point| point[1]);
        Chart {
            title: format!("Deviation of {} over the slope of the segment", self.name),
            x: Axis { name: "angle with the major axis, degrees".into(), range: [0.0, 45.0] },
            y: Axis::of("greatest deviation of a node, whole steps", heights),
            command: format!("stepwright accuracy {} --max {} --svg FILE", self.name, self.max),
            series: vec![law, measured],
        }
    }

    fn object(&self, frame: &Frame) -> Value {
        let [major, minor] = &self.inputs;
        let inputs = json!({ major: frame.major, minor: frame.minor });
        json!({ "inputs": inputs, "deviation": frame.deviation(), "law": self.claim.law.at(frame.angle()) })
    }
}

impl Measured for Shown {
    fn text(&self) -> String {
        let Self { name, max, tally, .. } = self;
        let Claim { law, printed, end } = self.claim;
        let mut text = format!("{name}: all {} segments with 0 <= Y <= X <= {max}", tally.segments);
        // Writing into a string cannot fail.
        let _ = self.ticks.map_or(Ok(()), |ticks| write!(text, ", {ticks} ticks"));
        let _ = writeln!(text, "\n\nlaw: delta(a) = {} sin a + {} cos a, in whole steps", law.sin, law.cos);
        let mut line = |what: &str, value: String| {
            let _ = writeln!(text, "  {what:<34} {value}");
        };
        line("segments that break it", tally.violations.to_string());
        if let Some(printed) = printed {
            let Printed { amplitude, degrees } = printed;
            line(
                &format!("printed: {amplitude} sin({degrees:.2} deg + a)"),
                format!(
                    "{} segments are beyond it; its rounding makes it up to {:.6} too small",
                    tally.beyond_printed,
                    printed.falls_short_of(law)
                ),
            );
        }
        if tally.unfinished > 0 {
            line("frames that did not end", tally.unfinished.to_string());
        }
        line("greatest deviation", format!("{:.6}", tally.max_deviation()));
        line("greatest end error on an axis", at(&tally.end, Frame::end_error));
        line(&format!("paths that end more than {end} off"), tally.astray.to_string());
        line(
            "most equal steps in a row",
            format!("{} at X = {}, Y = {}", tally.run.longest_run, tally.run.major, tally.run.minor),
        );
        for (what, frame) in [("least mean feed (way per step)", tally.slowest), ("greatest mean feed", tally.fastest)]
        {
            frame.iter().for_each(|frame| line(what, at(frame, Frame::feed)));
        }
        if let Some(frame) = &tally.no_length {
            line("frame of no length", format!("{} steps, ends {} off", frame.steps, frame.end_error()));
        }
        let _ = writeln!(text, "\nworst:      X      Y  deviation        law");
        for frame in &tally.worst {
            let _ = writeln!(text, "{}", self.row(frame));
        }
        let _ = writeln!(text, "\ndegrees     X      Y  deviation        law   segments");
        for (degrees, slope) in tally.slopes.iter().enumerate().filter(|(_, slope)| slope.frames > 0) {
            let _ =
                writeln!(text, "{degrees:>2}..{:<2}{} {:>10}", degrees + 1, &self.row(&slope.worst)[6..], slope.frames);
        }
        text
    }

    fn csv(&self) -> String {
        let mut text = String::from("from_degrees,to_degrees,segments,major,minor,deviation,law,printed\n");
        for (degrees, slope) in self.tally.slopes.iter().enumerate().filter(|(_, slope)| slope.frames > 0) {
            let Frame { major, minor, .. } = slope.worst;
            let angle = slope.worst.angle();
            let printed = self.claim.printed.map_or(String::new(), |printed| printed.at(angle).to_string());
            let (deviation, law) = (slope.worst.deviation(), self.claim.law.at(angle));
            let to = degrees + 1;
            let _ = writeln!(text, "{degrees},{to},{},{major},{minor},{deviation},{law},{printed}", slope.frames);
        }
        text
    }

    fn svg(&self) -> Option<Svg> {
        Some(self.chart().svg())
    }

    fn json(&self) -> Value {
        let tally = &self.tally;
        let slope = |(degrees, slope): (usize, &crate::accuracy::Slope)| {
            let mut object = self.object(&slope.worst);
            object["from_degrees"] = degrees.into();
            object["segments"] = slope.frames.into();
            object
        };
        let slopes = tally.slopes.iter().enumerate().filter(|(_, slope)| slope.frames > 0).map(slope);
        json!({
            "format": 1,
            "command": "accuracy",
            "circuit": self.name,
            "max": self.max,
            "segments": tally.segments,
            "ticks": self.ticks,
            "law": { "sin": self.claim.law.sin, "cos": self.claim.law.cos },
            "violations": tally.violations,
            "beyond_printed": self.claim.printed.map(|_| tally.beyond_printed),
            "printed_falls_short": self.claim.printed.map(|printed| printed.falls_short_of(self.claim.law)),
            "astray": tally.astray,
            "unfinished": tally.unfinished,
            "max_deviation": tally.max_deviation(),
            "worst": tally.worst.iter().map(|frame| self.object(frame)).collect::<Vec<_>>(),
            "end_error": tally.end.end_error(),
            "longest_run": tally.run.longest_run,
            "feed": { "min": tally.slowest.map(|frame| frame.feed()), "max": tally.fastest.map(|frame| frame.feed()) },
            "no_length": tally.no_length.map(|frame| json!({ "steps": frame.steps, "end_error": frame.end_error() })),
            "slopes": slopes.collect::<Vec<_>>(),
        })
    }

    fn summary(&self) -> Vec<(&'static str, Value)> {
        let tally = &self.tally;
        vec![
            ("segments", tally.segments.into()),
            ("violations", tally.violations.into()),
            ("astray", tally.astray.into()),
            ("unfinished", tally.unfinished.into()),
            ("max_deviation", tally.max_deviation().into()),
            ("end_error", tally.end.end_error().into()),
            ("no_length", json!(tally.no_length.map(|frame| frame.steps))),
        ]
    }

    fn is_good(&self) -> bool {
        self.tally.violations + self.tally.astray + self.tally.unfinished == 0
    }
}

fn at(frame: &Frame, of: impl Fn(&Frame) -> f64) -> String {
    format!("{:.6} at X = {}, Y = {}", of(frame), frame.major, frame.minor)
}
