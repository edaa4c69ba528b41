//! Chains drawn by the netlist of FIG. 18, to which the computer speaks through its bus alone.

use std::f64::consts::{FRAC_PI_2, PI};
use std::sync::atomic::AtomicBool;

use stepwright::base::{Report, Signal, ValueId, word};
use stepwright::host::{Bus, Carry, Chain, Curve, Entry, Linked, Point, Step, Stroke};
use stepwright::simulation::{Circuit, Session};
use stepwright::trace::{Frame, Observer, Select};

use super::{linked_chain, spiral};

/// Three guard stages: the path is within about a count of the curve; coefficients are up to 511.
const GUARD: i64 = 3;
/// Ticks of a quarter of the generator.
const QUARTER: usize = 32768;

/// Where the point is in each tick with a mark, stroke by stroke.
#[derive(Default)]
struct Paths {
    strokes: Vec<Vec<Point>>,
    marked: bool,
}

impl Observer for Paths {
    fn wants(&self, name: &str) -> bool {
        ["x", "y", "mark"].contains(&name)
    }

    fn begin(&mut self, signals: &[Signal]) -> Result<Vec<ValueId>, Report> {
        let find = |name: &str| signals.iter().find(|signal| signal.name() == name).expect("a signal").value;
        Ok(["x", "y", "mark"].map(find).to_vec())
    }

    fn tick(&mut self, frame: Frame<'_>) -> Result<(), Report> {
        let [x, y] = [0, 1].map(|at| word::signed(frame.words[at], 16) as f64);
        let marked = frame.words[2] == 1;
        if marked && !self.marked {
            self.strokes.push(Vec::new());
        }
        self.marked = marked;
        match self.strokes.last_mut() {
            Some(stroke) if marked => stroke.push([x, y]),
            _ => {}
        }
        Ok(())
    }

    fn end(&mut self) -> Result<(), Report> {
        Ok(())
    }
}

/// Draws a chain as FIG. 19 goes: each section is sent and drawn before the next one is computed.
fn draw(chain: &Chain) -> (Linked, Vec<Vec<Point>>) {
    let mut paths = Paths::default();
    let design = Bus::session().and_then(|session| session.parameter("GUARD", GUARD).elaborate()).expect("a design");
    let mut run = design.start_with(vec![Box::new(&mut paths)]).expect("a run");
    for step in chain.flow() {
        if let Step::Send { section, .. } = step {
            let ticks = Bus::of(&mut run).and_then(|mut bus| bus.draw(&section.stroke));
            // Seven words, ten ticks to the generator, and the one to `done`.
            let ticks = ticks.unwrap_or_else(|report| panic!("{report}"));
            assert_eq!(ticks as usize, QUARTER + 7 + 11);
        }
    }
    run.end_recording().expect("nothing fails");
    drop(run);
    (chain.link(), paths.strokes)
}

/// The direction from a point of a path to its end, or from its begin to a point of it, at a distance.
fn directions(path: &[Point], distance: f64) -> [f64; 2] {
    let (first, last) = (path[0], path[path.len() - 1]);
    let away = |from: Point, to: &&Point| (to[0] - from[0]).hypot(to[1] - from[1]) >= distance;
    let out = path.iter().find(|to| away(first, to)).expect("it is long enough");
    let back = path.iter().rev().find(|to| away(last, to)).expect("it is long enough");
    [(out[1] - first[1]).atan2(out[0] - first[0]), (last[1] - back[1]).atan2(last[0] - back[0])]
}

fn turn(from: f64, to: f64) -> f64 {
    ((to - from + 3.0 * PI) % (2.0 * PI) - PI).to_degrees()
}

#[test]
fn a_chain_is_drawn_through_the_bus_along_its_curves_to_its_ends_with_their_tangents() {
    let (linked, paths) = draw(&spiral(90.0));
    assert_eq!((linked.sections.len(), linked.notes.len(), paths.len()), (9, 0, 9), "{:?}", linked.notes);
    for (section, path) in linked.sections.iter().zip(&paths) {
        assert_eq!(path.len(), QUARTER);
        for (tick, [x, y]) in path.iter().enumerate() {
            let [ideal_x, ideal_y] = section.curve.at(tick as f64 / QUARTER as f64 * FRAC_PI_2);
            assert!((x - ideal_x).abs() < 3.0 && (y - ideal_y).abs() < 3.0, "tick {tick} of {section:?}");
        }
        // The direction over 40 counts is that of the curve over as much, to which the steps add a few degrees.
        let ideal: Vec<_> =
            (0..=QUARTER).map(|tick| section.curve.at(tick as f64 / QUARTER as f64 * FRAC_PI_2)).collect();
        for (drawn, ideal) in directions(path, 40.0).into_iter().zip(directions(&ideal, 40.0)) {
            assert!(turn(drawn, ideal).abs() < 4.0, "{} degrees in {section:?}", turn(drawn, ideal));
        }
    }
    for (joint, pair) in linked.sections.iter().zip(paths.windows(2)) {
        // The first point of the next stroke is where the last pulse of this one has led: P1, exactly.
        assert_eq!(pair[1][0], joint.to);
        let ([_, arrived], [leaves, _]) = (directions(&pair[0], 30.0), directions(&pair[1], 30.0));
        // A spiral of this size turns by some 10 degrees in 30 counts.
        assert!(turn(arrived, leaves).abs() < 20.0, "{} degrees at {:?}", turn(arrived, leaves), joint.to);
    }
}

