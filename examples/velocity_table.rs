//! Prints the comparison of docs/velocity.md: one stroke of FIG. 10 under each kind of control, how long it takes and
//! how hard it shakes the tool. Run it with `cargo run --release --example velocity_table`.

use stepwright::base::Report;
use stepwright::simulation::Circuit;
use stepwright::trace::Select;

/// Names and values.
type Settings<'a> = &'a [(&'a str, i64)];

/// The stroke: 1300 pulses, a quarter of an ellipse of half axes 900 and 400; 10 bits, tables of 32 words of 6 bits.
const STROKE: Settings = &[("j", -900), ("k", 0), ("l", 0), ("m", 400), ("quarters", 1)];
const MODEL: Settings = &[("WIDTH", 10), ("ENTRIES", 32), ("ENTRY_WIDTH", 6)];

/// What is compared: a name, parameters, inputs.
pub const CONTROLS: &[(&str, Settings, Settings)] = &[
    ("none", &[("HALF", 2), ("MODE", 0)], &[]),
    ("none, slower clock: half of 6 ticks", &[("HALF", 6), ("MODE", 0)], &[]),
    ("none, slower clock: half of 10 ticks", &[("HALF", 10), ("MODE", 0)], &[]),
    ("none, slower clock: half of 20 ticks", &[("HALF", 20), ("MODE", 0)], &[]),
    ("constant delay 12", &[("HALF", 2), ("MODE", 1)], &[("delay", 12)]),
    ("constant delay 24", &[("HALF", 2), ("MODE", 1)], &[("delay", 24)]),
    ("constant delay 40", &[("HALF", 2), ("MODE", 1)], &[("delay", 40)]),
    ("constant delay 60", &[("HALF", 2), ("MODE", 1)], &[("delay", 60)]),
    ("loop 338-342, every 1000 ticks, step 1", &[("MODE", 2), ("WINDOW", 1000), ("STEP", 1)], &[("reference_340", 5)]),
    ("loop 338-342, every 1000 ticks, step 2", &[("MODE", 2), ("WINDOW", 1000), ("STEP", 2)], &[("reference_340", 5)]),
    ("loop 338-342, every 2000 ticks, step 1", &[("MODE", 2), ("WINDOW", 2000), ("STEP", 1)], &[("reference_340", 5)]),
    ("memory 347, 120 to 20 over 16 words", &[("MODE", 3), ("MIDDLE", 20), ("RAMP", 16)], &[]),
    ("memory 347, 120 to 12 over 24 words", &[("MODE", 3), ("MIDDLE", 12), ("RAMP", 24)], &[]),
    ("claim 17, interval 12", &[("MODE", 4)], &[("delay", 12)]),
    ("claim 17, interval 24", &[("MODE", 4)], &[("delay", 24)]),
];

/// Ticks of the meter's window.
const WINDOW: usize = 1500;

fn main() -> Result<(), Report> {
    println!("| control | ticks | peak acceleration |\n|---|---|---|");
    for row in 0..CONTROLS.len() {
        println!("{}", table_row(row)?);
    }
    Ok(())
}

/// A row of the table.
pub fn table_row(row: usize) -> Result<String, Report> {
    let (name, parameters, inputs) = CONTROLS[row];
    let path = draw(parameters, inputs)?;
    Ok(format!("| {name} | {} | {:.1} |", path.len(), peak_acceleration(&path)))
}

/// X and Y after each tick of the stroke.
fn draw(parameters: Settings, inputs: Settings) -> Result<Vec<[i64; 2]>, Report> {
    let mut session = Circuit::shipped("us3809868/fig10_tool_control")?.session();
    for (name, value) in [MODEL, parameters].concat() {
        session = session.parameter(name, value);
    }
    for (name, value) in [STROKE, inputs, &[("start", 1)]].concat() {
        session = session.input(name, value);
    }
    let mut tool = session.observe(Select::new::<&str>([])?).start()?;
    let (start, busy, place) = (tool.input("start")?, tool.net("busy")?, [tool.net("x")?, tool.net("y")?]);
    tool.step(1);
    tool.set(start, 0)?;
    let mut path = Vec::new();
    while tool.read(busy) == 1 {
        tool.step(1);
        path.push(place.map(|axis| tool.read(axis) as i64));
    }
    Ok(path)
}

/// The greatest acceleration in counts per window, per window, by a meter that shares nothing with block 338: the
/// length of the second difference over [`WINDOW`] ticks of the path averaged over [`WINDOW`] ticks, at rest before and
/// after.
pub fn peak_acceleration(path: &[[i64; 2]]) -> f64 {
    let axes = [0, 1].map(|axis| averaged(path, axis));
    let times = WINDOW..axes[0].len() - WINDOW;
    let acceleration = |t: usize| {
        let [x, y] = [0, 1].map(|axis| {
            let average = &axes[axis];
            average[t + WINDOW] - 2.0 * average[t] + average[t - WINDOW]
        });
        x.hypot(y)
    };
    times.map(acceleration).fold(0.0, f64::max)
}

/// One axis of the path, at rest for three windows on either side, averaged over a window.
fn averaged(path: &[[i64; 2]], axis: usize) -> Vec<f64> {
    let end = path.last().map_or(0, |point| point[axis]);
    let before = std::iter::repeat_n(0, 3 * WINDOW);
    let all = before.chain(path.iter().map(|point| point[axis])).chain(std::iter::repeat_n(end, 3 * WINDOW));
    let mut sums = vec![0];
    sums.extend(all.scan(0, |sum, position| {
        *sum += position;
        Some(*sum)
    }));
    sums.windows(WINDOW + 1).map(|window| (window[WINDOW] - window[0]) as f64 / WINDOW as f64).collect()
}
