//! A machine of lanes: the memory of all planes, and what can be done with it.

use std::sync::Arc;

use super::build::{Backend, Compiled};
use super::lower::Memory;
use super::portable::Starts;
use super::transpose::{from_lanes, to_lanes};

/// Runs many copies of one program in lockstep, one bit of each plane a copy.
///
/// It stands *at* a tick. [`Machine::pass`] settles it, records what was wanted, and goes on; the tick it ends at is
/// settled but not committed.
#[derive(Debug)]
pub(in crate::engine) struct Machine {
    compiled: Arc<Compiled>,
    memory: Vec<u64>,
    /// Where the planes start in `memory`: at a whole vector.
    start: usize,
    /// Which of the two states is the present one.
    parity: usize,
    /// For each large RAM its words, those of a lane together.
    rams: Vec<Vec<u64>>,
}

impl Machine {
    pub(in crate::engine) fn new(compiled: Arc<Compiled>) -> Self {
        let memory = vec![0u64; compiled.words_of_memory() + 8];
        let start = memory.as_ptr().align_offset(64).min(8);
        let lanes = compiled.lanes();
        let rams = compiled.rams.iter().map(|image| image.words().repeat(lanes)).collect();
        let mut machine = Self { compiled, memory, start, parity: 0, rams };
        let words = machine.compiled.words;
        machine.regions().fixed[words..2 * words].fill(u64::MAX);
        machine.reset(&vec![u64::MAX; words]);
        machine
    }

    pub(in crate::engine) fn compiled(&self) -> &Compiled {
        &self.compiled
    }

