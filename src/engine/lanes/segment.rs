//! Segments: the network cut where it must wait for a look-up, and a place in memory for every plane that outlives one.

use std::collections::HashMap;

use super::gates::{Bit, Gate, Gates};
use super::lower::{Lowered, Memory};
use crate::base::{RamId, ValueId};

/// Where a plane stands.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(super) enum Place {
    /// Constants, inputs, words looked up, what crosses from one segment to a later one, spilled values.
    Fixed(u32),
    /// State of the present tick.
    Now(u32),
    /// State of the next tick.
    Next(u32),
    /// What is recorded of the present tick.
    History(u32),
}

/// The plane of zeros.
pub(super) const ZEROS: u32 = 0;
/// The plane of ones.
pub(super) const ONES: u32 = 1;

/// Gates that can be computed in one go.
#[derive(Debug)]
pub(super) struct Segment {
    /// Gates that are known before it, and where.
    pub(super) known: HashMap<usize, Place>,
    /// What it must put where.
    pub(super) sinks: Vec<(Bit, Place)>,
}

/// A read of a large memory; planes are [`Place::Fixed`].
#[derive(Clone, Debug)]
pub(super) struct Lookup {
    pub(super) memory: Memory,
    pub(super) address: Vec<u32>,
    pub(super) word: Vec<u32>,
}

/// A write to a large RAM; planes are [`Place::Fixed`].
#[derive(Clone, Debug)]
pub(super) struct Store {
    pub(super) ram: RamId,
    pub(super) enable: u32,
    pub(super) address: Vec<u32>,
    pub(super) data: Vec<u32>,
}

/// Where everything is.
#[derive(Clone, Debug, Default)]
pub(super) struct Layout {
    /// Number of [`Place::Fixed`] planes, spills not counted.
    pub(super) fixed: u32,
    /// Number of planes that one tick leaves in the history.
    pub(super) history: u32,
    /// For each plane of state its value at power-on.
    pub(super) init: Vec<bool>,
    /// For each input its [`Place::Fixed`] planes.
    pub(super) inputs: Vec<Vec<u32>>,
    /// For each wanted value its [`Place::History`] planes.
    pub(super) values: HashMap<ValueId, Vec<u32>>,
    /// Look-ups to make after each segment.
    pub(super) lookups: Vec<Vec<Lookup>>,
    /// Writes to make when the tick is over.
    pub(super) stores: Vec<Store>,
}

/// Cuts a network into segments and lays its planes out.
pub(super) fn segment(lowered: &Lowered) -> (Layout, Vec<Segment>) {
    let stages = lowered.lookups.iter().map(|l| lowered.gates.stage(l.word[0])).max().unwrap_or(0) + 1;
    let mut cutter = Cutter {
        gates: &lowered.gates,
        layout: Layout { fixed: ONES + 1, ..Layout::default() },
        known: HashMap::from([(Bit::FALSE.gate(), Place::Fixed(ZEROS))]),
        sinks: (0..stages).map(|_| Vec::new()).collect(),
        recorded: HashMap::new(),
    };
    cutter.place_inputs(lowered);
    cutter.place_memories(lowered, stages as usize);
    for (i, state) in lowered.states.iter().enumerate() {
        cutter.known.insert(state.now.gate(), Place::Now(i as u32));
        cutter.layout.init.push(state.init);
        cutter.sink(state.next, Place::Next(i as u32));
    }
    let mut values: Vec<_> = lowered.values.iter().collect();
    values.sort_unstable_by_key(|(id, _)| **id);
    for (&id, bits) in values {
        let planes = bits.iter().map(|&bit| cutter.record(bit)).collect();
        cutter.layout.values.insert(id, planes);
    }
    cutter.finish()
}

struct Cutter<'a> {
    gates: &'a Gates,
    layout: Layout,
    known: HashMap<usize, Place>,
    sinks: Vec<Vec<(Bit, Place)>>,
    recorded: HashMap<Bit, u32>,
}

impl Cutter<'_> {
    fn fixed(&mut self) -> u32 {
        self.layout.fixed += 1;
        self.layout.fixed - 1
    }

    fn sink(&mut self, bit: Bit, place: Place) {
        self.sinks[self.gates.stage(bit) as usize].push((bit, place));
    }

    fn known_planes(&mut self, bits: &[Bit]) -> Vec<u32> {
        let planes: Vec<_> = bits.iter().map(|_| self.fixed()).collect();
        self.known.extend(bits.iter().zip(&planes).map(|(bit, &plane)| (bit.gate(), Place::Fixed(plane))));
        planes
    }

    fn sink_planes(&mut self, bits: &[Bit]) -> Vec<u32> {
        let sink = |&bit: &Bit| {
            let plane = self.fixed();
            self.sink(bit, Place::Fixed(plane));
            plane
        };
        bits.iter().map(sink).collect()
    }

    fn place_inputs(&mut self, lowered: &Lowered) {
        for bits in &lowered.inputs {
            let planes = self.known_planes(bits);
            self.layout.inputs.push(planes);
        }
    }

    fn place_memories(&mut self, lowered: &Lowered, stages: usize) {
        self.layout.lookups = vec![Vec::new(); stages];
        for lookup in &lowered.lookups {
            let stage = self.gates.stage(lookup.word[0]) as usize - 1;
            let address = self.sink_planes(&lookup.address);
            let word = self.known_planes(&lookup.word);
            self.layout.lookups[stage].push(Lookup { memory: lookup.memory, address, word });
        }
        for store in &lowered.stores {
            let enable = self.sink_planes(&[store.enable])[0];
            let (address, data) = (self.sink_planes(&store.address), self.sink_planes(&store.data));
            self.layout.stores.push(Store { ram: store.ram, enable, address, data });
        }
    }

    /// The plane of the history that holds `bit`.
    fn record(&mut self, bit: Bit) -> u32 {
        if let Some(&plane) = self.recorded.get(&bit) {
            return plane;
        }
        let plane = self.layout.history;
        self.layout.history += 1;
        self.recorded.insert(bit, plane);
        self.sink(bit, Place::History(plane));
        plane
    }

    /// From the last segment to the first: a gate of an earlier one becomes a sink there and is known here.
    fn finish(mut self) -> (Layout, Vec<Segment>) {
        let mut segments = Vec::new();
        for stage in (0..self.sinks.len()).rev() {
            let sinks = std::mem::take(&mut self.sinks[stage]);
            let mut known = HashMap::new();
            let mut seen = vec![false; self.gates.len()];
            let mut stack: Vec<_> = sinks.iter().map(|(bit, _)| bit.gate()).collect();
            while let Some(gate) = stack.pop() {
                if std::mem::replace(&mut seen[gate], true) {
                    continue;
                }
                let earlier = (self.gates.stage(Bit::of(gate)) as usize) < stage;
                if earlier && !self.known.contains_key(&gate) {
                    let plane = self.fixed();
                    self.known.insert(gate, Place::Fixed(plane));
                    self.sink(Bit::of(gate), Place::Fixed(plane));
                }
                match self.gates.gate(gate) {
                    _ if earlier => {
                        known.insert(gate, self.known[&gate]);
                    }
                    Gate::And(a, b) | Gate::Xor(a, b) => stack.extend([a.gate(), b.gate()]),
                    Gate::False | Gate::Leaf => {
                        known.insert(gate, self.known[&gate]);
                    }
                }
            }
            segments.push(Segment { known, sinks });
        }
        segments.reverse();
        (self.layout, segments)
    }
}
