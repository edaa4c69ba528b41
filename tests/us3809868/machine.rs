//! A circuit under test, driven and read by the names of its ports and nets.

use std::collections::HashMap;
use std::sync::Arc;

use stepwright::base::ValueId;
use stepwright::base::word::{mask, signed};
use stepwright::compile::{Observe, Program, compile};
use stepwright::engine::{Engine, EngineKind};
use stepwright::netlist::load;
use stepwright::simulation::shipped::{self, Shelf};

/// Parameters of a circuit that differ from its defaults; of two values for one, the later counts.
pub type Parameters<'a> = &'a [(&'a str, i64)];

/// The small test model: 9 bits, tables of 32 words of 5 bits, 1024 clocks a quarter.
pub const SMALL: Parameters<'static> = &[("WIDTH", 9), ("ENTRIES", 32), ("ENTRY_WIDTH", 5)];

/// The program of a text, with the nets that are to be read.
pub fn program(name: &str, text: &str, parameters: Parameters, nets: &[&str]) -> Arc<Program> {
    let last: HashMap<_, _> = parameters.iter().copied().collect();
    let parameters: Vec<_> = last.iter().map(|(name, value)| ((*name).to_owned(), *value)).collect();
    let path = format!("{name}.v");
    let netlist = load(&path, text, None, &Shelf { near: &path }, &parameters);
    let netlist = netlist.unwrap_or_else(|report| panic!("{report}"));
    let signals = |net: &str| nets.contains(&net);
    Arc::new(compile(&netlist, &Observe { signals: &signals, until: None, pulses: false }))
}

/// The program of a shipped circuit.
pub fn shipped_program(circuit: &str, parameters: Parameters, nets: &[&str]) -> Arc<Program> {
    let text = shipped::text(&format!("{circuit}.v")).unwrap_or_else(|| panic!("no circuit {circuit}"));
    program(circuit, text, parameters, nets)
}

/// A program on an engine, at some tick.
pub struct Machine {
    engine: Box<dyn Engine>,
    inputs: HashMap<String, (usize, u32)>,
    values: HashMap<String, (ValueId, u32)>,
}

impl Machine {
    /// At tick 0 with all inputs 0.
    pub fn new(program: &Arc<Program>) -> Self {
        let inputs = program.inputs.iter().enumerate().map(|(i, port)| (port.name.clone(), (i, port.width)));
        let ports = program.outputs.iter().map(|port| (port.name.clone(), (port.value, port.width)));
        let signals = program.signals.iter().map(|signal| (signal.name(), (signal.value, signal.width)));
        Self {
            engine: EngineKind::Auto.build(Arc::clone(program), 100_000).expect("an engine for every machine"),
            inputs: inputs.collect(),
            values: signals.chain(ports).collect(),
        }
    }

    /// A shipped circuit with all its outputs.
    pub fn shipped(circuit: &str, parameters: Parameters) -> Self {
        Self::new(&shipped_program(circuit, parameters, &[]))
    }

    /// Sets inputs and settles.
    pub fn set(&mut self, inputs: &[(&str, i64)]) {
        for (name, value) in inputs {
            let (input, width) = self.inputs[*name];
            let word = *value as u64 & mask(width);
            assert!(signed(word, width) == *value || word as i64 == *value, "{value} does not fit {name}");
            self.engine.set_input(input, word);
        }
        self.engine.settle();
    }

    /// Where an output or a net is, to be read often.
    pub fn find(&self, name: &str) -> (ValueId, u32) {
        *self.values.get(name).unwrap_or_else(|| panic!("no output or net {name}"))
    }

    /// The word at a place.
    pub fn word(&self, (value, _): (ValueId, u32)) -> u64 {
        self.engine.value(value)
    }

    /// The number at a place in two's complement.
    pub fn number(&self, (value, width): (ValueId, u32)) -> i64 {
        signed(self.engine.value(value), width)
    }

    /// The word of an output or net.
    pub fn get(&self, name: &str) -> u64 {
        self.word(self.find(name))
    }

    /// The number of an output or net in two's complement.
    pub fn get_signed(&self, name: &str) -> i64 {
        self.number(self.find(name))
    }

    /// Ends the tick.
    pub fn tick(&mut self) {
        self.engine.advance(1, false);
    }
}

/// What is to be drawn.
#[derive(Clone, Copy, Debug)]
pub struct Stroke {
    /// J, K, L, M.
    pub jklm: [i64; 4],
    /// X0, Y0.
    pub from: [i64; 2],
    /// 1 to 4.
    pub quarters: i64,
}

impl Stroke {
    /// From the origin.
    pub fn new(jklm: [i64; 4], quarters: i64) -> Self {
        Self { jklm, from: [0, 0], quarters }
    }

    /// The inputs that start it.
    pub fn inputs(&self) -> Vec<(&'static str, i64)> {
        let ([j, k, l, m], [x0, y0]) = (self.jklm, self.from);
        let quarters = self.quarters;
        vec![("j", j), ("k", k), ("l", l), ("m", m), ("x0", x0), ("y0", y0), ("quarters", quarters), ("start", 1)]
    }

    /// The equations of the patent at the end of the stroke: X0-J+K, X0-2J, X0-J-K, X0, and likewise Y.
    pub fn end(&self) -> [i64; 2] {
        let [j, k, l, m] = self.jklm;
        let (cosine, sine) = [(0, 1), (-1, 0), (0, -1), (1, 0)][self.quarters as usize - 1];
        let at = |from, a, b| from + a * (cosine - 1) + b * sine;
        [at(self.from[0], j, k), at(self.from[1], l, m)]
    }
}

/// A pulse on one of the four lines.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Pulse {
    /// Ticks of the generator since the first one.
    pub at: u64,
    /// 0: X; 1: Y.
    pub axis: usize,
    /// +1 or -1.
    pub way: i64,
}

/// What came of a stroke.
#[derive(Debug)]
pub struct Drawn {
    /// Pulses in order; X before Y.
    pub pulses: Vec<Pulse>,
    /// X and Y after each tick of the generator.
    pub path: Vec<[i64; 2]>,
    /// X and Y when `done` is high.
    pub end: [i64; 2],
    /// Whether `error` was high then.
    pub error: bool,
}

/// Draws a stroke with fig09_function_generator from its start to `done`.
pub fn draw(machine: &mut Machine, stroke: &Stroke) -> Drawn {
    let lines = ["up_304", "down_306", "up_314", "down_316"].map(|line| machine.find(line));
    let counts = ["x", "y"].map(|counter| machine.find(counter));
    let (busy, done) = (machine.find("busy"), machine.find("done"));
    machine.set(&stroke.inputs());
    machine.tick();
    machine.set(&[("start", 0)]);
    let (mut pulses, mut path) = (Vec::new(), Vec::new());
    let mut at = 0;
    while machine.word(busy) == 1 {
        for (line, place) in lines.iter().enumerate() {
            if machine.word(*place) == 1 {
                pulses.push(Pulse { at, axis: line / 2, way: if line % 2 == 0 { 1 } else { -1 } });
            }
        }
        machine.tick();
        path.push(counts.map(|counter| machine.number(counter)));
        at += 1;
        assert!(at < 1 << 18, "the stroke does not end");
    }
    assert_eq!(machine.word(done), 1, "done follows busy at once");
    Drawn { pulses, path, end: counts.map(|counter| machine.number(counter)), error: machine.get("error") == 1 }
}

/// A repeatable stream of random numbers (splitmix64).
pub struct Random(pub u64);

impl Random {
    /// The next 64 bits.
    pub fn word(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// A number from `-most` to `most`.
    pub fn within(&mut self, most: i64) -> i64 {
        (self.word() % (2 * most as u64 + 1)) as i64 - most
    }

    /// A stroke whose coefficients are at most `most` in magnitude.
    pub fn stroke(&mut self, most: i64) -> Stroke {
        let jklm = [0; 4].map(|_| self.within(most));
        Stroke { jklm, from: [self.within(5000), self.within(5000)], quarters: (self.word() % 4) as i64 + 1 }
    }
}
