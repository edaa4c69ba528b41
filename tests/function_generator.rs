//! The multiplying function generator of US 3,809,868, FIG. 4 and 4A: path, end points, vector velocity.

use std::f64::consts::FRAC_PI_2;

use stepwright::simulation::{Circuit, Run};
use stepwright::trace::Select;

/// Units of the unrounded coordinates a count.
const COUNT: f64 = (1 << 28) as f64;
const LIMIT: u64 = 400_000;

/// One tick of the unrounded path.
type Point = (f64, f64);

struct Generator(Run<'static>);

/// What is drawn: J, K, L, M from (X0, Y0), and how.
#[derive(Clone, Copy, Debug)]
struct Stroke {
    jklm: [i64; 4],
    start: [i64; 2],
    quarters: i64,
    fast: bool,
}

impl Generator {
    fn new(parameters: &[(String, i64)]) -> Self {
        let session = Circuit::shipped("us3809868/fig04_function_generator").expect("the circuit").session();
        let session = parameters.iter().fold(session, |session, (name, value)| session.parameter(name, *value));
        let session = session.observe(Select::new(["x_88", "y_90", "rate_102"]).expect("globs"));
        Self(session.start().unwrap_or_else(|report| panic!("{report}")))
    }

    fn set(&mut self, name: &str, value: i64) {
        let set = self.0.input(name).and_then(|input| self.0.set(input, value));
        set.unwrap_or_else(|report| panic!("{value} in {name}: {report}"));
    }

    /// The number on an output or a chosen net.
    fn read(&self, name: &str) -> i64 {
        self.0.read(self.0.net(name).expect("a net")) as i64
    }

    fn unrounded(&self) -> Point {
        (self.read("x_88") as f64 / COUNT, self.read("y_90") as f64 / COUNT)
    }

    /// Gives the stroke's data and the start pulse.
    fn begin(&mut self, stroke: Stroke) {
        let [j, k, l, m] = stroke.jklm;
        let [x0, y0] = stroke.start;
        let inputs = [("j", j), ("k", k), ("l", l), ("m", m), ("x0", x0), ("y0", y0), ("quarters", stroke.quarters)];
        inputs.into_iter().for_each(|(name, value)| self.set(name, value));
        self.set("fast", stroke.fast.into());
        self.set("start", 1);
        self.0.step(1);
        self.set("start", 0);
    }

    /// The speed of the unrounded point in each of the next ticks, in counts.
    fn speeds(&mut self, ticks: usize) -> Vec<f64> {
        let mut before = self.unrounded();
        let mut speed = || {
            self.0.step(1);
            let (x, y) = std::mem::replace(&mut before, self.unrounded());
            (before.0 - x).hypot(before.1 - y)
        };
        (0..ticks).map(|_| speed()).collect()
    }

    /// Draws; returns the path while the mark is lit (before the last rounding) and the rounded end.
    fn draw(&mut self, stroke: Stroke) -> (Vec<Point>, [i64; 2]) {
        self.draw_disturbed(stroke, |_, _| ())
    }

    /// The same with something done to the inputs from the second tick after that of the start, 0, on.
    fn draw_disturbed(&mut self, stroke: Stroke, disturb: impl Fn(&mut Self, u64)) -> (Vec<Point>, [i64; 2]) {
        self.begin(stroke);
        let mut path = Vec::new();
        for tick in 2..LIMIT {
            self.0.step(1);
            disturb(self, tick);
            // The unrounded sums are one tick ahead of x and y: with `done` they lie beyond the end.
            if self.read("done") == 1 {
                return (path, [self.read("x"), self.read("y")]);
            }
            if self.read("mark") == 1 {
                path.push(self.unrounded());
            }
        }
        panic!("no end of {stroke:?}");
    }
}

fn ideal([j, k, l, m]: [i64; 4], [x0, y0]: [i64; 2], t: f64) -> Point {
    let at =
        |along: i64, across: i64, start: i64| along as f64 * (t.cos() - 1.0) + across as f64 * t.sin() + start as f64;
    (at(j, k, x0), at(l, m, y0))
}

/// The largest deviation of the path from the ideal ellipse, measured along the ray from its centre.
fn deviation(stroke: Stroke, path: &[Point]) -> f64 {
    let [j, k, l, m] = stroke.jklm.map(|value| value as f64);
    let [x0, y0] = stroke.start.map(|value| value as f64);
    let along_ray = |&(x, y): &Point| {
        let (x, y) = (x - x0 + j, y - y0 + l);
        // Cosine and sine that would give this point; on the ellipse their squares sum to 1.
        let (cosine, sine) = ((x * m - y * k) / (j * m - k * l), (y * j - x * l) / (j * m - k * l));
        x.hypot(y) * (1.0 - 1.0 / cosine.hypot(sine)).abs()
    };
    path.iter().map(along_ray).fold(0.0, f64::max)
}

/// Ticks in which the compensated generator runs up to its speed.
const RUN_UP: usize = 100;

/// Standard deviation of the vector velocity as a part of its mean, the run-up left out.
fn ripple(path: &[Point]) -> f64 {
    let steps = path.windows(2).skip(RUN_UP).map(|pair| (pair[1].0 - pair[0].0).hypot(pair[1].1 - pair[0].1));
    let speeds: Vec<f64> = steps.collect();
    let mean = speeds.iter().sum::<f64>() / speeds.len() as f64;
    (speeds.iter().map(|speed| (speed - mean).powi(2)).sum::<f64>() / speeds.len() as f64).sqrt() / mean
}

const STROKES: [[i64; 4]; 5] =
    [[-300, 100, 50, 200], [-100, 0, 0, 100], [-400, 0, 0, 50], [20, 500, -300, 40], [2000, -1500, 700, 2500]];

#[test]
fn every_stroke_ends_exactly_after_one_to_four_quarters() {
    let mut generator = Generator::new(&[("VELOCITY_BITS".to_owned(), 28)]);
    let extremes = [[4095, -4095, -4095, -4095], [0, 0, 0, 0], [1, 0, 0, -1]];
    for jklm in STROKES.into_iter().chain(extremes) {
        for quarters in 1..=4 {
            let stroke = Stroke { jklm, start: [-120, 77], quarters, fast: quarters % 2 == 0 };
            let (_, end) = generator.draw(stroke);
            let (x, y) = ideal(jklm, stroke.start, FRAC_PI_2 * quarters as f64);
            assert_eq!(end, [x.round() as i64, y.round() as i64], "{stroke:?}");
        }
    }
}

#[test]
fn a_start_with_a_wrong_number_of_quarters_is_refused_and_told() {
    let mut generator = Generator::new(&[]);
    for (quarters, refused) in [(0, 1), (5, 1), (7, 1), (1, 0)] {
        generator.set("quarters", quarters);
        generator.set("start", 1);
        generator.0.step(1);
        assert_eq!((generator.read("error"), generator.read("busy")), (refused, 1 - refused));
        assert_eq!(generator.read("done"), refused, "done follows at once");
    }
}

/// Path and velocity of a stroke, as the documentation shows them.
fn row(generator: &mut Generator, jklm: [i64; 4]) -> String {
    let stroke = Stroke { jklm, start: [0, 0], quarters: 4, fast: false };
    let (path, _) = generator.draw(stroke);
    let (free, _) = generator.draw(Stroke { fast: true, ..stroke });
    let (on, off) = (ripple(&path), ripple(&free));
    let error = deviation(stroke, &path);
    let size = jklm.map(i64::abs).into_iter().max().unwrap_or(0) as f64;
    assert!(error < 0.0015 * size, "{jklm:?} is {error} counts off its ellipse");
    // A circle has a steady velocity without the compensator, too; what is left is the short step at each quarter.
    assert!(on < 0.06 && (on < off / 4.0 || off < 0.05), "{jklm:?}: ripple {on} of {off}");
    let [j, k, l, m] = jklm;
    format!("| {j}, {k}, {l}, {m} | {error:.2} | {:.1} % | {:.1} % | {} |", 100.0 * off, 100.0 * on, path.len())
}

#[test]
fn the_path_keeps_to_its_ellipse_and_the_compensator_evens_the_velocity_as_documented() {
    let mut generator = Generator::new(&[]);
    let rows: Vec<String> = STROKES.into_iter().map(|jklm| row(&mut generator, jklm)).collect();
    assert_documented(&rows);
}

/// Fails when docs/fig04.md does not have these rows, one after another.
fn assert_documented(rows: &[String]) {
    let table = rows.join("\n");
    let page = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/docs/fig04.md")).expect("the page");
    assert!(page.contains(&table), "docs/fig04.md should have these rows:\n{table}");
}

/// A circle about (radius, 0), from the origin on.
fn circle(radius: i64, quarters: i64) -> Stroke {
    Stroke { jklm: [-radius, 0, 0, radius], start: [0, 0], quarters, fast: false }
}

#[test]
fn a_thrown_switch_109_is_never_slower_than_the_compensator_at_any_radius_as_documented() {
    let mut generator = Generator::new(&[]);
    let mut row = |radius| {
        let stroke = circle(radius, 1);
        let (compensated, _) = generator.draw(stroke);
        let (fast, _) = generator.draw(Stroke { fast: true, ..stroke });
        assert!(fast.len() < compensated.len(), "radius {radius}: {} ticks, not {}", fast.len(), compensated.len());
        let step = fast.windows(2).map(|pair| (pair[1].0 - pair[0].0).hypot(pair[1].1 - pair[0].1)).fold(0.0, f64::max);
        format!("| {radius} | {} | {} | {step:.2} |", compensated.len(), fast.len())
    };
    let rows: Vec<_> = [0, 1, 10, 40, 80, 160, 320, 640, 1000, 4095, 10_000, 32_767].map(&mut row).into();
    assert_documented(&rows);
}

#[test]
fn the_compensator_keeps_its_rate_while_switch_109_is_thrown_and_the_speed_is_there_again_when_it_falls_back() {
    let mut generator = Generator::new(&[]);
    generator.begin(circle(1000, 1));
    generator.speeds(3000);
    let rate = generator.read("rate_102");
    generator.set("fast", 1);
    let thrown = generator.speeds(60);
    assert!(thrown[4..].iter().all(|&speed| speed > 6.0), "2^20 is 6.1 counts a tick at a radius of 1000: {thrown:?}");
    assert_eq!(generator.read("rate_102"), rate);
    generator.set("fast", 0);
    // What was begun at full speed comes out for three ticks more.
    generator.speeds(3);
    assert_eq!(generator.read("rate_102"), rate);
    let after = generator.speeds(1000);
    assert!(after.iter().all(|speed| (speed / 0.25 - 1.0).abs() < 0.01), "{after:?}");
}

#[test]
fn the_mark_is_blank_in_just_the_ticks_of_the_inhibit_and_the_point_goes_its_way() {
    let mut generator = Generator::new(&[]);
    let stroke = circle(300, 1);
    let (path, end) = generator.draw(stroke);
    let blank = |tick: u64| tick % 7 < 3;
    let (lit, same_end) = generator.draw_disturbed(stroke, |generator, tick| {
        generator.set("inhibit", blank(tick).into());
    });
    // x and y show the beginning in tick 5.
    let expected: Vec<_> = (5..).zip(path).filter(|(tick, _)| !blank(*tick)).map(|(_, point)| point).collect();
    assert_eq!((lit, same_end), (expected, end));
}

#[test]
fn data_that_change_during_a_stroke_change_nothing() {
    let mut generator = Generator::new(&[]);
    let stroke = circle(50, 3);
    let undisturbed = generator.draw(stroke);
    let disturbed = generator.draw_disturbed(stroke, |generator, _| {
        for name in ["j", "k", "l", "m", "x0", "y0", "quarters"] {
            generator.set(name, 1);
        }
    });
    assert_eq!(disturbed, undisturbed);
}
