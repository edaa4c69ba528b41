//! A circuit under test, driven and read by the names of its ports and nets.

use stepwright::simulation::{Circuit, Net, Run, Session};
use stepwright::trace::Select;

/// Parameters of a circuit that differ from its defaults; of two values for one, the later counts.
pub type Parameters<'a> = &'a [(&'a str, i64)];

/// The small test model: 9 bits, tables of 32 words of 5 bits, 1024 clocks a quarter.
pub const SMALL: Parameters<'static> = &[("WIDTH", 9), ("ENTRIES", 32), ("ENTRY_WIDTH", 5)];

/// A circuit at hand as text, with the nets that are to be read.
pub fn session(name: &str, text: &str, parameters: Parameters, nets: &[&str]) -> Session {
    with(&Circuit::text(&format!("circuits/{name}.v"), text), parameters, nets)
}

/// A shipped circuit, with the nets that are to be read.
pub fn shipped_session(circuit: &str, parameters: Parameters, nets: &[&str]) -> Session {
    with(&Circuit::shipped(circuit).unwrap_or_else(|report| panic!("{report}")), parameters, nets)
}

fn with(circuit: &Circuit, parameters: Parameters, nets: &[&str]) -> Session {
    let session = circuit.session().observe(Select::new(nets).expect("globs"));
    parameters.iter().fold(session, |session, (name, value)| session.parameter(name, *value))
}

/// A circuit, standing at a tick, with its ports and nets by name.
pub struct Machine(Run<'static>);

impl Machine {
    /// At tick 0 with all inputs 0.
    pub fn new(session: &Session) -> Self {
        Self(session.clone().start().unwrap_or_else(|report| panic!("{report}")))
    }

    /// A shipped circuit with all its outputs.
    pub fn shipped(circuit: &str, parameters: Parameters) -> Self {
        Self::new(&shipped_session(circuit, parameters, &[]))
    }

    /// Sets inputs and settles.
    pub fn set(&mut self, inputs: &[(&str, i64)]) {
        for (name, value) in inputs {
            let set = self.0.input(name).and_then(|input| self.0.set(input, *value));
            set.unwrap_or_else(|report| panic!("{report}"));
        }
    }

    /// An output or a net, to be read often.
    pub fn find(&self, name: &str) -> Net {
        self.0.net(name).unwrap_or_else(|report| panic!("{report}"))
    }

    /// The word on a net.
    pub fn word(&self, net: Net) -> u64 {
        self.0.word(net)
    }

    /// The number on a net.
    pub fn number(&self, net: Net) -> i64 {
        self.0.read(net) as i64
    }

    /// The word of an output or net.
    pub fn get(&self, name: &str) -> u64 {
        self.word(self.find(name))
    }

    /// The number of an output or net.
    pub fn get_signed(&self, name: &str) -> i64 {
        self.number(self.find(name))
    }

    /// Ends the tick.
    pub fn tick(&mut self) {
        self.0.step(1);
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

    /// How many counts X goes up and down, and Y: each quarter gives |J| and |K| of X, and their signs add up to the end.
    pub fn counts(&self) -> [i64; 4] {
        let [j, k, l, m] = self.jklm.map(i64::abs);
        let ways = |axis: usize, all: i64| {
            let net = self.end()[axis] - self.from[axis];
            [(all + net) / 2, (all - net) / 2]
        };
        let ([up_x, down_x], [up_y, down_y]) = (ways(0, self.quarters * (j + k)), ways(1, self.quarters * (l + m)));
        [up_x, down_x, up_y, down_y]
    }
}

/// A pulse on one of the four lines.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Pulse {
    /// Halves of clock 329 since the first one.
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
    /// X and Y after each half of the clock.
    pub path: Vec<[i64; 2]>,
    /// X and Y when `done` is high.
    pub end: [i64; 2],
    /// Whether `error` was high then.
    pub error: bool,
}

/// Ticks of half a clock of fig09_function_generator.
pub const HALF: u64 = 2;

/// Draws a stroke with fig09_function_generator from its start to `done`. A pulse is a rising edge on its line.
pub fn draw(machine: &mut Machine, stroke: &Stroke) -> Drawn {
    let lines = ["up_304", "down_306", "up_314", "down_316"].map(|line| machine.find(line));
    let counts = ["x", "y"].map(|counter| machine.find(counter));
    let (busy, done) = (machine.find("busy"), machine.find("done"));
    machine.set(&stroke.inputs());
    machine.tick();
    machine.set(&[("start", 0)]);
    let (mut pulses, mut path) = (Vec::new(), Vec::new());
    let mut before = [0; 4];
    let mut tick = 0;
    while machine.word(busy) == 1 {
        let now = lines.map(|line| machine.word(line));
        for line in 0..4 {
            if (before[line], now[line]) == (0, 1) {
                pulses.push(Pulse { at: tick / HALF, axis: line / 2, way: if line % 2 == 0 { 1 } else { -1 } });
            }
        }
        before = now;
        machine.tick();
        tick += 1;
        if tick % HALF == 0 {
            path.push(counts.map(|counter| machine.number(counter)));
        }
        assert!(tick < 1 << 18, "the stroke does not end");
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
