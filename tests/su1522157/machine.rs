//! The interpolator under test: frames in, steps out.

use std::sync::Arc;

use stepwright::base::{ValueId, word};
use stepwright::compile::{Observe, Program, compile};
use stepwright::engine::{Engine, EngineKind};
use stepwright::netlist;
use stepwright::simulation::shipped::{self, Shelf};

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
    program: Arc<Program>,
    engine: Box<dyn Engine>,
    busy: ValueId,
    steps: [(ValueId, Step); 3],
    state: Vec<ValueId>,
}

/// Compiles circuit text with sight of some signals.
pub fn compiled(text: &str, parameters: &[(&str, i64)], signals: &dyn Fn(&str) -> bool) -> Arc<Program> {
    let parameters: Vec<_> = parameters.iter().map(|&(name, value)| (name.to_owned(), value)).collect();
    let netlist = netlist::load("test", text, None, &Shelf { near: "su1522157/" }, &parameters);
    let netlist = netlist.unwrap_or_else(|report| panic!("{report}"));
    Arc::new(compile(&netlist, &Observe { signals, until: None, pulses: false }))
}

impl Machine {
    /// The interpolator at power-on.
    pub fn new(parameters: &[(&str, i64)]) -> Self {
        let text = shipped::text("su1522157/interpolator.v").expect("the circuit");
        let program = compiled(text, parameters, &|name| STATE.contains(&name) || NETS.contains(&name));
        let output = |name: &str| program.outputs.iter().find(|port| port.name == name).expect("an output").value;
        let state = STATE.iter().map(|name| {
            program
                .signals
                .iter()
                .find(|signal| signal.name() == *name)
                .unwrap_or_else(|| panic!("no net {name}"))
                .value
        });
        Self {
            engine: EngineKind::Auto.build(Arc::clone(&program), u64::MAX).expect("an engine"),
            busy: output("busy"),
            steps: [(output("step_x_36"), Step::X), (output("step_y_37"), Step::Y), (output("step_xy_38"), Step::Both)],
            state: state.collect(),
            program,
        }
    }

    pub fn set(&mut self, input: &str, value: i64) {
        let place = self.program.inputs.iter().position(|port| port.name == input).expect("an input");
        self.engine.set_input(place, value as u64);
        self.engine.settle();
    }

    pub fn read(&self, name: &str) -> i64 {
        let signal = self.program.signals.iter().find(|signal| signal.name() == name);
        let signal = signal.unwrap_or_else(|| panic!("no net {name}"));
        word::decode(self.engine.value(signal.value), signal.width, signal.signed) as i64
    }

    pub fn busy(&self) -> bool {
        self.engine.value(self.busy) != 0
    }

    /// The step of this tick.
    pub fn step(&self) -> Option<Step> {
        let mut high = self.steps.iter().filter(|(value, _)| self.engine.value(*value) != 0);
        let step = high.next().map(|(_, step)| *step);
        assert!(high.next().is_none(), "two step outputs in one tick");
        step
    }

    pub fn tick(&mut self) {
        self.engine.advance(1, false);
    }

    /// Gives the start pulse and goes on to the next tick.
    pub fn start(&mut self, major: i64, minor: i64, x_is_major: bool) {
        self.set("major_32", major);
        self.set("minor_34", minor);
        self.set("x_is_major_35", x_is_major.into());
        self.set("start_33", 1);
        self.tick();
        self.set("start_33", 0);
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
        let at_rest = self.state.iter().all(|&value| self.engine.value(value) == 0);
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
