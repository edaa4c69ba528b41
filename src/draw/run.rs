//! Strokes through FIG. 9's generator: all at once in lanes, or one after another in one machine.

use std::ops::ControlFlow;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};

use super::Stroke;
use crate::base::{Diagnostic, Edge, Report};
use crate::simulation::{Input, Session};

/// The circuit that draws, and its pulses with the counts that each one moves the pen by.
const CIRCUIT: &str = "us3809868/fig09_function_generator";
const PULSES: [(&str, [i32; 2]); 4] =
    [("up_304", [1, 0]), ("down_306", [-1, 0]), ("up_314", [0, 1]), ("down_316", [0, -1])];
const WORDS: [&str; 6] = ["j", "k", "l", "m", "x0", "y0"];
/// A stroke takes no longer; a quarter of an ellipse takes 32,770 ticks.
const MOST_TICKS: u64 = 40_000;

/// How strokes are run.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum How {
    /// Each in a machine of its own, many at once: each stroke loads all that the machine has to know.
    AtOnce,
    /// One after another in one machine, which keeps its state between them.
    OneByOne,
}

/// A pulse, or two of X and Y in one tick: when, in ticks from the start of its stroke, and the counts that it moves.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Step {
    pub tick: u32,
    pub by: [i32; 2],
}

/// What came of a stroke.
#[derive(Clone, Copy, Debug)]
pub struct Done<'a> {
    /// Its place among the strokes.
    pub index: usize,
    /// Ticks from its start to its end, both included.
    pub ticks: u64,
    pub(super) steps: &'a [Step],
}

/// Draws the strokes and shows what came of each, in order. Returns whether all were drawn: `cancel` breaks off.
///
/// # Errors
/// `D004` the machine refuses a stroke; what the front door reports.
pub fn draw(
    strokes: &[Stroke],
    how: How,
    cancel: &AtomicBool,
    see: impl FnMut(Done<'_>) + Send,
) -> Result<bool, Report> {
    match how {
        How::AtOnce => at_once(strokes, cancel, see),
        How::OneByOne => one_by_one(strokes, cancel, see),
    }
}

fn at_once(strokes: &[Stroke], cancel: &AtomicBool, mut see: impl FnMut(Done<'_>) + Send) -> Result<bool, Report> {
    let design = Session::open(Path::new(CIRCUIT))?.elaborate()?;
    let batch = design.batch().with_edges().cancelled_by(cancel);
    let places = inputs(|name| batch.input(name))?.map(Input::place);
    let lines: Vec<_> = batch.counted().map(|port| port.name.clone()).collect();
    let error = lines.iter().position(|name| name == "error");
    let by: Vec<_> = lines.iter().map(|name| by(name)).collect();
    let mut next = strokes.iter();
    let feed = |words: &mut [u64]| {
        let Some(stroke) = next.next() else { return false };
        for (place, value) in places.into_iter().zip(values(stroke)) {
            words[place] = u64::from(value as u16);
        }
        true
    };
    let (mut steps, mut refused) = (Vec::new(), None);
    let sink = |row: crate::simulation::Row<'_>| {
        if error.is_some_and(|error| row.pulses[error] > 0) {
            refused = Some(row.index as usize);
            return ControlFlow::Break(());
        }
        together(row.edges, &by, &mut steps);
        see(Done { index: row.index as usize, ticks: row.ticks, steps: &steps });
        ControlFlow::Continue(())
    };
    let done = batch.run(feed, sink)?;
    refused.map_or(Ok(done.complete), |index| Err(refusal(index)))
}

fn one_by_one(strokes: &[Stroke], cancel: &AtomicBool, mut see: impl FnMut(Done<'_>)) -> Result<bool, Report> {
    let names = PULSES.map(|(name, _)| name).into_iter().chain(["done", "error", "x", "y"]);
    let observed = crate::trace::Select::new(names)?;
    let mut run = crate::simulation::Circuit::shipped(CIRCUIT)?.session().observe(observed).start()?;
    let (start, quarters) = (run.input("start")?, run.input("quarters")?);
    let words = inputs(|name| run.input(name))?;
    let [done, error] = [run.net("done")?, run.net("error")?];
    let mut pulses = Vec::new();
    for (name, by) in PULSES {
        pulses.push((run.net(name)?, by));
    }
    let mut steps = Vec::new();
    for (index, stroke) in strokes.iter().enumerate() {
        if cancel.load(Ordering::Relaxed) {
            return Ok(false);
        }
        steps.clear();
        for (input, value) in words.into_iter().zip(values(stroke)) {
            run.set(input, i64::from(value))?;
        }
        run.set(quarters, i64::from(stroke.words.quarters))?;
        run.set(start, 1)?;
        let began = run.tick();
        let mut before = [false; PULSES.len()];
        for tick in 1..MOST_TICKS {
            run.step(1);
            if tick == 1 {
                run.set(start, 0)?;
            }
            let mut moved = [0; 2];
            for ((net, by), before) in pulses.iter().zip(&mut before) {
                let is_high = run.word(*net) != 0;
                if is_high && !std::mem::replace(before, is_high) {
                    moved = [moved[0] + by[0], moved[1] + by[1]];
                }
                *before = is_high;
            }
            if moved != [0, 0] {
                steps.push(Step { tick: tick as u32, by: moved });
            }
            if run.word(done) != 0 {
                break;
            }
        }
        if run.word(error) != 0 || run.word(done) == 0 {
            return Err(refusal(index));
        }
        see(Done { index, ticks: run.tick() - began + 1, steps: &steps });
        run.step(1);
    }
    Ok(true)
}

fn inputs(find: impl Fn(&str) -> Result<Input, Report>) -> Result<[Input; 6], Report> {
    let [j, k, l, m, x0, y0] = WORDS;
    Ok([find(j)?, find(k)?, find(l)?, find(m)?, find(x0)?, find(y0)?])
}

fn values(stroke: &Stroke) -> [i16; 6] {
    let ([j, k, l, m], [x, y]) = (stroke.words.jklm, stroke.words.from);
    [j, k, l, m, x, y]
}

fn by(line: &str) -> [i32; 2] {
    PULSES.iter().find(|(name, _)| *name == line).map_or([0, 0], |(_, by)| *by)
}

/// Edges of one tick move the pen together.
fn together(edges: &[Edge], by: &[[i32; 2]], steps: &mut Vec<Step>) {
    steps.clear();
    for edge in edges {
        let by = by[edge.pulse as usize];
        if by == [0, 0] {
            continue;
        }
        match steps.last_mut().filter(|step| step.tick == edge.tick) {
            Some(step) => step.by = [step.by[0] + by[0], step.by[1] + by[1]],
            None => steps.push(Step { tick: edge.tick, by }),
        }
    }
}

/// `D004`.
fn refusal(index: usize) -> Report {
    Diagnostic::new("D004", format!("the machine refuses stroke {}", index + 1)).help("draw it smaller").into()
}
