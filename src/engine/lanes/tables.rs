//! Three-operand tables: which small cones of gates become one operation.
//!
//! For every gate the best few cuts (sets of at most three earlier gates that determine it) are kept by *area flow*, the
//! number of operations that a cut costs when each shared one is split evenly among its users. The cover then takes the
//! best cut of each gate that is wanted, from the outputs back.

use std::collections::HashMap;

use super::gates::{Bit, Gate, Gates};
use super::segment::Segment;
use super::straight::{Cell, Function};

/// How many cuts of a gate are kept.
const CUTS: usize = 6;
/// The tables of the three operands themselves.
const OPERANDS: [u8; 3] = [0xF0, 0xCC, 0xAA];

/// Up to three gates, in increasing order, and the function of them that a gate is.
#[derive(Clone, Copy, PartialEq, Debug)]
struct Cut {
    leaves: [u32; 3],
    count: usize,
    table: u8,
    flow: f32,
}

impl Cut {
    fn leaves(&self) -> &[u32] {
        &self.leaves[..self.count]
    }

    /// The cut of a gate that is the gate itself.
    fn trivial(gate: usize, flow: f32) -> Self {
        Self { leaves: [gate as u32; 3], count: 1, table: OPERANDS[0], flow }
    }

    /// The table over more leaves.
    fn table_over(&self, leaves: &[u32]) -> u8 {
        let place = self.leaves().iter().map(|leaf| leaves.iter().position(|other| other == leaf).unwrap_or(0));
        let mut places = [0; 3];
        places.iter_mut().zip(place).for_each(|(to, from)| *to = from);
        let mut table = 0;
        for row in 0..8u8 {
            let bits = (0..self.count).map(|i| (row >> (2 - places[i]) & 1) << (2 - i));
            table |= (self.table >> bits.sum::<u8>() & 1) << row;
        }
        table
    }
}

/// The leaves of both cuts, if they are at most three.
fn union(a: &Cut, b: &Cut) -> Option<([u32; 3], usize)> {
    let mut all = [0; 3];
    let mut count = 0;
    let (mut i, mut j) = (0, 0);
    while i < a.count || j < b.count {
        let left = a.leaves().get(i).copied().unwrap_or(u32::MAX);
        let right = b.leaves().get(j).copied().unwrap_or(u32::MAX);
        if count == 3 {
            return None;
        }
        all[count] = left.min(right);
        count += 1;
        i += usize::from(left <= right);
        j += usize::from(right <= left);
    }
    Some((all, count))
}

/// For each needed gate its best cut; none for gates that are known.
pub(super) struct Cuts {
    best: HashMap<usize, Cut>,
}

impl Cuts {
    pub(super) fn of(gates: &Gates, segment: &Segment, needed: &[usize]) -> Self {
        let users = users(gates, segment, needed);
        let mut kept: HashMap<usize, Vec<Cut>> = HashMap::new();
        let mut best = HashMap::new();
        for &gate in needed {
            let (a, b, is_and) = match gates.gate(gate) {
                Gate::And(a, b) if !segment.known.contains_key(&gate) => (a, b, true),
                Gate::Xor(a, b) if !segment.known.contains_key(&gate) => (a, b, false),
                _ => {
                    kept.insert(gate, vec![Cut::trivial(gate, 0.0)]);
                    continue;
                }
            };
            let mut cuts = Vec::with_capacity(CUTS * CUTS);
            for cut_a in &kept[&a.gate()] {
                for cut_b in &kept[&b.gate()] {
                    cuts.extend(joined(cut_a, cut_b, a, b, is_and, &kept));
                }
            }
            cuts.sort_by(|a, b| a.flow.total_cmp(&b.flow).then(a.count.cmp(&b.count)));
            cuts.dedup_by(|a, b| a.leaves() == b.leaves());
            cuts.truncate(CUTS - 1);
            best.insert(gate, cuts[0]);
            let shared = cuts[0].flow / users[&gate].max(1) as f32;
            cuts.push(Cut::trivial(gate, shared));
            cuts.shrink_to_fit();
            kept.insert(gate, cuts);
        }
        Self { best }
    }
}

