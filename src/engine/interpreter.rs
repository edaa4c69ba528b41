//! The interpreter: one op after another, the plain twin that every fast engine is held against.

use std::sync::Arc;

use super::pulses::PulseMeter;
use super::{Engine, EngineFormat, Pulses};
use crate::base::graph::evaluate;
use crate::base::{Op, ValueId};
use crate::compile::Program;

/// The interpreter by its name.
pub(super) static ENGINE: EngineFormat = EngineFormat {
    name: "interpreter",
    doc: "One op after another: starts at once",
    runs_many: false,
    build: |program, _| Ok(Box::new(Interpreter::new(program))),
};

/// Runs a program op by op, through the one definition of each op.
#[derive(Clone, Debug)]
pub struct Interpreter {
    program: Arc<Program>,
    /// Present value of every node.
    values: Vec<u64>,
    inputs: Vec<u64>,
    registers: Vec<u64>,
    rams: Vec<Vec<u64>>,
    watched: Vec<ValueId>,
    counted: Vec<ValueId>,
    pulses: PulseMeter,
}

impl Interpreter {
    /// Puts `program` at tick 0 with all inputs 0.
    #[must_use]
    pub fn new(program: Arc<Program>) -> Self {
        let graph = &program.graph;
        let inputs = vec![0; program.inputs.len()];
        let registers = graph.registers.iter().map(|register| register.init).collect();
        let rams = graph.rams.iter().map(|ram| ram.image.words().to_vec()).collect();
        Self::standing(program, inputs, registers, rams)
    }

    /// Puts `program` at some tick; pulses are counted from there on.
    pub(super) fn standing(program: Arc<Program>, inputs: Vec<u64>, registers: Vec<u64>, rams: Vec<Vec<u64>>) -> Self {
        let mut engine = Self {
            values: vec![0; program.graph.nodes.len()],
            inputs,
            registers,
            rams,
            watched: Vec::new(),
            pulses: PulseMeter::new(program.pulses.len()),
            counted: program.counted().collect(),
            program,
        };
        engine.settle();
        engine
    }

    fn word(&self, id: ValueId) -> u64 {
        self.values[id.index()]
    }

    fn compute(&self, index: usize) -> u64 {
        let graph = &self.program.graph;
        let node = graph.nodes[index];
        let word = |memory: &[u64], address: ValueId| {
            usize::try_from(self.word(address)).ok().and_then(|at| memory.get(at)).copied().unwrap_or(0)
        };
        match node.op {
            Op::Const(value) => value,
            Op::Input(i) => self.inputs[i as usize],
            Op::Register(id) => self.registers[id.index()],
            Op::RomRead(id, address) => word(graph.roms[id.index()].image.words(), address),
            Op::RamRead(id, address) => word(&self.rams[id.index()], address),
            op => {
                let mut operands = [0; 3];
                let mut count = 0;
                let mut operand_width = node.width;
                op.operands(|id| {
                    if count == 0 || matches!(op, Op::Concat(..)) {
                        operand_width = graph.width(id);
                    }
                    operands[count] = self.word(id);
                    count += 1;
                });
                evaluate(op, node.width, operand_width, operands).expect("leaves and memories are read above")
            }
        }
    }

    fn commit(&mut self) {
        let program = Arc::clone(&self.program);
        self.pulses.leave(|i| self.values[self.counted[i].index()] != 0);
        for (ram, memory) in program.graph.rams.iter().zip(0..) {
            if self.word(ram.write.enable) != 0 {
                let (address, data) = (self.word(ram.write.address), self.word(ram.write.data));
                let words: &mut Vec<u64> = &mut self.rams[memory];
                if let Some(word) = usize::try_from(address).ok().and_then(|at| words.get_mut(at)) {
                    *word = data;
                }
            }
        }
        for (register, i) in program.graph.registers.iter().zip(0..) {
            let high = |control: Option<ValueId>| control.map(|id| self.word(id) != 0);
            if high(register.clear) == Some(true) {
                self.registers[i] = register.init;
            } else if high(register.enable) != Some(false) {
                self.registers[i] = self.word(register.next);
            }
        }
    }
}

impl Engine for Interpreter {
    fn name(&self) -> &'static str {
        ENGINE.name
    }

    fn set_input(&mut self, input: usize, word: u64) {
        self.inputs[input] = word;
    }

    fn settle(&mut self) {
        for index in 0..self.values.len() {
            self.values[index] = self.compute(index);
        }
    }

    fn advance(&mut self, ticks: u64, until_stop: bool) -> u64 {
        self.settle();
        for done in 0..ticks {
            self.commit();
            self.settle();
            let stop = self.program.stop.filter(|_| until_stop);
            if stop.is_some_and(|stop| self.word(stop) != 0) {
                return done + 1;
            }
        }
        ticks
    }

    fn value(&self, id: ValueId) -> u64 {
        self.word(id)
    }

    fn pulses(&self) -> Vec<Pulses> {
        self.pulses.counts(|i| self.word(self.counted[i]) != 0)
    }

    fn watch(&mut self, ids: &[ValueId]) {
        self.watched = ids.to_vec();
    }

    fn read(&self, words: &mut [u64]) {
        for (word, &id) in words.iter_mut().zip(&self.watched) {
            *word = self.value(id);
        }
    }
}
