//! A program's tick as it is while some of its values are known: what they make constant or equal is worked out, and
//! what is left of the ops and of the state that can change.

use crate::base::word::mask;
use crate::base::{Graph, MemoryWrite, Node, Op, RamId, Register, RegisterId, ValueId};
use crate::compile::{Program, Simple, simplify};
use crate::engine::Work;

/// The tick under some assumptions. Values keep the numbers they have in the program.
#[derive(Clone)]
pub(super) struct View {
    /// Ops with operands that are roots. Of a live value it is what is left to compute.
    pub graph: Graph,
    /// A value that each is equal to, itself for a root.
    same: Vec<ValueId>,
    /// Values that the commits, the writes and the stop condition depend on, each after its operands.
    pub live: Vec<ValueId>,
    /// Registers that may change, by what they load; `q` is the value of the present content.
    pub commits: Vec<Commit>,
    /// Memories that may be written.
    pub writes: Vec<(RamId, MemoryWrite)>,
    /// The stop condition, unless it is known to be 0.
    pub stop: Option<ValueId>,
}

/// A register that may change at the end of the tick.
#[derive(Clone, Copy)]
pub(super) struct Commit {
    pub id: RegisterId,
    /// Its present content.
    pub q: ValueId,
    /// What it loads, and when.
    pub register: Register,
}

impl View {
    /// The tick with nothing known.
    pub fn new(program: &Program, register_nodes: &[ValueId]) -> Self {
        let graph = &program.graph;
        let commits = graph.registers.iter().zip(register_nodes).enumerate();
        let commits = commits.map(|(i, (&register, &q))| Commit { id: RegisterId::new(i), q, register });
        let writes = graph.rams.iter().enumerate().map(|(i, ram)| (RamId::new(i), ram.write));
        let mut view = Self {
            same: (0..graph.nodes.len()).map(ValueId::new).collect(),
            live: (0..graph.nodes.len()).map(ValueId::new).collect(),
            commits: commits.collect(),
            writes: writes.collect(),
            stop: program.stop,
            graph: Graph { nodes: graph.nodes.clone(), ..Graph::default() },
        };
        view.trim();
        view
    }

    /// The tick when in addition a live value of one bit is known.
    pub fn assuming(&self, id: ValueId, bit: bool) -> Self {
        let mut view = self.clone();
        let facts = self.facts(id, bit);
        for &id in &self.live {
            let node = view.graph.node(id);
            let node = Node { op: node.op.map(|operand| view.root(operand)), ..node };
            let simple = match facts[id.index()] {
                Some(word) => Simple::Constant(word),
                None => simplify(&view.graph.nodes, node),
            };
            match simple {
                Simple::Constant(word) => view.graph.nodes[id.index()].op = Op::Const(word),
                Simple::Same(root) => view.same[id.index()] = view.root(root),
                Simple::Op => view.graph.nodes[id.index()] = node,
            }
        }
        view.commits = self.commits.iter().filter_map(|commit| view.committed(commit)).collect();
        view.writes = self.writes.iter().filter_map(|&(ram, write)| Some((ram, view.written(write)?))).collect();
        view.stop = self.stop.map(|stop| view.root(stop)).filter(|&stop| view.constant(stop) != Some(0));
        view.trim();
        view
    }

    /// The value that one is equal to.
    pub fn root(&self, mut id: ValueId) -> ValueId {
        while self.same[id.index()] != id {
            id = self.same[id.index()];
        }
        id
    }

    /// Its word, if it is known.
    pub fn constant(&self, id: ValueId) -> Option<u64> {
        match self.graph.node(self.root(id)).op {
            Op::Const(word) => Some(word),
            _ => None,
        }
    }

    /// What is left to do.
    pub fn work(&self) -> Work {
        let ops = self.live.iter().filter(|&&id| !self.graph.node(id).op.is_leaf()).count();
        Work { ops, registers: self.commits.len() }
    }

    /// About how many machine operations a tick takes.
    pub fn cost(&self) -> f64 {
        let ops = self.work().ops;
        let controls = |r: &Register| usize::from(r.enable.is_some()) + usize::from(r.clear.is_some());
        let commits: usize = self.commits.iter().map(|commit| 1 + controls(&commit.register)).sum();
        (ops + commits + 3 * self.writes.len()) as f64
    }

