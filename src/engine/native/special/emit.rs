//! The code of a tree: the tick loop with a path to each leaf.

use std::collections::HashMap;

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::{I8, I32, I64};
use cranelift_codegen::ir::{Block, BlockArg, InstBuilder, MemFlagsData, Value};
use cranelift_frontend::FunctionBuilder;

use super::tree::Tree;
use super::view::{Commit, View};
use crate::base::{Diagnostic, Op, RamId, Register, ValueId};
use crate::compile::Program;
use crate::engine::native::fused::Everything;
use crate::engine::native::host::{Assembler, Records};
use crate::engine::native::memory::{Area, Layout};
use crate::engine::native::ops::Emitter;
use crate::engine::native::word::Word;

const FLAGS: MemFlagsData = MemFlagsData::trusted();

/// Compiles the function. Its count is how many ticks to advance, its records one word: whether to stop when the
/// program's `stop` is 1. It goes on from the tick whose state is in `Area::Now`, leaves there the state of the tick at
/// which it ends, and returns how many ticks were left: more than 0 at a stop, or where the tree says that the plain
/// code shall go on. It touches nothing else but the words of memories.
///
/// Registers stand in memory, and a leaf loads and stores just those that it touches. Measured: block parameters for those
/// that most ticks change are no faster.
///
/// ```text
/// head:   none left? -> exit
///         the tree; its rest -> exit
/// leaf:   what is left of the tick; stop? -> exit
///         write memories; store the registers that change; -> head
/// ```
pub(super) fn compile(
    assembler: &mut Assembler,
    program: &Program,
    layout: &Layout,
    tree: &Tree,
) -> Result<usize, Diagnostic> {
    assembler.function(Records::One(1), |b, [context, records, count]| {
        let areas = Area::ALL.map(|area| b.ins().load(I64, FLAGS, context, area.offset()));
        let until = b.ins().load(I32, FLAGS, records, 0);
        let until = b.ins().ireduce(I8, until);
        let [head, start, exit] = [(); 3].map(|()| b.create_block());
        let left = b.append_block_param(head, I64);
        b.ins().jump(head, &[BlockArg::Value(count)]);

        b.switch_to_block(head);
        let over = b.ins().icmp_imm_u(IntCC::Equal, left, 0);
        b.ins().brif(over, exit, &[], start, &[]);
        b.switch_to_block(start);
        let state = vec![None; program.graph.registers.len()];
        let outside = Everything { program, layout, areas, state: &state };
        Emission { b, outside, until, left, head, exit }.tree(tree, HashMap::new());

        b.switch_to_block(exit);
        left
    })
}

struct Emission<'a, 'f> {
    b: &'a mut FunctionBuilder<'f>,
    outside: Everything<'a>,
    until: Value,
    left: Value,
    head: Block,
    exit: Block,
}

impl<'f> Emission<'_, 'f> {
    /// The code of a tree into the present block; `words` are those of the values computed so far.
    fn tree(&mut self, tree: &Tree, words: HashMap<ValueId, Word>) {
        match tree {
            Tree::Rest => {
                self.b.ins().jump(self.exit, &[]);
            }
            Tree::Leaf { view, .. } => self.leaf(view, words),
            Tree::Fork { on, view, branches } => {
                let mut emitter = Emitter::with(self.b, &view.graph, self.outside, unknown(view, words));
                need(&mut emitter, view, [*on]);
                let bit = emitter.clean(*on);
                let words = emitter.into_words();
                let [low, high] = [self.b.create_block(), self.b.create_block()];
                self.b.ins().brif(bit, high, &[], low, &[]);
                for (block, branch) in [low, high].into_iter().zip(&**branches) {
                    self.b.switch_to_block(block);
                    self.tree(branch, words.clone());
                }
            }
        }
    }

    fn leaf(&mut self, view: &View, words: HashMap<ValueId, Word>) {
        let program = self.outside.program;
        let mut emitter = Emitter::with(self.b, &view.graph, self.outside, unknown(view, words));
        need(&mut emitter, view, view.live.iter().copied());
        let next: Vec<_> = view.commits.iter().map(|commit| committed(&mut emitter, commit)).collect();
        let place = |(id, write): &(RamId, _)| emitter.write(write, &program.graph.rams[id.index()].image, *id);
        let writes: Vec<_> = view.writes.iter().map(place).collect();
        if let Some(stop) = view.stop {
            let stop = emitter.clean(stop);
            let stop = emitter.b.ins().band(stop, self.until);
            let on = emitter.b.create_block();
            emitter.b.ins().brif(stop, self.exit, &[], on, &[]);
            emitter.b.switch_to_block(on);
        }
        for (place, data) in writes {
            self.b.ins().store(FLAGS, data, place, 0);
        }
        for (commit, &next) in view.commits.iter().zip(&next) {
            let place = self.outside.layout.registers[commit.id.index()] as i32;
            self.b.ins().store(FLAGS, next, self.outside.areas[Area::Now as usize], place);
        }
        let fewer = self.b.ins().iadd_imm_s(self.left, -1);
        self.b.ins().jump(self.head, &[BlockArg::Value(fewer)]);
    }
}

/// The words that have not turned out to be constants.
fn unknown(view: &View, mut words: HashMap<ValueId, Word>) -> HashMap<ValueId, Word> {
    words.retain(|&id, _| !matches!(view.graph.node(id).op, Op::Const(_)));
    words
}

/// Emits what is missing of the live values that these need, in their order.
fn need(emitter: &mut Emitter<'_, '_, Everything<'_>>, view: &View, wanted: impl IntoIterator<Item = ValueId>) {
    let mut needed = vec![false; view.graph.nodes.len()];
    wanted.into_iter().for_each(|id| needed[id.index()] = true);
    let mut missing = Vec::new();
    for &id in view.live.iter().rev() {
        let node = view.graph.node(id);
        if needed[id.index()] && !node.op.is_leaf() && !emitter.has(id) {
            node.op.operands(|id| needed[id.index()] = true);
            missing.push(id);
        }
    }
    missing.into_iter().rev().for_each(|id| emitter.emit(id));
}

/// What a register holds at the next tick.
fn committed(emitter: &mut Emitter<'_, '_, Everything<'_>>, commit: &Commit) -> Value {
    match commit.register {
        Register { enable: None, clear: None, next, .. } => emitter.clean(next),
        register => {
            let q = emitter.clean(commit.q);
            emitter.committed(&register, q)
        }
    }
}
