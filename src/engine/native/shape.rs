//! Shapes: a unit of code with everything numbered from its own point of view. Units of one shape share one function.

use std::collections::HashMap;

use super::memory::{Area, Home, Layout};
use super::plan::{Item, Unit, operands};
use crate::base::{Graph, Node, Op, RamId, Register, RegisterId, RomId, ValueId};

/// Where something stands in an area.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(super) enum Site {
    /// So many bytes after the start of what belongs to the group.
    Own(u32),
    /// At the offset in the area that this word of the record holds. The first three words of a record are where
    /// the group's own state, wires and RAMs start.
    Imported(u32),
}

/// A unit from its own point of view.
#[derive(PartialEq, Eq, Hash, Default, Debug)]
pub(super) struct Shape {
    /// Ops after their operands; `Op::Input(i)` is `outside[i]`, RAMs are numbered by `rams`, ROMs by `roms`.
    pub nodes: Vec<Node>,
    /// Where values are that other code has computed, and registers.
    pub outside: Vec<(Area, Site)>,
    /// Values that are stored for others.
    pub stores: Vec<(ValueId, Site)>,
    /// Registers to commit, the node of their present content, and where they are.
    pub commits: Vec<(Register, ValueId, Site)>,
    /// Where RAMs are, and their depth.
    pub rams: Vec<(Site, usize)>,
    /// Where ROMs are (the same for all), and their depth.
    pub roms: Vec<(u32, usize)>,
}

impl Shape {
    /// The nodes as a graph of their own.
    pub fn graph(&self) -> Graph {
        Graph { nodes: self.nodes.clone(), ..Graph::default() }
    }
}

/// What shapes are cut from.
pub(super) struct Whole<'a> {
    pub graph: &'a Graph,
    pub layout: &'a Layout,
    /// The group in whose part of the memory each node's register or wire stands.
    pub homes: &'a [u32],
    /// The node of each register.
    pub register_nodes: &'a [ValueId],
}

impl Whole<'_> {
    /// The shape of a unit, and the record that tells its function where this one's own and imported words are.
    pub fn shape(&self, unit: &Unit) -> (Shape, Vec<u32>) {
        let home = self.layout.homes[unit.group as usize];
        let record = vec![home.state, home.wires, home.rams];
        let mut cutter =
            Cutter { whole: self, group: unit.group, home, record, shape: Shape::default(), known: HashMap::new() };
        for &item in &unit.items {
            cutter.item(item);
        }
        (cutter.shape, cutter.record)
    }
}

struct Cutter<'a> {
    whole: &'a Whole<'a>,
    group: u32,
    home: Home,
    record: Vec<u32>,
    shape: Shape,
    known: HashMap<ValueId, ValueId>,
}

impl Cutter<'_> {
    fn item(&mut self, item: Item) {
        operands(self.whole.graph, item, |id| self.need(id));
        match item {
            Item::Value(id) => self.value(id),
            Item::Commit(id) => self.commit(id),
        }
    }

    /// Makes sure that a value has a node here.
    fn need(&mut self, id: ValueId) {
        if self.known.contains_key(&id) {
            return;
        }
        let graph = self.whole.graph;
        let node = graph.node(id);
        if let Op::Const(_) = node.op {
            self.push(id, node);
            return;
        }
        let (area, place) = match node.op {
            Op::Register(register) => (Area::Now, self.whole.layout.registers[register.index()]),
            _ => (Area::Wires, self.whole.layout.wires[&id]),
        };
        let site = self.site(self.whole.homes[id.index()], area, place);
        let input = Op::Input(self.shape.outside.len() as u32);
        self.shape.outside.push((area, site));
        self.push(id, Node { op: input, ..node });
    }

    fn push(&mut self, id: ValueId, node: Node) {
        self.known.insert(id, ValueId::new(self.shape.nodes.len()));
        self.shape.nodes.push(node);
    }

    fn site(&mut self, home: u32, area: Area, place: u32) -> Site {
        if home != self.group {
            self.record.push(place);
            return Site::Imported((self.record.len() - 1) as u32);
        }
        Site::Own(
            place
                - match area {
                    Area::Now | Area::Next => self.home.state,
                    Area::Wires => self.home.wires,
                    Area::Rams => self.home.rams,
                    Area::Roms => 0,
                },
        )
    }

    fn value(&mut self, id: ValueId) {
        let node = self.whole.graph.node(id);
        let op = match node.op.map(|operand| self.known[&operand]) {
            Op::RomRead(rom, address) => Op::RomRead(self.rom(rom), address),
            Op::RamRead(ram, address) => Op::RamRead(self.ram(ram), address),
            op => op,
        };
        self.push(id, Node { op, ..node });
        if let Some(&place) = self.whole.layout.wires.get(&id) {
            let site = self.site(self.whole.homes[id.index()], Area::Wires, place);
            self.shape.stores.push((self.known[&id], site));
        }
    }

    fn rom(&mut self, rom: RomId) -> RomId {
        let depth = self.whole.graph.roms[rom.index()].image.depth();
        self.shape.roms.push((self.whole.layout.roms[rom.index()], depth));
        RomId::new(self.shape.roms.len() - 1)
    }

    fn ram(&mut self, ram: RamId) -> RamId {
        let depth = self.whole.graph.rams[ram.index()].image.depth();
        let layout = self.whole.layout;
        let site = self.site(layout.ram_homes[ram.index()], Area::Rams, layout.rams[ram.index()]);
        self.shape.rams.push((site, depth));
        RamId::new(self.shape.rams.len() - 1)
    }

    fn commit(&mut self, id: RegisterId) {
        let register = self.whole.graph.registers[id.index()];
        let q = self.whole.register_nodes[id.index()];
        self.need(q);
        let here = |id: ValueId| self.known[&id];
        let local = Register {
            next: here(register.next),
            enable: register.enable.map(here),
            clear: register.clear.map(here),
            // Without a clear the power-on word is none of the code's business.
            init: register.clear.map_or(0, |_| register.init),
            ..register
        };
        let q_here = here(q);
        let site = self.site(self.whole.homes[q.index()], Area::Next, self.whole.layout.registers[id.index()]);
        self.shape.commits.push((local, q_here, site));
    }
}
