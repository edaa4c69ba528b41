//! Levelize: puts ops in an order in which each follows its operands, and drops what nobody needs.

use super::Program;
use crate::base::{Graph, MemoryWrite, Op, Ram, RamId, Register, RegisterId, RomId, ValueId};

/// The ordered program. Inputs stay, needed or not; registers and memories stay when something needed reads them.
pub(super) fn levelize(mut program: Program) -> Program {
    let mut order = Order {
        graph: &program.graph,
        place: vec![None; program.graph.nodes.len()],
        nodes: Vec::new(),
        registers: Ids::new(program.graph.registers.len()),
        roms: Ids::new(program.graph.roms.len()),
        rams: Ids::new(program.graph.rams.len()),
    };
    for root in program.observed() {
        order.visit(root);
    }
    order.follow_state();
    let Order { place, nodes, registers, roms, rams, .. } = order;
    let moved = |id: ValueId| place[id.index()].expect("a needed value has a place");
    let old = &program.graph;
    let graph = Graph {
        nodes: nodes
            .iter()
            .map(|&id| {
                let mut node = old.node(id);
                node.op = match node.op.map(moved) {
                    Op::Register(id) => Op::Register(RegisterId::new(registers.new_of(id.index()))),
                    Op::RomRead(id, a) => Op::RomRead(RomId::new(roms.new_of(id.index())), a),
                    Op::RamRead(id, a) => Op::RamRead(RamId::new(rams.new_of(id.index())), a),
                    op => op,
                };
                node
            })
            .collect(),
        registers: registers.kept.iter().map(|&i| move_register(old.registers[i], moved)).collect(),
        roms: roms.kept.iter().map(|&i| old.roms[i].clone()).collect(),
        rams: rams.kept.iter().map(|&i| move_ram(&old.rams[i], moved)).collect(),
    };
    program.owner = nodes.iter().map(|id| program.owner[id.index()]).collect();
    program.map_observed(moved);
    program.graph = graph;
    program
}

fn move_register(register: Register, moved: impl Fn(ValueId) -> ValueId) -> Register {
    Register {
        next: moved(register.next),
        enable: register.enable.map(&moved),
        clear: register.clear.map(&moved),
        ..register
    }
}

fn move_ram(ram: &Ram, moved: impl Fn(ValueId) -> ValueId) -> Ram {
    let write = ram.write;
    let write = MemoryWrite { enable: moved(write.enable), address: moved(write.address), data: moved(write.data) };
    Ram { image: ram.image.clone(), write }
}

/// Which entries of a table are needed, and their new numbers in order of first use.
struct Ids {
    new: Vec<Option<usize>>,
    kept: Vec<usize>,
}

impl Ids {
    fn new(count: usize) -> Self {
        Self { new: vec![None; count], kept: Vec::new() }
    }

    fn need(&mut self, old: usize) {
        if self.new[old].is_none() {
            self.new[old] = Some(self.kept.len());
            self.kept.push(old);
        }
    }

    fn new_of(&self, old: usize) -> usize {
        self.new[old].expect("a needed entry has a number")
    }
}

struct Order<'a> {
    graph: &'a Graph,
    place: Vec<Option<ValueId>>,
    nodes: Vec<ValueId>,
    registers: Ids,
    roms: Ids,
    rams: Ids,
}

impl Order<'_> {
    /// Places `root` after everything it needs. An explicit stack: circuits are deeper than the machine's.
    fn visit(&mut self, root: ValueId) {
        let mut stack = vec![(root, false)];
        while let Some((id, operands_done)) = stack.pop() {
            if self.place[id.index()].is_some() {
                continue;
            }
            let op = self.graph.node(id).op;
            if operands_done {
                self.place[id.index()] = Some(ValueId::new(self.nodes.len()));
                self.nodes.push(id);
                self.note_state(op);
            } else {
                stack.push((id, true));
                op.operands(|operand| stack.push((operand, false)));
            }
        }
    }

    fn note_state(&mut self, op: Op) {
        match op {
            Op::Register(id) => self.registers.need(id.index()),
            Op::RomRead(id, _) => self.roms.need(id.index()),
            Op::RamRead(id, _) => self.rams.need(id.index()),
            _ => {}
        }
    }

    /// Places what needed state reads, which may need more state, until nothing is added.
    fn follow_state(&mut self) {
        let (mut registers, mut rams) = (0, 0);
        while registers < self.registers.kept.len() || rams < self.rams.kept.len() {
            while let Some(&i) = self.registers.kept.get(registers) {
                let register = self.graph.registers[i];
                [Some(register.next), register.enable, register.clear]
                    .into_iter()
                    .flatten()
                    .for_each(|id| self.visit(id));
                registers += 1;
            }
            while let Some(&i) = self.rams.kept.get(rams) {
                let write = self.graph.rams[i].write;
                [write.enable, write.address, write.data].into_iter().for_each(|id| self.visit(id));
                rams += 1;
            }
        }
    }
}
