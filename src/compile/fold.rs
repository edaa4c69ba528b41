//! Fold: constants are computed, copies and idle ops vanish, equal ops of one module instance are computed once.

use std::collections::HashMap;

use super::{OwnerId, Program};
use crate::base::graph::evaluate;
use crate::base::word::mask;
use crate::base::{Graph, Node, Op, ValueId};

/// The folded program; its nodes are still in order, with some that nobody needs any more.
pub(super) fn fold(mut program: Program) -> Program {
    let mut folder = Folder { nodes: Vec::new(), owner: Vec::new(), known: HashMap::new() };
    let mut place: Vec<ValueId> = Vec::with_capacity(program.graph.nodes.len());
    for (node, &owner) in program.graph.nodes.iter().zip(&program.owner) {
        let op = node.op.map(|id| place[id.index()]);
        place.push(folder.simplify(Node { op, width: node.width }, owner));
    }
    let moved = |id: ValueId| place[id.index()];
    for register in &mut program.graph.registers {
        register.next = moved(register.next);
        register.enable = register.enable.map(moved);
        register.clear = register.clear.map(moved);
    }
    for ram in &mut program.graph.rams {
        let write = &mut ram.write;
        (write.enable, write.address, write.data) = (moved(write.enable), moved(write.address), moved(write.data));
    }
    program.map_observed(moved);
    program.graph = Graph { nodes: folder.nodes, ..program.graph };
    program.owner = folder.owner;
    program
}

struct Folder {
    nodes: Vec<Node>,
    owner: Vec<OwnerId>,
    /// By owner too: an op shared between instances would make their code differ and stop it from being shared.
    known: HashMap<(Node, OwnerId), ValueId>,
}

impl Folder {
    fn push(&mut self, node: Node, owner: OwnerId) -> ValueId {
        *self.known.entry((node, owner)).or_insert_with(|| {
            self.nodes.push(node);
            self.owner.push(owner);
            ValueId::new(self.nodes.len() - 1)
        })
    }

    fn simplify(&mut self, node: Node, owner: OwnerId) -> ValueId {
        match simplify(&self.nodes, node) {
            Simple::Constant(value) => self.push(Node { op: Op::Const(value), width: node.width }, owner),
            Simple::Same(same) => same,
            Simple::Op => self.push(node, owner),
        }
    }
}

/// What an op comes to, given what its operands are.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Simple {
    /// A constant: all its operands are.
    Constant(u64),
    /// It only passes on this value.
    Same(ValueId),
    /// Itself.
    Op,
}

/// What `node` comes to, whose operands are among `nodes`.
#[must_use]
pub fn simplify(nodes: &[Node], node: Node) -> Simple {
    let operands = Operands(nodes);
    if let Some(value) = operands.computed(node) {
        return Simple::Constant(value);
    }
    operands.idle(node).map_or(Simple::Op, Simple::Same)
}

/// The nodes that operands are among.
struct Operands<'a>(&'a [Node]);

impl Operands<'_> {
    fn node(&self, id: ValueId) -> Node {
        self.0[id.index()]
    }

    fn constant(&self, id: ValueId) -> Option<u64> {
        match self.node(id).op {
            Op::Const(value) => Some(value),
            _ => None,
        }
    }

    /// The value when all operands are constants.
    fn computed(&self, node: Node) -> Option<u64> {
        let mut operands = [0; 3];
        let mut count = 0;
        let mut all_known = !node.op.is_leaf();
        let mut operand_width = node.width;
        node.op.operands(|id| {
            match self.constant(id) {
                Some(value) => operands[count] = value,
                None => all_known = false,
            }
            if count == 0 || matches!(node.op, Op::Concat(..)) {
                operand_width = self.node(id).width;
            }
            count += 1;
        });
        if all_known { evaluate(node.op, node.width, operand_width, operands) } else { None }
    }

    /// The operand that the op only passes on, if it does.
    fn idle(&self, node: Node) -> Option<ValueId> {
        let is = |id: ValueId, value: u64| self.constant(id) == Some(value);
        let ones = mask(node.width);
        match node.op {
            Op::Copy(a) => Some(a),
            Op::And(a, b) if a == b || is(b, ones) || is(a, 0) => Some(a),
            Op::And(a, b) if is(a, ones) || is(b, 0) => Some(b),
            Op::Or(a, b) if a == b || is(b, 0) || is(a, ones) => Some(a),
            Op::Or(a, b) if is(a, 0) || is(b, ones) => Some(b),
            Op::Xor(a, b) | Op::Add(a, b) if is(b, 0) => Some(a).filter(|_| a != b),
            Op::Xor(a, b) | Op::Add(a, b) if is(a, 0) => Some(b),
            Op::Sub(a, b) | Op::Shl(a, b) | Op::ShrU(a, b) | Op::ShrS(a, b) if is(b, 0) => Some(a),
            Op::Mux(_, a, b) if a == b => Some(a),
            Op::Mux(s, a, _) if self.constant(s).is_some_and(|s| s != 0) => Some(a),
            Op::Mux(s, _, b) if is(s, 0) => Some(b),
            Op::Mux(s, a, b) if node.width == 1 && is(a, 1) && is(b, 0) => Some(s),
            Op::Not(a) => match self.node(a).op {
                Op::Not(b) => Some(b),
                _ => None,
            },
            Op::ReduceAnd(a) | Op::ReduceOr(a) | Op::ReduceXor(a) if self.node(a).width == 1 => Some(a),
            Op::Slice(a, 0) | Op::ZeroExtend(a) | Op::SignExtend(a) if self.node(a).width == node.width => Some(a),
            Op::Slice(a, low) => self.sliced(a, low, node.width),
            _ => None,
        }
    }

    /// A slice that is just one part of a concatenation.
    fn sliced(&self, a: ValueId, low: u32, width: u32) -> Option<ValueId> {
        let Op::Concat(high_part, low_part) = self.node(a).op else { return None };
        let split = self.node(low_part).width;
        let (part, low) = if low >= split { (high_part, low - split) } else { (low_part, low) };
        match self.node(part).width {
            whole if low == 0 && whole == width => Some(part),
            whole if low + width <= whole => self.sliced(part, low, width),
            _ => None,
        }
    }
}
