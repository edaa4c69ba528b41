//! Draws the pictures of docs/accuracy.md and docs/hazards.md from the machines themselves. Run it with
//! `cargo run --release --example accuracy_figures -- FOLDER`.

use std::ops::ControlFlow;
use std::path::Path;
use std::sync::atomic::AtomicBool;

use stepwright::accuracy::{Frame, Meter, Tally};
use stepwright::base::Report;
use stepwright::picture::Svg;
use stepwright::plot::{Axis, Chart, HeatMap, Series, Style};
use stepwright::simulation::{Circuit, Session};
use stepwright::trace::Select;

const COMMAND: &str = "cargo run --release --example accuracy_figures";
const DEVICE: [u8; 3] = [30, 90, 200];
const PROTOTYPE: [u8; 3] = [200, 110, 20];
const MARK: [u8; 3] = [200, 30, 40];
const IDEAL: [u8; 3] = [120, 120, 120];

/// The greatest projection of the maps.
const MAP: u64 = 63;
/// The greatest projection of the measured points of FIG. 5.
const SLOPES: u64 = 511;

fn main() -> Result<(), Report> {
    let folder = std::env::args().nth(1).unwrap_or_else(|| ".".to_owned());
    for (name, picture) in pictures()? {
        let path = Path::new(&folder).join(name);
        picture.write(Some(&path.with_extension("svg")), Some(&path.with_extension("png")))?;
    }
    Ok(())
}

/// All pictures with the names of their files, without the ending.
pub fn pictures() -> Result<Vec<(&'static str, Svg)>, Report> {
    Ok(vec![
        ("fig3_device", path_of("su1522157/interpolator", "FIG. 3: the device, X = 8 and Y = 3", 0.75, DEVICE)?.svg()),
        (
            "fig4_prototype",
            path_of("su1522157/prototype", "FIG. 4: the prototype, X = 8 and Y = 3", 1.0, PROTOTYPE)?.svg(),
        ),
        ("fig5", figure_5()?.svg()),
        ("error_map", error_map()?.svg()),
        ("tie_map", tie_map()?.svg()),
        ("turned_polyline", turned_polyline()?.svg()),
    ])
}

fn series(name: impl Into<String>, colour: [u8; 3], style: Style, points: Vec<[f64; 2]>) -> Series {
    Series { name: name.into(), colour, style, points }
}

/// A frame of a machine: whether each step is a combined one, and F before it.
fn steps(circuit: &str, parameters: &[(&str, i64)], major: u64, minor: u64) -> Result<Vec<(bool, i128)>, Report> {
    let session = Circuit::shipped(circuit)?.session().input("x_is_major_35", 1).input("start_33", 1);
    let session = session.input("major_32", major as i64).input("minor_34", minor as i64);
    let session = parameters.iter().fold(session, |session, (name, value)| session.parameter(name, *value));
    let mut run = session.observe(Select::new(["f_1"])?).start()?;
    let [whole, both, busy, f] = [run.net("step_x_36")?, run.net("step_xy_38")?, run.net("busy")?, run.net("f_1")?];
    let start = run.input("start_33")?;
    run.step(1);
    run.set(start, 0)?;
    let mut steps = Vec::new();
    while run.word(busy) == 1 {
        if run.word(whole) + run.word(both) > 0 {
            steps.push((run.word(both) == 1, run.read(f)));
        }
        run.step(1);
    }
    Ok(steps)
}

/// The path of a machine on the segment of table 1, with the ideal line, the nodes, and the greatest deviation marked.
fn path_of(circuit: &str, title: &str, combined: f64, colour: [u8; 3]) -> Result<Chart, Report> {
    let (x, y) = (8.0, 3.0);
    let mut nodes = vec![[0.0, 0.0]];
    for (is_combined, _) in steps(circuit, &[], 8, 3)? {
        let last = nodes[nodes.len() - 1];
        let by = if is_combined { [combined, combined] } else { [1.0, 0.0] };
        nodes.push([last[0] + by[0], last[1] + by[1]]);
    }
    // The foot of each node on the line, and how far it is.
    let foot = |node: [f64; 2]| {
        let along = (node[0] * x + node[1] * y) / (x * x + y * y);
        [along * x, along * y]
    };
    let off = |node: [f64; 2]| f64::hypot(node[0] - foot(node)[0], node[1] - foot(node)[1]);
    let worst = nodes.iter().copied().max_by(|a, b| off(*a).total_cmp(&off(*b))).unwrap_or([0.0, 0.0]);
    Ok(Chart {
        title: title.to_owned(),
        x: Axis { name: "X, whole steps".into(), range: [-0.5, 8.5] },
        y: Axis { name: "Y, whole steps".into(), range: [-0.6, 5.5] },
        command: COMMAND.into(),
        series: vec![
            series("ideal segment", IDEAL, Style::Line, vec![[0.0, 0.0], [x, y]]),
            series("path", colour, Style::Line, nodes.clone()),
            series("nodes", colour, Style::Dots, nodes),
            series(
                format!("greatest deviation: {:.4} of a step", off(worst)),
                MARK,
                Style::Line,
                vec![worst, foot(worst)],
            ),
        ],
    })
}

