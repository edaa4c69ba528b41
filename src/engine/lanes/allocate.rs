//! Allocate: straight-line code over values becomes machine code over registers.
//!
//! One walk from top to bottom. When a register is wanted and none is free, the value that is used last is let go
//! (Belady's rule); it is written to a plane of its own only if it stands nowhere in memory yet.

use super::encode::{Encoder, Finished, Opcode, Operand, Vectors};
use super::segment::Place;
use super::straight::{Function, Step, Straight};
use super::tables::reordered;

/// Machine code for `straight`, and how many planes from `spills` on it keeps values in; `None` when it is too large.
pub(super) fn allocate(straight: &Straight, vectors: Vectors, spills: u32, history: u32) -> Option<(Finished, u32)> {
    let mut walk = Walk {
        encoder: Encoder::new(vectors),
        holds: vec![None; vectors.registers()],
        values: values(straight),
        spills,
        free_spills: Vec::new(),
        end_of_spills: spills,
    };
    for step in &straight.steps {
        match *step {
            Step::Store { value, place } => walk.store(value, place),
            Step::Compute { result, function: Function::Table(table), operands } => {
                walk.ternary(result, table, operands);
            }
            Step::Compute { result, function, operands: [a, b, _] } => walk.binary(result, function, a, b),
        }
    }
    Some((walk.encoder.finish(history)?, walk.end_of_spills - spills))
}

/// What the walk knows of a value.
#[derive(Clone, Debug, Default)]
struct Value {
    /// Steps that still use it, the next one last.
    uses: Vec<usize>,
    register: Option<u8>,
    /// Where it stands in memory.
    home: Option<Place>,
}

fn values(straight: &Straight) -> Vec<Value> {
    let mut values = vec![Value::default(); straight.values];
    for (value, &place) in values.iter_mut().zip(&straight.leaves) {
        value.home = Some(place);
    }
    for (at, step) in straight.steps.iter().enumerate().rev() {
        match step {
            Step::Store { value, .. } => values[*value as usize].uses.push(at),
            Step::Compute { function, operands, .. } => {
                operands[..function.arity()].iter().for_each(|&operand| values[operand as usize].uses.push(at));
            }
        }
    }
    values
}

struct Walk {
    encoder: Encoder,
    /// What each register holds.
    holds: Vec<Option<u32>>,
    values: Vec<Value>,
    /// First plane for spilled values.
    spills: u32,
    free_spills: Vec<u32>,
    end_of_spills: u32,
}

impl Walk {
    fn value(&mut self, value: u32) -> &mut Value {
        &mut self.values[value as usize]
    }

    fn value_of(&self, value: u32) -> &Value {
        &self.values[value as usize]
    }

    fn is_last_use(&self, value: u32) -> bool {
        self.value_of(value).uses.is_empty()
    }

    /// Takes the present step off the uses of its operands.
    fn use_up(&mut self, operands: &[u32]) {
        for &operand in operands {
            self.value(operand).uses.pop();
        }
    }

    /// Gives back the registers of values that are not used any more.
    fn release_registers(&mut self, operands: &[u32]) {
        for &operand in operands {
            if self.is_last_use(operand)
                && let Some(register) = self.value(operand).register.take()
            {
                self.holds[register as usize] = None;
            }
        }
    }

    /// Gives back the planes of spilled values that are not used any more. Only after the step that reads them, or
    /// the register it wants may be spilled over its own operand.
    fn release_planes(&mut self, operands: &[u32]) {
        let spills = self.spills;
        for &operand in operands {
            if self.is_last_use(operand)
                && let Some(Place::Fixed(plane)) = self.value(operand).home.take_if(|home| is_spill(*home, spills))
            {
                self.free_spills.push(plane);
            }
        }
    }

    /// A free register; none of `pinned` is let go for it.
    fn free_register(&mut self, pinned: &[u32]) -> u8 {
        if let Some(free) = self.holds.iter().position(Option::is_none) {
            return free as u8;
        }
        let next_use = |held: &Option<u32>| {
            let value = held.filter(|value| !pinned.contains(value))?;
            Some(self.values[value as usize].uses.last().copied().unwrap_or(usize::MAX))
        };
        let (register, held) = self
            .holds
            .iter()
            .enumerate()
            .max_by_key(|(_, held)| next_use(held))
            .map(|(register, held)| (register as u8, *held))
            .expect("there are more registers than operands");
        if let Some(victim) = held {
            self.let_go(victim, register);
        }
        register
    }