    fn regions(&mut self) -> Regions<'_> {
        self.parts().1
    }

    /// The program and its planes.
    fn parts(&mut self) -> (&Compiled, Regions<'_>) {
        let sizes = self.compiled.sizes();
        let (fixed, rest) = self.memory[self.start..].split_at_mut(sizes.fixed);
        let (first, rest) = rest.split_at_mut(sizes.state);
        let (second, history) = rest.split_at_mut(sizes.state);
        let (now, next) = if self.parity == 0 { (first, second) } else { (second, first) };
        (&self.compiled, Regions { fixed, now, next, history })
    }

    /// Puts the lanes of `mask` at power-on; their inputs stay.
    pub(in crate::engine) fn reset(&mut self, mask: &[u64]) {
        let (compiled, Regions { now, .. }) = self.parts();
        for (plane, &init) in now.chunks_exact_mut(compiled.words).zip(&compiled.layout.init) {
            for (word, mask) in plane.iter_mut().zip(mask) {
                *word = if init { *word | mask } else { *word & !mask };
            }
        }
        for (ram, image) in self.rams.iter_mut().zip(&self.compiled.rams) {
            for (lane, words) in ram.chunks_exact_mut(image.depth().max(1)).enumerate() {
                if mask[lane / 64] >> (lane % 64) & 1 == 1 {
                    words.copy_from_slice(image.words());
                }
            }
        }
    }

    /// Sets an input of one lane.
    pub(in crate::engine) fn set(&mut self, lane: usize, input: usize, word: u64) {
        let (compiled, Regions { fixed, .. }) = self.parts();
        let (at, bit) = (lane / 64, 1 << (lane % 64));
        for (i, &plane) in compiled.layout.inputs[input].iter().enumerate() {
            let planes = &mut fixed[plane as usize * compiled.words + at];
            *planes = if word >> i & 1 == 1 { *planes | bit } else { *planes & !bit };
        }
    }

    /// Sets an input of the lanes of `mask`.
    pub(in crate::engine) fn set_all(&mut self, mask: &[u64], input: usize, word: u64) {
        let (compiled, Regions { fixed, .. }) = self.parts();
        for (i, &plane) in compiled.layout.inputs[input].iter().enumerate() {
            let plane = &mut fixed[plane as usize * compiled.words..][..compiled.words];
            for (planes, mask) in plane.iter_mut().zip(mask) {
                *planes = if word >> i & 1 == 1 { *planes | mask } else { *planes & !mask };
            }
        }
    }

    /// Settles and records `ticks` ticks, one after another, with a commit between them.
    ///
    /// # Panics
    /// When the history has no room for them.
    pub(in crate::engine) fn pass(&mut self, ticks: usize) {
        assert!((1..=self.compiled.most_ticks).contains(&ticks), "a pass of {ticks} ticks");
        let (compiled, Regions { fixed, now, next, history }) = self.parts();
        match &compiled.backend {
            #[cfg(target_arch = "x86_64")]
            Backend::Native(code) if compiled.is_plain() => {
                code[0].run(fixed, now, next, history, ticks);
                self.parity ^= (ticks - 1) & 1;
            }
            _ => {
                let compiled = Arc::clone(&self.compiled);
                for tick in 0..ticks {
                    if tick > 0 {
                        self.commit();
                    }
                    self.settle(&compiled, tick);
                }
            }
        }
    }

    fn settle(&mut self, compiled: &Compiled, tick: usize) {
        let recorded = tick * compiled.layout.history as usize;
        for (stage, lookups) in compiled.layout.lookups.iter().enumerate() {
            match &compiled.backend {
                #[cfg(target_arch = "x86_64")]
                Backend::Native(code) => {
                    let Regions { fixed, now, next, history } = self.regions();
                    code[stage].run(fixed, now, next, &mut history[recorded * compiled.words..], 1);
                }
                Backend::Portable(code) => {
                    let sizes = compiled.sizes();
                    let states = [sizes.fixed, sizes.fixed + sizes.state].map(|at| at / compiled.words);
                    let history = (sizes.fixed + 2 * sizes.state) / compiled.words + recorded;
                    code[stage].run(&mut self.memory[self.start..], Starts { states, history }, self.parity);
                }
            }
            for lookup in lookups {
                self.look_up(compiled, lookup.memory, &lookup.address, &lookup.word);
            }
        }
    }

    /// Reads a memory, lane by lane.
    fn look_up(&mut self, compiled: &Compiled, memory: Memory, address: &[u32], word: &[u32]) {
        for group in 0..compiled.words {
            let at = |plane: u32| self.start + plane as usize * compiled.words + group;
            let mut lanes = to_lanes(address.iter().map(|&plane| self.memory[at(plane)]));
            for (lane, value) in lanes.iter_mut().enumerate() {
                let words = match memory {
                    Memory::Rom(rom) => compiled.roms[rom.index()].words(),
                    Memory::Ram(ram) => self.ram(compiled, ram.index(), group * 64 + lane),
                };
                *value = usize::try_from(*value).ok().and_then(|at| words.get(at)).copied().unwrap_or(0);
            }
            for (&plane, bits) in word.iter().zip(from_lanes(lanes)) {
                self.memory[at(plane)] = bits;
            }
        }
    }

    fn ram(&self, compiled: &Compiled, ram: usize, lane: usize) -> &[u64] {
        let depth = compiled.rams[ram].depth();
        &self.rams[ram][lane * depth..][..depth]
    }

    /// Ends the tick: the next state becomes the present one.
    pub(in crate::engine) fn commit(&mut self) {
        if !self.compiled.layout.stores.is_empty() {
            self.write_rams(&Arc::clone(&self.compiled));
        }
        self.parity ^= 1;
    }

    fn write_rams(&mut self, compiled: &Compiled) {
        for store in &compiled.layout.stores {
            let depth = compiled.rams[store.ram.index()].depth();
            for group in 0..compiled.words {
                let word = |plane: &u32| self.memory[self.start + *plane as usize * compiled.words + group];
                let addresses = to_lanes(store.address.iter().map(word));
                let data = to_lanes(store.data.iter().map(word));
                let enabled = word(&store.enable);
                for lane in (0..64).filter(|lane| enabled >> lane & 1 == 1) {
                    if let Some(at) = usize::try_from(addresses[lane]).ok().filter(|&at| at < depth) {
                        self.rams[store.ram.index()][(group * 64 + lane) * depth + at] = data[lane];
                    }
                }
            }
        }
    }

    /// What the last pass recorded.
    pub(in crate::engine) fn history(&self) -> History<'_> {
        let sizes = self.compiled.sizes();
        let words = self.compiled.words;
        let planes = &self.memory[self.start + sizes.fixed + 2 * sizes.state..];
        History { planes, words, tick: self.compiled.layout.history as usize * words }
    }

    /// The state of the present tick, for [`Machine::rewind`]. Large RAMs are not part of it.
    pub(in crate::engine) fn present_state(&mut self) -> Vec<u64> {
        self.regions().now.to_vec()
    }

    /// Goes back to where a pass began.
    pub(in crate::engine) fn rewind(&mut self, state: &[u64]) {
        self.regions().now.copy_from_slice(state);
    }
}

struct Regions<'a> {
    fixed: &'a mut [u64],
    now: &'a mut [u64],
    next: &'a mut [u64],
    history: &'a mut [u64],
}

/// The recorded planes of some ticks.
#[derive(Clone, Copy, Debug)]
pub(in crate::engine) struct History<'a> {
    planes: &'a [u64],
    /// Words of a plane.
    words: usize,
    /// Words of a tick.
    tick: usize,
}

impl<'a> History<'a> {
    /// A plane as recorded at a tick.
    pub(in crate::engine) fn plane(&self, tick: usize, plane: u32) -> &'a [u64] {
        &self.planes[tick * self.tick + plane as usize * self.words..][..self.words]
    }

    /// A bit of a lane at a tick.
    pub(in crate::engine) fn bit(&self, tick: usize, plane: u32, lane: usize) -> u64 {
        self.planes[tick * self.tick + plane as usize * self.words + lane / 64] >> (lane % 64) & 1
    }

    /// The word of a lane at a tick, from the planes it is made of.
    pub(in crate::engine) fn word(&self, tick: usize, planes: &[u32], lane: usize) -> u64 {
        planes.iter().enumerate().map(|(i, &plane)| self.bit(tick, plane, lane) << i).sum()
    }
}
