//! The rising edges of some outputs in all lanes, one by one.

use crate::base::Edge;

/// What has been seen so far of the runs that the lanes are in.
#[derive(Clone, Debug)]
pub(super) struct Edges {
    /// The plane of each output in the tick before.
    before: Vec<Vec<u64>>,
    /// The edges of each lane.
    lanes: Vec<Vec<Edge>>,
}

impl Edges {
    pub(super) fn new(lanes: usize, pulses: usize) -> Self {
        Self { before: vec![vec![0; lanes / 64]; pulses], lanes: vec![Vec::new(); lanes] }
    }

    /// Puts the lanes of `mask` before their tick 0.
    pub(super) fn clear(&mut self, mask: &[u64]) {
        for before in &mut self.before {
            before.iter_mut().zip(mask).for_each(|(word, mask)| *word &= !mask);
        }
    }

    /// Looks at an output's plane of a tick; `tick` tells which one it is in the run of a lane.
    pub(super) fn look(&mut self, pulse: usize, plane: &[u64], active: &[u64], tick: impl Fn(usize) -> u64) {
        for (at, ((before, &now), &active)) in self.before[pulse].iter_mut().zip(plane).zip(active).enumerate() {
            let mut rising = now & !*before & active;
            *before = now;
            while rising != 0 {
                let lane = at * 64 + rising.trailing_zeros() as usize;
                rising &= rising - 1;
                // A run of 2^32 ticks has no room for its edges anyway.
                let tick = u32::try_from(tick(lane)).unwrap_or(u32::MAX);
                self.lanes[lane].push(Edge { tick, pulse: pulse as u32 });
            }
        }
    }

    /// The edges of a lane whose run is over.
    pub(super) fn take(&mut self, lane: usize) -> Vec<Edge> {
        std::mem::take(&mut self.lanes[lane])
    }
}
