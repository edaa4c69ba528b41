//! The interpolator under test: frames in, steps out.

use stepwright::simulation::{Circuit, Input, Net, Run, Session};
use stepwright::trace::Select;

/// What holds state between frames. All of it is 0 at rest.
const STATE: [&str; 10] = [
    "accumulator_1.sum",
    "register_2.contents",
    "register_3.contents",
    "trigger_4.q",
    "trigger_5.q",
    "counter_14.count",
    "overflow_14",
    "active_13",
    "active_20",
    "active_22",
];

/// Nets that tests look at besides.
const NETS: [&str; 2] = ["f_1", "r_14"];

/// Pulses of the three step outputs.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Step {
    X,
    Y,
    Both,
}

/// The circuit, standing at a tick.
pub struct Machine {
    run: Run<'static>,
    inputs: [Input; 4],
    busy: Net,
    steps: [(Net, Step); 3],
    state: Vec<Net>,
}

/// The circuit with some parameters.
pub fn interpolator(parameters: &[(&str, i64)]) -> Session {
    let session = Circuit::shipped("su1522157/interpolator").expect("the circuit").session();
    parameters.iter().fold(session, |session, (name, value)| session.parameter(name, *value))
}

impl Machine {
    /// The interpolator at power-on.
    pub fn new(parameters: &[(&str, i64)]) -> Self {
        Self::of(interpolator(parameters), &STATE)
    }

    /// The prototype at power-on. It has no delay 13.
    pub fn prototype(parameters: &[(&str, i64)]) -> Self {
        let session = Circuit::shipped("su1522157/prototype").expect("the circuit").session();
        let session = parameters.iter().fold(session, |session, (name, value)| session.parameter(name, *value));
        let state: Vec<_> = STATE.into_iter().filter(|name| *name != "active_13").collect();
        Self::of(session, &state)
    }

    fn of(session: Session, state: &[&str]) -> Self {
        let seen = Select::new(state.iter().chain(&NETS)).expect("globs");
        let run = session.observe(seen).start().unwrap_or_else(|report| panic!("{report}"));
        let net = |name: &str| run.net(name).expect("a net");
        Self {
            inputs: ["major_32", "minor_34", "x_is_major_35", "start_33"]
                .map(|name| run.input(name).expect("an input")),
            busy: net("busy"),
            steps: [(net("step_x_36"), Step::X), (net("step_y_37"), Step::Y), (net("step_xy_38"), Step::Both)],
            state: state.iter().copied().map(net).collect(),
            run,
        }
    }

    pub fn read(&self, name: &str) -> i64 {
        self.run.read(self.run.net(name).expect("a net")) as i64
    }

    pub fn busy(&self) -> bool {
        self.run.word(self.busy) != 0
    }

    /// The step of this tick.
    pub fn step(&self) -> Option<Step> {
        let mut high = self.steps.iter().filter(|(net, _)| self.run.word(*net) != 0);
        let step = high.next().map(|(_, step)| *step);
        assert!(high.next().is_none(), "two step outputs in one tick");
        step
    }

    pub fn tick(&mut self) {
        self.run.step(1);
    }

    /// Gives the start pulse and goes on to the next tick.
    pub fn start(&mut self, major: i64, minor: i64, x_is_major: bool) {
        for (input, value) in self.inputs.into_iter().zip([major, minor, x_is_major.into(), 1]) {
            self.run.set(input, value).expect("a number that fits");
        }
        self.tick();
        self.run.set(self.inputs[3], 0).expect("a bit");
    }

    /// Runs a whole frame from rest to rest: its steps, and how many ticks `busy` was high.
    pub fn timed_frame(&mut self, major: i64, minor: i64, x_is_major: bool) -> (Vec<Step>, u64) {
        assert!(!self.busy(), "a frame starts at rest");
        self.start(major, minor, x_is_major);
        let (mut steps, mut ticks) = (Vec::new(), 0);
        while self.busy() {
            steps.extend(self.step());
            self.tick();
            ticks += 1;
            assert!(ticks < 200_000, "({major}, {minor}) never ends");
        }
        let at_rest = self.state.iter().all(|&net| self.run.word(net) == 0);
        assert!(at_rest && self.step().is_none(), "something is left over from ({major}, {minor})");
        (steps, ticks)
    }

    /// The steps of a frame.
    pub fn frame(&mut self, major: i64, minor: i64, x_is_major: bool) -> Vec<Step> {
        self.timed_frame(major, minor, x_is_major).0
    }
}

/// Steps as the vectors write them: U for a whole step along the major axis, D for a combined step.
pub fn letters(steps: &[Step]) -> String {
    steps.iter().map(|step| if *step == Step::Both { 'D' } else { 'U' }).collect()
}

/// Where a path ends, in quarter steps along X and Y.
pub fn end_of(steps: &[Step]) -> (i64, i64) {
    steps.iter().fold((0, 0), |(x, y), step| match step {
        Step::X => (x + 4, y),
        Step::Y => (x, y + 4),
        Step::Both => (x + 3, y + 3),
    })
}
