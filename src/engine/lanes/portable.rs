//! Planes computed one operation after another, in plain Rust: for machines that the code generator does not know, and
//! as its twin in the tests.

use super::segment::Place;
use super::straight::{Function, Step, Straight};

/// 64-lane words of a plane: enough lanes to make the choice of the operation cheap.
pub(super) const WORDS: usize = 16;

type Plane = [u64; WORDS];

/// Where the regions start in one memory, in planes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Starts {
    /// Both states; which is the present one alternates.
    pub(super) states: [usize; 2],
    pub(super) history: usize,
}

/// One operation on planes. Temporaries are among the fixed ones.
#[derive(Clone, Copy, Debug)]
struct Line {
    function: Function,
    target: Place,
    operands: [Place; 3],
}

/// Straight-line code in plain Rust.
#[derive(Clone, Debug)]
pub(super) struct Portable {
    lines: Vec<Line>,
}

impl Portable {
    /// Code for `straight`, and how many planes from `temporaries` on it needs.
    pub(super) fn new(straight: &Straight, temporaries: u32) -> (Self, u32) {
        let mut uses = vec![0u32; straight.values];
        for step in &straight.steps {
            match step {
                Step::Store { value, .. } => uses[*value as usize] += 1,
                Step::Compute { function, operands, .. } => {
                    operands[..function.arity()].iter().for_each(|&operand| uses[operand as usize] += 1);
                }
            }
        }
        let mut places: Vec<Option<Place>> = straight.leaves.iter().copied().map(Some).collect();
        places.resize(straight.values, None);
        let mut placer = Placer { uses, places, temporaries, free: Vec::new(), end: temporaries, lines: Vec::new() };
        for (at, step) in straight.steps.iter().enumerate() {
            match *step {
                Step::Store { value, place } => placer.store(value, place),
                Step::Compute { result, function, operands } => {
                    let home = match straight.steps.get(at + 1) {
                        Some(&Step::Store { value, place }) if value == result && !is_history(place) => Some(place),
                        _ => None,
                    };
                    placer.compute(result, function, &operands, home);
                }
            }
        }
        (Self { lines: placer.lines }, placer.end - temporaries)
    }

    /// Computes one tick; `parity` tells which state is the present one.
    pub(super) fn run(&self, memory: &mut [u64], starts: Starts, parity: usize) {
        let (planes, _) = memory.as_chunks_mut::<WORDS>();
        let at = |place: Place| match place {
            Place::Fixed(plane) => plane as usize,
            Place::Now(plane) => starts.states[parity] + plane as usize,
            Place::Next(plane) => starts.states[1 - parity] + plane as usize,
            Place::History(plane) => starts.history + plane as usize,
        };
        for line in &self.lines {
            let [a, b, c] = line.operands.map(|operand| &planes[at(operand)]);
            planes[at(line.target)] = computed(line.function, a, b, c);
        }
    }
}

fn computed(function: Function, a: &Plane, b: &Plane, c: &Plane) -> Plane {
    match function {
        Function::And => std::array::from_fn(|i| a[i] & b[i]),
        Function::AndNot => std::array::from_fn(|i| !a[i] & b[i]),
        Function::Or => std::array::from_fn(|i| a[i] | b[i]),
        Function::Xor => std::array::from_fn(|i| a[i] ^ b[i]),
        Function::Table(table) => std::array::from_fn(|i| by_table(table, a[i], b[i], c[i])),
    }
}

/// Bit by bit, bit `4a + 2b + c` of the table.
fn by_table(table: u8, a: u64, b: u64, c: u64) -> u64 {
    let row = |row: u8| {
        let side = |word: u64, bit: u8| if row >> bit & 1 == 1 { word } else { !word };
        side(a, 2) & side(b, 1) & side(c, 0)
    };
    (0..8).filter(|i| table >> i & 1 == 1).map(row).fold(0, |all, row| all | row)
}

fn is_history(place: Place) -> bool {
    matches!(place, Place::History(_))
}

struct Placer {
    /// How many times each value is still used.
    uses: Vec<u32>,
    places: Vec<Option<Place>>,
    temporaries: u32,
    free: Vec<u32>,
    end: u32,
    lines: Vec<Line>,
}

impl Placer {
    fn place(&self, value: u32) -> Place {
        self.places[value as usize].expect("a value is computed before it is used")
    }

    fn use_up(&mut self, value: u32) {
        self.uses[value as usize] -= 1;
        match self.place(value) {
            Place::Fixed(plane) if plane >= self.temporaries && self.uses[value as usize] == 0 => self.free.push(plane),
            _ => {}
        }
    }

    fn temporary(&mut self) -> Place {
        Place::Fixed(self.free.pop().unwrap_or_else(|| {
            self.end += 1;
            self.end - 1
        }))
    }

    fn compute(&mut self, result: u32, function: Function, operands: &[u32; 3], home: Option<Place>) {
        let places = operands.map(|operand| self.place(operand));
        operands[..function.arity()].iter().for_each(|&operand| self.use_up(operand));
        let target = home.unwrap_or_else(|| self.temporary());
        self.places[result as usize] = Some(target);
        self.lines.push(Line { function, target, operands: places });
    }

    fn store(&mut self, value: u32, place: Place) {
        let from = self.place(value);
        if from != place {
            self.lines.push(Line { function: Function::Or, target: place, operands: [from; 3] });
        }
        self.use_up(value);
    }
}