fn meter(circuit: &str) -> Result<Meter, Report> {
    Meter::of(Session::open(circuit)?.measured()?)
}

fn frames(meter: &Meter, max: u64, mut sink: impl FnMut(Frame) + Send) -> Result<(), Report> {
    let sink = |frame, _, _| {
        sink(frame);
        ControlFlow::Continue(())
    };
    meter.run(max, 0, None, &AtomicBool::new(false), sink)
}

/// Both laws over the angle, and the frame that deviates most of each degree.
fn figure_5() -> Result<Chart, Report> {
    let mut all = Vec::new();
    for (circuit, name, colour) in
        [("su1522157/interpolator", "device", DEVICE), ("su1522157/prototype", "prototype", PROTOTYPE)]
    {
        let meter = meter(circuit)?;
        let mut tally = Tally::default();
        frames(&meter, SLOPES, |frame| tally.add(frame, &meter.claim()))?;
        let law = meter.claim().law;
        let curve = (0..=180).map(|i| f64::from(i) / 4.0).map(|angle| [angle, law.at(angle.to_radians())]);
        all.push(series(format!("law of the {name}"), colour, Style::Line, curve.collect()));
        let worst = tally.slopes.iter().map(|slope| [slope.worst.angle().to_degrees(), slope.worst.deviation()]);
        all.push(series(
            format!("{name}, greatest of each degree, X up to {SLOPES}"),
            colour,
            Style::Dots,
            worst.collect(),
        ));
    }
    Ok(Chart {
        title: "FIG. 5: deviation over the slope, claimed and measured".into(),
        x: Axis { name: "angle with the major axis, degrees".into(), range: [0.0, 45.0] },
        y: Axis { name: "greatest deviation of a node, whole steps".into(), range: [0.3, 0.58] },
        command: COMMAND.into(),
        series: all,
    })
}

fn map(title: &str, of: &str, cells: Vec<[f64; 3]>) -> HeatMap {
    let (x, y) = ("X, whole steps".to_owned(), "Y, whole steps".to_owned());
    HeatMap { title: title.to_owned(), x, y, of: of.to_owned(), command: COMMAND.to_owned(), cells }
}

/// The deviation of every segment.
fn error_map() -> Result<HeatMap, Report> {
    let mut cells = Vec::new();
    frames(&meter("su1522157/interpolator")?, MAP, |frame| {
        cells.push([frame.major as f64, frame.minor as f64, frame.deviation()]);
    })?;
    Ok(map("Deviation of the interpolator over all segments", "deviation, steps", cells))
}

/// Which segments meet F = 0, and of which minus zero changes the order of the steps.
fn tie_map() -> Result<HeatMap, Report> {
    let mut cells = Vec::new();
    for major in 1..=MAP {
        for minor in 0..=major {
            let [plus, minus] =
                [0, 1].map(|zero| steps("su1522157/interpolator", &[("MINUS_ZERO", zero)], major, minor));
            let (plus, minus) = (plus?, minus?);
            let is_changed = plus.iter().zip(&minus).any(|(plus, minus)| plus.0 != minus.0);
            let meets_zero = plus.iter().any(|(_, f)| *f == 0);
            cells.push([major as f64, minor as f64, if is_changed { 2.0 } else { f64::from(u8::from(meets_zero)) }]);
        }
    }
    Ok(map("Ties: 1 where F = 0 is met, 2 where minus zero changes the steps", "0, 1, 2", cells))
}

/// A polyline, turned by the commutator by 0, 45, 90 and 135 degrees.
fn turned_polyline() -> Result<Chart, Report> {
    let polyline = [[30, 0], [0, 12], [-14, 14], [-16, -6], [0, -20]];
    let colours = [DEVICE, PROTOTYPE, [40, 150, 80], [150, 60, 160]];
    let mut all = Vec::new();
    for (turn, colour) in colours.into_iter().enumerate() {
        let session = Circuit::shipped("su1522157/plotter")?.session().input("turn_45", turn as i64);
        let mut run = session.observe(Select::new::<&str>([])?).start()?;
        let [dx, dy, start] = [run.input("dx")?, run.input("dy")?, run.input("start")?];
        let [x, y, done] = [run.net("x")?, run.net("y")?, run.net("done")?];
        let mut points = vec![[0.0, 0.0]];
        for [by_x, by_y] in polyline {
            run.set(dx, by_x)?;
            run.set(dy, by_y)?;
            run.set(start, 1)?;
            run.step(1);
            run.set(start, 0)?;
            while run.word(done) == 0 {
                let point = [run.read(x) as f64 / 4.0, run.read(y) as f64 / 4.0];
                if points.last() != Some(&point) {
                    points.push(point);
                }
                run.step(1);
            }
            run.step(1);
        }
        all.push(series(format!("turned by {} degrees", 45 * turn), colour, Style::Line, points));
    }
    Ok(Chart {
        title: "A polyline turned without a new computation".into(),
        x: Axis { name: "X, whole steps".into(), range: [-36.0, 36.0] },
        y: Axis { name: "Y, whole steps".into(), range: [-15.0, 34.0] },
        command: COMMAND.into(),
        series: all,
    })
}
