//! Strokes measured: full turns of ellipses, by a generator such as FIG. 9 of US 3,809,868.

use std::fmt::Write;

use serde_json::{Value, json};

use super::over::shown;
use super::{AccuracyArguments, Measured, check_outputs};
use crate::accuracy::{Stroke, sample, strokes};
use crate::base::Report;
use crate::simulation::Session;

/// The strokes that were drawn.
pub struct Strokes {
    name: String,
    range: u64,
    strokes: Vec<Stroke>,
}

/// How many of the worst are told.
const MOST_WORST: usize = 10;

/// What a circuit draws. `is_first`: its files are to be checked.
pub fn of_circuit(session: &Session, arguments: &AccuracyArguments, is_first: bool) -> Result<Strokes, Report> {
    if is_first {
        check_outputs(&session.clone().elaborate()?, arguments)?;
    }
    let name = session.circuit().name().to_owned();
    let mut strokes = strokes(session, &sample(arguments.max))?;
    strokes.sort_by(|a, b| b.deviation.total_cmp(&a.deviation));
    Ok(Strokes { name, range: arguments.max, strokes })
}

impl Strokes {
    fn astray(&self) -> usize {
        self.strokes.iter().filter(|stroke| stroke.end_error > 0).count()
    }

    fn most(&self, of: impl Fn(&Stroke) -> u64) -> u64 {
        self.strokes.iter().map(of).max().unwrap_or(0)
    }

    fn object(stroke: &Stroke) -> Value {
        let [j, k, l, m] = stroke.coefficients;
        json!({
            "inputs": { "j": j, "k": k, "l": l, "m": m }, "deviation": stroke.deviation, "end_error": stroke.end_error,
            "reversals": stroke.reversals, "steps": stroke.steps,
        })
    }
}

impl Measured for Strokes {
    fn text(&self) -> String {
        let (all, range) = (self.strokes.len(), self.range);
        let mut text = format!("{}: {all} full ellipses of half axis {range}, in counts\n\n", self.name);
        for (what, value) in self.summary() {
            // Writing into a string cannot fail.
            let _ = writeln!(text, "  {what:<16} {}", shown(&value));
        }
        let _ = writeln!(text, "\nworst:      J      K      L      M  deviation  reversals    steps");
        for stroke in self.strokes.iter().take(MOST_WORST) {
            let Stroke { coefficients: [j, k, l, m], deviation, reversals, steps, .. } = stroke;
            let _ = writeln!(text, "      {j:>7}{k:>7}{l:>7}{m:>7} {deviation:>10.3} {reversals:>10} {steps:>8}");
        }
        text
    }

    fn csv(&self) -> String {
        let mut text = String::from("j,k,l,m,deviation,end_error,reversals,steps\n");
        for stroke in &self.strokes {
            let Stroke { coefficients: [j, k, l, m], deviation, end_error, reversals, steps } = stroke;
            let _ = writeln!(text, "{j},{k},{l},{m},{deviation},{end_error},{reversals},{steps}");
        }
        text
    }

    fn json(&self) -> Value {
        let mut object = json!({ "format": 1, "command": "accuracy", "circuit": self.name, "max": self.range });
        self.summary().into_iter().for_each(|(name, value)| object[name] = value);
        object["worst"] = self.strokes.iter().take(MOST_WORST).map(Self::object).collect();
        object
    }

    fn summary(&self) -> Vec<(&'static str, Value)> {
        let mean = self.strokes.iter().map(|stroke| stroke.deviation).sum::<f64>() / self.strokes.len() as f64;
        vec![
            ("segments", self.strokes.len().into()),
            ("violations", self.astray().into()),
            ("max_deviation", self.strokes.first().map_or(0.0, |stroke| stroke.deviation).into()),
            ("mean_deviation", mean.into()),
            ("end_error", self.most(|stroke| stroke.end_error).into()),
            ("reversals", self.most(|stroke| stroke.reversals).into()),
        ]
    }

    fn is_good(&self) -> bool {
        self.astray() == 0
    }
}