#[test]
fn with_the_slope_as_it_is_printed_the_corner_is_there_in_the_drawing() {
    let times_5 = |[x, y]: Point| [5.0 * x, 5.0 * y];
    let two = |p3, p1| Entry::Two { p3: times_5(p3), p1: times_5(p1) };
    let chain = Chain::new([0.0, 0.0], 4.0)
        .then(two([20.0, 35.0], [60.0, 50.0]))
        .then(two([110.0, 55.0], [150.0, 20.0]))
        .carrying(Carry::AsPrinted);
    let (linked, paths) = draw(&chain);
    assert_eq!((linked.sections.len(), linked.notes.len()), (2, 1));
    let ([_, arrived], [leaves, _]) = (directions(&paths[0], 15.0), directions(&paths[1], 15.0));
    assert!((turn(arrived, leaves) - 84.1).abs() < 10.0, "{} degrees", turn(arrived, leaves));
}

#[test]
fn a_circle_and_a_move_are_drawn_as_they_are_asked_for() {
    let mut paths = Paths::default();
    let design = Bus::session().and_then(|session| session.parameter("GUARD", GUARD).elaborate()).expect("a design");
    let mut run = design.start_with(vec![Box::new(&mut paths)]).expect("a run");
    let mut bus = Bus::of(&mut run).expect("the bus");
    bus.draw(&Stroke { from: [0, 0], jklm: [0, 300, 0, 200], quarters: 1, pen: false }).expect("a move");
    assert_eq!(bus.status(), 0x0090);
    bus.draw(&Curve::circle([550.0, 200.0], 250.0).words().expect("it fits")).expect("a circle");
    assert_eq!(bus.status(), 0x008C);
    run.end_recording().expect("nothing fails");
    drop(run);
    let [circle] = &paths.strokes[..] else { panic!("{} strokes", paths.strokes.len()) };
    assert_eq!(circle.len(), 4 * QUARTER);
    assert!(circle.iter().all(|[x, y]| ((x - 550.0).hypot(y - 200.0) - 250.0).abs() < 3.0));
}

#[test]
fn what_the_machine_refuses_is_h001_and_a_run_that_is_broken_off_h002() {
    let small = |session: Session| session.parameter("WIDTH", 9).parameter("ENTRIES", 32).parameter("ENTRY_WIDTH", 5);
    let start = || Bus::session().map(small).and_then(|session| session.start()).expect("a run");
    let draw = |run: &mut stepwright::simulation::Run<'_>, stroke: &Stroke| {
        Bus::of(run).and_then(|mut bus| bus.draw(stroke)).map_err(|report| report.diagnostics[0].code)
    };
    let good = Stroke { from: [0, 0], jklm: [0, 50, 0, 50], quarters: 1, pen: true };
    let mut run = start();
    assert_eq!(draw(&mut run, &Stroke { jklm: [512, 0, 0, 0], ..good }), Err("H001"));
    assert_eq!(draw(&mut run, &Stroke { from: [32750, 0], ..good }), Err("H001"));
    assert!(draw(&mut run, &good).is_ok());

    let broken_off = AtomicBool::new(true);
    let mut run = start().cancelled_by(&broken_off);
    assert_eq!(draw(&mut run, &good), Err("H002"));

    let mut other =
        Circuit::shipped("us3809868/fig09_function_generator").and_then(|c| c.session().start()).expect("it");
    assert_eq!(draw(&mut other, &good), Err("S010"));
}

#[test]
fn the_words_of_the_scenario_are_those_that_the_computer_sends() {
    let design = Session::open("us3809868/fig18_chain").and_then(Session::elaborate).expect("a scenario");
    let mut run = design.start(&Select::all()).expect("a run");
    let [write, address, data] = ["write", "address", "data"].map(|name| run.net(name).expect("an input"));
    let mut written = Vec::new();
    for _ in 0..18000 {
        if run.read(write) == 1 {
            written.push((run.read(address) as u8, run.read(data) as u16));
        }
        run.step(1);
    }
    let sections = linked_chain::chain().link().sections;
    let sent = sections.iter().flat_map(|section| section.stroke.writes());
    assert_eq!(written, sent.map(|write| (write.address, write.data)).collect::<Vec<_>>());
}