    fn let_go(&mut self, victim: u32, register: u8) {
        if self.value(victim).home.is_none() {
            let plane = self.free_spills.pop().unwrap_or_else(|| {
                self.end_of_spills += 1;
                self.end_of_spills - 1
            });
            self.encoder.instruction(Opcode::STORE, register, 0, Operand::Memory(Place::Fixed(plane)));
            self.value(victim).home = Some(Place::Fixed(plane));
        }
        self.value(victim).register = None;
        self.holds[register as usize] = None;
    }

    fn hold(&mut self, register: u8, value: u32) {
        self.holds[register as usize] = Some(value);
        self.value(value).register = Some(register);
    }

    /// The register of a value, loaded if it must be.
    fn in_register(&mut self, value: u32, pinned: &[u32]) -> u8 {
        if let Some(register) = self.value_of(value).register {
            return register;
        }
        let register = self.free_register(pinned);
        let home = self.value(value).home.expect("a value is in a register or in memory");
        self.encoder.instruction(Opcode::LOAD, register, 0, Operand::Memory(home));
        self.hold(register, value);
        register
    }

    /// The value where it is, if it is not worth a register; otherwise in a register.
    fn operand(&mut self, value: u32, pinned: &[u32]) -> Operand {
        match self.value_of(value) {
            Value { register: None, home: Some(home), uses } if uses.is_empty() => Operand::Memory(*home),
            _ => Operand::Register(self.in_register(value, pinned)),
        }
    }

    fn is_memory_operand(&self, value: u32) -> bool {
        self.value_of(value).register.is_none() && self.is_last_use(value)
    }

    fn store(&mut self, value: u32, place: Place) {
        self.use_up(&[value]);
        let register = self.in_register(value, &[]);
        self.encoder.instruction(Opcode::STORE, register, 0, Operand::Memory(place));
        self.value(value).home.get_or_insert(place);
        self.release_registers(&[value]);
        self.release_planes(&[value]);
    }

    fn binary(&mut self, result: u32, function: Function, a: u32, b: u32) {
        self.use_up(&[a, b]);
        let (opcode, commutes) = match function {
            Function::And => (Opcode::AND, true),
            Function::Or => (Opcode::OR, true),
            Function::Xor => (Opcode::XOR, true),
            _ => (Opcode::AND_NOT, false),
        };
        let (a, b) = if commutes && self.is_memory_operand(a) { (b, a) } else { (a, b) };
        let first = self.in_register(a, &[a, b]);
        let second = self.operand(b, &[a, b]);
        self.release_registers(&[a, b]);
        let register = self.free_register(&[a, b]);
        self.encoder.instruction(opcode, register, first, second);
        self.release_planes(&[a, b]);
        self.hold(register, result);
    }

    /// `vpternlogq` overwrites its first operand: one that is not used again, or else a copy.
    fn ternary(&mut self, result: u32, table: u8, operands: [u32; 3]) {
        self.use_up(&operands);
        let is_alone = |i: usize| operands.iter().filter(|&&other| other == operands[i]).count() == 1;
        let in_memory = (0..3).rev().find(|&i| is_alone(i) && self.is_memory_operand(operands[i]));
        for i in (0..3).filter(|&i| Some(i) != in_memory) {
            self.in_register(operands[i], &operands);
        }
        let overwritten = (0..3).find(|&i| Some(i) != in_memory && self.is_last_use(operands[i]));
        let first = overwritten.or((0..3).find(|&i| Some(i) != in_memory)).unwrap_or(0);
        let last = in_memory.unwrap_or((first + 2) % 3);
        let second = 3 - first - last;
        let register = |walk: &Self, i: usize| walk.value_of(operands[i]).register.expect("loaded above");
        let (source, other) = (register(self, first), register(self, second));
        let third = match self.value_of(operands[last]) {
            Value { register: Some(register), .. } => Operand::Register(*register),
            Value { home, .. } => Operand::Memory(home.expect("a value is in a register or in memory")),
        };
        let target = if overwritten.is_some() { source } else { self.free_register(&operands) };
        if target != source {
            self.encoder.instruction(Opcode::LOAD, target, 0, Operand::Register(source));
        }
        self.encoder.ternary(target, other, third, reordered(table, [first, second, last]));
        self.release_registers(&operands);
        self.release_planes(&operands);
        self.hold(target, result);
    }
}

fn is_spill(home: Place, spills: u32) -> bool {
    matches!(home, Place::Fixed(plane) if plane >= spills)
}
