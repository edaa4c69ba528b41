//! A small program as one function: the tick loop is inside, state stays in machine registers.

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::{I8, I32, I64};
use cranelift_codegen::ir::{BlockArg, InstBuilder, MemFlagsData, Value};
use cranelift_frontend::FunctionBuilder;

use super::host::{Assembler, Records};
use super::memory::{Area, Layout};
use super::ops::{Emitter, Outside};
use super::word::machine_type;
use crate::base::{Diagnostic, Op, RamId, RomId, ValueId};
use crate::compile::Program;

/// Compiles the function. Its count is how many ticks to advance, its records one word: whether to stop when the
/// program's `stop` is 1. It settles the tick whose state is in `Area::Now`, goes on from there, and returns how
/// many ticks were left when it stopped. It leaves the state of that tick in `Area::Now`, the state to come in
/// `Area::Next`, and stored values in `Area::Wires`.
///
/// ```text
/// entry:  load state
/// head:   settle; next state; none left or stop? -> exit
/// commit: write memories; state = next state; -> head
/// exit:   what only an observer wants; store all
/// ```
pub(super) fn compile(assembler: &mut Assembler, program: &Program, layout: &Layout) -> Result<usize, Diagnostic> {
    assembler.function(Records::One(1), |b, arguments| emit(b, arguments, program, layout))
}

fn emit(
    b: &mut FunctionBuilder<'_>,
    [context, records, count]: [Value; 3],
    program: &Program,
    layout: &Layout,
) -> Value {
    let graph = &program.graph;
    let flags = MemFlagsData::trusted();
    let areas = Area::ALL.map(|area| b.ins().load(I64, flags, context, area.offset()));
    let until = b.ins().load(I32, flags, records, 0);
    let until = b.ins().ireduce(I8, until);
    let (head, commit, exit) = (b.create_block(), b.create_block(), b.create_block());

    let mut arguments = vec![BlockArg::Value(count)];
    for (register, &place) in graph.registers.iter().zip(&layout.registers) {
        let ty = machine_type(register.width);
        arguments.push(BlockArg::Value(b.ins().load(ty, flags, areas[Area::Now as usize], place as i32)));
    }
    b.append_block_param(head, I64);
    let state: Vec<_> = graph.registers.iter().map(|r| b.append_block_param(head, machine_type(r.width))).collect();
    let left = b.block_params(head)[0];
    b.ins().jump(head, &arguments);

    b.switch_to_block(head);
    let loaded: Vec<_> = state.iter().copied().map(Some).collect();
    let outside = Everything { program, layout, areas, state: &loaded };
    let mut emitter = Emitter::new(b, graph, outside);
    let hot = needed_every_tick(program);
    hot.iter().zip(0..).filter(|(hot, _)| **hot).for_each(|(_, i)| emitter.emit(ValueId::new(i)));
    let next: Vec<_> = graph.registers.iter().zip(&state).map(|(r, &q)| emitter.committed(r, q)).collect();
    let writes: Vec<_> = (0..graph.rams.len())
        .map(|i| emitter.write(&graph.rams[i].write, &graph.rams[i].image, RamId::new(i)))
        .collect();
    let mut done = emitter.b.ins().icmp_imm_u(IntCC::Equal, left, 0);
    if let Some(stop) = program.stop {
        let stop = emitter.clean(stop);
        let stop = emitter.b.ins().band(stop, until);
        done = emitter.b.ins().bor(done, stop);
    }
    emitter.b.ins().brif(done, exit, &[], commit, &[]);

    emitter.b.switch_to_block(commit);
    for (place, data) in writes {
        emitter.b.ins().store(flags, data, place, 0);
    }
    let fewer = emitter.b.ins().iadd_imm_s(left, -1);
    let arguments: Vec<_> = [fewer].into_iter().chain(next.iter().copied()).map(BlockArg::Value).collect();
    emitter.b.ins().jump(head, &arguments);

    emitter.b.switch_to_block(exit);
    emitter.b.set_cold_block(exit);
    for (i, node) in graph.nodes.iter().enumerate() {
        if !hot[i] && !node.op.is_leaf() {
            emitter.emit(ValueId::new(i));
        }
    }
    let mut stored: Vec<_> = layout.wires.iter().collect();
    stored.sort_unstable();
    for (&id, &place) in stored {
        if !graph.node(id).op.is_leaf() {
            let value = emitter.clean(id);
            emitter.b.ins().store(flags, value, areas[Area::Wires as usize], place as i32);
        }
    }
    for ((&q, &next), &place) in state.iter().zip(&next).zip(&layout.registers) {
        emitter.b.ins().store(flags, q, areas[Area::Now as usize], place as i32);
        emitter.b.ins().store(flags, next, areas[Area::Next as usize], place as i32);
    }
    left
}

/// For each node whether the state to come or the stop condition depends on it; leaves are left out.
fn needed_every_tick(program: &Program) -> Vec<bool> {
    let graph = &program.graph;
    let mut needed = vec![false; graph.nodes.len()];
    graph.state_reads().chain(program.stop).for_each(|id| needed[id.index()] = true);
    for i in (0..needed.len()).rev() {
        if needed[i] {
            graph.nodes[i].op.operands(|id| needed[id.index()] = true);
            needed[i] = !graph.nodes[i].op.is_leaf();
        }
    }
    needed
}

/// All that one function for the whole program does not compute: inputs in memory, state there or in block parameters.
#[derive(Clone, Copy)]
pub(super) struct Everything<'a> {
    pub program: &'a Program,
    pub layout: &'a Layout,
    pub areas: [Value; Area::COUNT],
    /// By register: its word, unless it stands in `Area::Now`.
    pub state: &'a [Option<Value>],
}

impl Outside for Everything<'_> {
    fn fetch(&mut self, b: &mut FunctionBuilder<'_>, id: ValueId, width: u32) -> Value {
        let (area, place) = match self.program.graph.node(id).op {
            Op::Register(register) => match self.state[register.index()] {
                Some(word) => return word,
                None => (Area::Now, self.layout.registers[register.index()]),
            },
            _ => (Area::Wires, self.layout.wires[&id]),
        };
        b.ins().load(machine_type(width), MemFlagsData::trusted(), self.areas[area as usize], place as i32)
    }

    fn rom(&mut self, b: &mut FunctionBuilder<'_>, id: RomId) -> (Value, usize) {
        let depth = self.program.graph.roms[id.index()].image.depth();
        (b.ins().iadd_imm_u(self.areas[Area::Roms as usize], i64::from(self.layout.roms[id.index()])), depth)
    }

    fn ram(&mut self, b: &mut FunctionBuilder<'_>, id: RamId) -> (Value, usize) {
        let depth = self.program.graph.rams[id.index()].image.depth();
        (b.ins().iadd_imm_u(self.areas[Area::Rams as usize], i64::from(self.layout.rams[id.index()])), depth)
    }
}