fn users(gates: &Gates, segment: &Segment, needed: &[usize]) -> HashMap<usize, u32> {
    let mut users: HashMap<usize, u32> = needed.iter().map(|&gate| (gate, 0)).collect();
    let mut count = |bit: Bit| *users.entry(bit.gate()).or_default() += 1;
    segment.sinks.iter().for_each(|&(bit, _)| count(bit));
    for &gate in needed.iter().filter(|gate| !segment.known.contains_key(gate)) {
        if let Gate::And(a, b) | Gate::Xor(a, b) = gates.gate(gate) {
            count(a);
            count(b);
        }
    }
    users
}

/// A gate over the leaves of a cut of each operand.
fn joined(cut_a: &Cut, cut_b: &Cut, a: Bit, b: Bit, is_and: bool, kept: &HashMap<usize, Vec<Cut>>) -> Option<Cut> {
    let (leaves, count) = union(cut_a, cut_b)?;
    let side = |cut: &Cut, bit: Bit| cut.table_over(&leaves[..count]) ^ if bit.is_complement() { 0xFF } else { 0 };
    let (x, y) = (side(cut_a, a), side(cut_b, b));
    let table = if is_and { x & y } else { x ^ y };
    // The trivial cut stands last and carries what a use of the gate costs.
    let cost = |leaf: &u32| kept[&(*leaf as usize)].last().map_or(0.0, |cut| cut.flow);
    let flow = 1.0 + leaves[..count].iter().map(cost).sum::<f32>();
    Some(Cut { leaves, count, table, flow })
}

/// The cells of the best cuts. A gate that is only wanted complemented is computed so.
pub(super) fn cells(cuts: &Cuts, segment: &Segment, gates: usize) -> Vec<Option<Cell>> {
    let mut plain = vec![false; gates];
    let mut complement = vec![false; gates];
    for (bit, _) in &segment.sinks {
        let wanted = if bit.is_complement() { &mut complement } else { &mut plain };
        wanted[bit.gate()] = true;
    }
    let kept = |gate: usize| complement[gate] && !plain[gate] && cuts.best.contains_key(&gate);
    let mut cells = vec![None; gates];
    for (&gate, cut) in &cuts.best {
        let mut table = cut.table;
        for (i, &leaf) in cut.leaves().iter().enumerate() {
            if kept(leaf as usize) {
                table = with_operand_complemented(table, i);
            }
        }
        if kept(gate) {
            table = !table;
        }
        let operands = [0, 1, 2].map(|i| cut.leaves[i.min(cut.count - 1)]);
        cells[gate] = Some(simplest(table, operands, cut.count, kept(gate)));
    }
    cells
}

fn with_operand_complemented(table: u8, operand: usize) -> u8 {
    let shift = 4 >> operand;
    let ones = OPERANDS[operand];
    (table & ones) >> shift | (table & !ones) << shift
}

/// Two-operand logic where it does, because it need not overwrite an operand.
fn simplest(table: u8, [a, b, c]: [u32; 3], count: usize, complement: bool) -> Cell {
    let [x, y, _] = OPERANDS;
    let (function, operands) = match table {
        _ if count == 3 => (Function::Table(table), [a, b, c]),
        _ if table == x & y => (Function::And, [a, b, b]),
        _ if table == x | y => (Function::Or, [a, b, b]),
        _ if table == x ^ y => (Function::Xor, [a, b, b]),
        _ if table == !x & y => (Function::AndNot, [a, b, b]),
        _ if table == x & !y => (Function::AndNot, [b, a, a]),
        _ => (Function::Table(table), [a, b, c]),
    };
    Cell { function, operands, complement }
}

/// The same function with its operands in another order: operand `order[i]` of the old table is the new one's `i`.
pub(super) fn reordered(table: u8, order: [usize; 3]) -> u8 {
    let mut new = 0;
    for row in 0..8u8 {
        let old: u8 = (0..3).map(|i| (row >> (2 - i) & 1) << (2 - order[i])).sum();
        new |= (table >> old & 1) << row;
    }
    new
}
