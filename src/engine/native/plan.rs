//! The plan of a large program: which items make up one unit of code, and in which order units run.
//!
//! An item is an op or the commit of a register. A group may need values of another that in turn needs some of its
//! own, so a group is cut into levels: an item's level is one higher than that of any item of another group that
//! it reads. Units (all items of one group at one level) never wait for each other in a circle, whatever the
//! circuit. An item is moved to the latest level that its readers allow, which leaves few levels to a group.

use std::collections::BTreeMap;

use super::group::FLAT;
use crate::base::{Graph, Op, RegisterId, ValueId};

/// Ops of one function at most: compile time grows faster than the function.
const UNIT_OPS: usize = 2000;

/// Something to compute.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) enum Item {
    /// An op.
    Value(ValueId),
    /// What a register holds at the next tick.
    Commit(RegisterId),
}

/// Items whose code is one function. Their operands stand before them or in units before this one.
#[derive(Debug)]
pub(super) struct Unit {
    /// Units of one level do not read each other, but for those of [`FLAT`], which follow each other.
    pub level: u32,
    pub group: u32,
    pub items: Vec<Item>,
}

/// Whose code computes what.
#[derive(Clone, Debug)]
pub(super) struct Assignment {
    /// The group of each value, then of each register's commit.
    groups: Vec<u32>,
    values: usize,
}

impl Assignment {
    /// Values by their own group, commits with the value they load, or with the register when that is a leaf.
    pub fn new(graph: &Graph, group: &[u32]) -> Self {
        let mut groups = group.to_vec();
        let mut home = vec![FLAT; graph.registers.len()];
        for (node, &group) in graph.nodes.iter().zip(group) {
            if let Op::Register(register) = node.op {
                home[register.index()] = group;
            }
        }
        groups.extend(graph.registers.iter().zip(home).map(|(register, home)| {
            if graph.node(register.next).op.is_leaf() { home } else { group[register.next.index()] }
        }));
        Self { groups, values: group.len() }
    }

    fn index(&self, item: Item) -> usize {
        match item {
            Item::Value(id) => id.index(),
            Item::Commit(register) => self.values + register.index(),
        }
    }

    fn item(&self, index: usize) -> Item {
        match index.checked_sub(self.values) {
            None => Item::Value(ValueId::new(index)),
            Some(register) => Item::Commit(RegisterId::new(register)),
        }
    }

    /// Takes a unit's items out of their group.
    pub fn dissolve(&mut self, unit: &Unit) {
        for &item in &unit.items {
            let index = self.index(item);
            self.groups[index] = FLAT;
        }
    }

    /// All units, in an order in which each follows those it reads.
    pub fn units(&self, graph: &Graph) -> Vec<Unit> {
        let levels = self.levels(graph);
        let mut units: BTreeMap<(u32, u32), Vec<Item>> = BTreeMap::new();
        for (index, (&level, &group)) in levels.iter().zip(&self.groups).enumerate() {
            if self.is_computed(graph, index) {
                units.entry((level, group)).or_default().push(self.item(index));
            }
        }
        let cut = units.into_iter().flat_map(|((level, group), items)| {
            let most = if group == FLAT { UNIT_OPS } else { items.len() };
            let parts: Vec<_> = items.chunks(most).map(<[Item]>::to_vec).collect();
            parts.into_iter().map(move |items| Unit { level, group, items })
        });
        cut.collect()
    }

    fn is_computed(&self, graph: &Graph, index: usize) -> bool {
        index >= self.values || !graph.nodes[index].op.is_leaf()
    }

    /// The level of each item, as late as possible.
    fn levels(&self, graph: &Graph) -> Vec<u32> {
        let earliest = self.earliest(graph);
        let mut last = vec![0; self.groups.iter().max().map_or(1, |&group| group as usize + 1)];
        for (&group, &level) in self.groups.iter().zip(&earliest) {
            let last: &mut u32 = &mut last[group as usize];
            *last = level.max(*last);
        }
        let mut levels: Vec<u32> = self.groups.iter().map(|&group| last[group as usize]).collect();
        for index in (0..levels.len()).rev() {
            operands(graph, self.item(index), |id| {
                let hop = u32::from(self.groups[id.index()] != self.groups[index]);
                // A leaf has no level of its own: no code computes it.
                if !graph.node(id).op.is_leaf() {
                    levels[id.index()] = levels[id.index()].min(levels[index] - hop);
                }
            });
        }
        levels
    }

    fn earliest(&self, graph: &Graph) -> Vec<u32> {
        let mut levels = vec![0; self.groups.len()];
        for index in 0..levels.len() {
            let mut level = 0;
            operands(graph, self.item(index), |id| {
                if !graph.node(id).op.is_leaf() {
                    level = level.max(levels[id.index()] + u32::from(self.groups[id.index()] != self.groups[index]));
                }
            });
            levels[index] = level;
        }
        levels
    }
}

/// Calls `visit` for every value that an item reads.
pub(super) fn operands(graph: &Graph, item: Item, mut visit: impl FnMut(ValueId)) {
    match item {
        Item::Value(id) => graph.node(id).op.operands(visit),
        Item::Commit(register) => {
            let register = &graph.registers[register.index()];
            [Some(register.next), register.enable, register.clear].into_iter().flatten().for_each(&mut visit);
        }
    }
}
