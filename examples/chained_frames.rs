//! Prints the comparison of docs/hazards.md: polylines through the plotter, frame after frame, by a host that sends each
//! segment as it is and by one that carries what the frames before have missed. Run it with
//! `cargo run --release --example chained_frames`.

use std::f64::consts::TAU;

use stepwright::base::Report;
use stepwright::simulation::{Circuit, Input, Net, Run};

/// Corners of a polyline, in whole steps.
pub type Polyline = Vec<[i64; 2]>;

/// How far the pen is from the corners when the frames that lead to them are over, in whole steps.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Errors {
    /// At the corner where it is farthest.
    pub greatest: f64,
    /// At the last one.
    pub last: f64,
}

fn main() -> Result<(), Report> {
    println!("| polyline | greatest | at the end | greatest, carried | at the end, carried |\n|---|---|---|---|---|");
    for (name, polyline) in polylines() {
        println!("{}", table_row(name, &polyline)?);
    }
    Ok(())
}

/// What is compared.
pub fn polylines() -> Vec<(&'static str, Polyline)> {
    let corner =
        |radius: f64, turn: f64| [radius * (turn * TAU).cos(), radius * (turn * TAU).sin()].map(|x| x.round() as i64);
    vec![
        ("100 diagonals (1, 1)", (1..=100).map(|i| [i, i]).collect()),
        ("100 segments (2, 1)", (1..=100).map(|i| [2 * i, i]).collect()),
        ("100 segments (5, 3), there and back", (0..100).map(|i| [5 * (1 - i % 2), 3 * (1 - i % 2)]).collect()),
        ("circle of radius 100 in 120 segments", (0..=120).map(|i| corner(100.0, f64::from(i) / 120.0)).collect()),
        ("spiral of 300 segments", (0..=300).map(|i| corner(f64::from(i) / 3.0, f64::from(i) / 60.0)).collect()),
    ]
}

/// A row of the table.
pub fn table_row(name: &str, polyline: &[[i64; 2]]) -> Result<String, Report> {
    let (plain, carried) = (errors(polyline, false)?, errors(polyline, true)?);
    let [a, b, c, d] = [plain.greatest, plain.last, carried.greatest, carried.last];
    Ok(format!("| {name} | {a:.2} | {b:.2} | {c:.2} | {d:.2} |"))
}

/// Draws a polyline from (0, 0). A host that `carries` sends the whole steps that lead nearest to the next corner from where
/// the pen is; the other one those from corner to corner. Neither sends a frame of no length, which would move the pen.
pub fn errors(polyline: &[[i64; 2]], carries: bool) -> Result<Errors, Report> {
    let mut plotter = Plotter::new()?;
    let (mut corner, mut errors) = ([0, 0], Errors { greatest: 0.0, last: 0.0 });
    for &next in polyline {
        let pen = plotter.pen();
        let whole_steps = |quarters: i64| (quarters + 2).div_euclid(4);
        let segment = [0, 1].map(|axis| match carries {
            true => whole_steps(4 * next[axis] - pen[axis]),
            false => next[axis] - corner[axis],
        });
        corner = next;
        if segment != [0, 0] {
            plotter.draw(segment)?;
        }
        let pen = plotter.pen();
        let [x, y] = [0, 1].map(|axis| next[axis] as f64 - pen[axis] as f64 / 4.0);
        errors.last = x.hypot(y);
        errors.greatest = errors.greatest.max(errors.last);
    }
    Ok(errors)
}

/// The plotter, at rest.
struct Plotter {
    run: Run<'static>,
    segment: [Input; 2],
    start: Input,
    done: Net,
    pen: [Net; 2],
}

impl Plotter {
    fn new() -> Result<Self, Report> {
        let run = Circuit::shipped("su1522157/plotter")?.session().start()?;
        Ok(Self {
            segment: [run.input("dx")?, run.input("dy")?],
            start: run.input("start")?,
            done: run.net("done")?,
            pen: [run.net("x")?, run.net("y")?],
            run,
        })
    }

    /// Where the pen is, in quarters.
    fn pen(&self) -> [i64; 2] {
        self.pen.map(|axis| self.run.read(axis) as i64)
    }

    fn draw(&mut self, segment: [i64; 2]) -> Result<(), Report> {
        for (input, steps) in self.segment.into_iter().zip(segment) {
            self.run.set(input, steps)?;
        }
        self.run.set(self.start, 1)?;
        self.run.step(1);
        self.run.set(self.start, 0)?;
        self.run.until(self.done, 1_000_000);
        self.run.step(1);
        Ok(())
    }
}