    /// By value: the word that it must have, when a value of one bit is known.
    fn facts(&self, id: ValueId, bit: bool) -> Vec<Option<u64>> {
        let mut facts = vec![None; self.graph.nodes.len()];
        facts[id.index()] = Some(bit.into());
        for &id in self.live.iter().rev() {
            if let Some(word) = facts[id.index()] {
                self.implied(id, word, |id, word| {
                    if self.constant(id).is_none() {
                        facts[id.index()] = Some(word);
                    }
                });
            }
        }
        facts
    }

    /// Tells which words the operands of an op must have, if its own word leaves no choice.
    fn implied(&self, id: ValueId, word: u64, mut tell: impl FnMut(ValueId, u64)) {
        let node = self.graph.node(id);
        match node.op {
            Op::Not(a) => tell(a, !word & mask(node.width)),
            Op::And(a, b) if word == mask(node.width) => [a, b].into_iter().for_each(|id| tell(id, word)),
            Op::Or(a, b) if word == 0 => [a, b].into_iter().for_each(|id| tell(id, word)),
            Op::Eq(a, b) if word == 1 => {
                if let Some(word) = self.constant(b) {
                    tell(a, word);
                } else if let Some(word) = self.constant(a) {
                    tell(b, word);
                }
            }
            Op::ReduceOr(a) if word == 0 => tell(a, 0),
            Op::ReduceAnd(a) if word == 1 => tell(a, mask(self.graph.width(a))),
            _ => {}
        }
    }

    /// What is left of a commit; `None` when the register keeps its word.
    fn committed(&mut self, commit: &Commit) -> Option<Commit> {
        let mut register = Register { next: self.root(commit.register.next), ..commit.register };
        register.enable = register.enable.map(|id| self.root(id));
        register.clear = register.clear.map(|id| self.root(id));
        match register.clear.map(|id| self.constant(id)) {
            Some(Some(0)) => register.clear = None,
            Some(Some(_)) => {
                register.next = self.push(Node { op: Op::Const(register.init), width: register.width });
                (register.clear, register.enable) = (None, None);
            }
            _ => {}
        }
        let q = self.root(commit.q);
        match register.enable.map(|id| self.constant(id)) {
            Some(Some(0)) => (register.next, register.enable) = (q, None),
            Some(Some(_)) => register.enable = None,
            _ => {}
        }
        let keeps = register.clear.is_none() && self.is_same(register.next, q);
        (!keeps).then_some(Commit { q, register, ..*commit })
    }

    /// What is left of a write; `None` when nothing is written.
    fn written(&self, write: MemoryWrite) -> Option<MemoryWrite> {
        let [enable, address, data] = [write.enable, write.address, write.data].map(|id| self.root(id));
        (self.constant(enable) != Some(0)).then_some(MemoryWrite { enable, address, data })
    }

    fn is_same(&self, a: ValueId, b: ValueId) -> bool {
        a == b || self.constant(a).is_some_and(|word| self.constant(b) == Some(word))
    }

    fn push(&mut self, node: Node) -> ValueId {
        let id = ValueId::new(self.graph.nodes.len());
        self.graph.nodes.push(node);
        self.same.push(id);
        id
    }

    /// Drops from what is live what nobody needs.
    fn trim(&mut self) {
        let mut needed = vec![false; self.graph.nodes.len()];
        let mut need = |id: ValueId| needed[id.index()] = true;
        for Commit { q, register, .. } in &self.commits {
            [Some(register.next), register.enable, register.clear].into_iter().flatten().for_each(&mut need);
            // What is not loaded at every tick is chosen between the new word and the old one.
            register.enable.map(|_| *q).into_iter().for_each(&mut need);
        }
        self.writes.iter().flat_map(|(_, write)| [write.enable, write.address, write.data]).for_each(&mut need);
        self.stop.into_iter().for_each(need);
        for &id in self.live.iter().rev() {
            if needed[id.index()] {
                self.graph.node(id).op.operands(|id| needed[id.index()] = true);
            }
        }
        let is_left = |id: &ValueId| needed[id.index()] && !matches!(self.graph.node(*id).op, Op::Const(_));
        self.live.retain(is_left);
    }
}
