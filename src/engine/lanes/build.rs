//! Build: from a program to planes that can be run on this machine.

use super::cover::{Instructions, cover};
use super::lower::lower;
use super::portable::{self, Portable};
use super::segment::{Layout, segment};
use super::straight::Straight;
use crate::base::{Diagnostic, MemoryImage, ValueId};
use crate::compile::Program;

#[cfg(target_arch = "x86_64")]
use super::{allocate::allocate, code, code::Code, encode::Vectors};

/// How lanes are computed.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub enum Path {
    /// Plain Rust, 1024 lanes; runs anywhere.
    Portable,
    /// Generated code over 256-bit vectors, 256 lanes.
    Avx2,
    /// Generated code over 512-bit vectors with three-operand logic, 512 lanes.
    Avx512,
}

impl Path {
    /// The ways this machine has, the best one last.
    #[must_use]
    pub fn all() -> Vec<Path> {
        #[cfg(target_arch = "x86_64")]
        {
            let vectors = [(Path::Avx2, Vectors::Avx2), (Path::Avx512, Vectors::Avx512)];
            let present = vectors.into_iter().filter(|(_, vectors)| code::has(*vectors)).map(|(path, _)| path);
            [Path::Portable].into_iter().chain(present).collect()
        }
        #[cfg(not(target_arch = "x86_64"))]
        vec![Path::Portable]
    }

    /// The best way this machine has.
    #[must_use]
    pub fn best() -> Path {
        Path::all().pop().unwrap_or(Path::Portable)
    }
}

/// Bytes of history to aim at: half of a first-level cache.
const HISTORY_BYTES: usize = 24 << 10;

/// Bytes of one machine at most; there is one for each thread.
const MOST_BYTES: u64 = 512 << 20;

fn too_large(why: &str) -> Diagnostic {
    Diagnostic::new("E005", format!("the circuit is too large for the lanes engine: it needs {why}")).help(
        "every word stands there once for each of many stimuli: run them one by one, or make its memories smaller",
    )
}

/// A program as planes.
#[derive(Debug)]
pub(in crate::engine) struct Compiled {
    pub(super) layout: Layout,
    pub(super) backend: Backend,
    /// 64-lane words of a plane.
    pub(super) words: usize,
    /// Planes that the code keeps values in, after the fixed ones.
    spills: usize,
    /// How many ticks the history holds.
    pub(in crate::engine) most_ticks: usize,
    pub(super) roms: Vec<MemoryImage>,
    /// Empty for those that are made of gates.
    pub(super) rams: Vec<MemoryImage>,
}

/// The code of each segment.
#[derive(Debug)]
pub(super) enum Backend {
    #[cfg(target_arch = "x86_64")]
    Native(Vec<Code>),
    Portable(Vec<Portable>),
}

/// Sizes of the regions in words.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sizes {
    pub(super) fixed: usize,
    pub(super) state: usize,
}

impl Compiled {
    /// Compiles `program` for one path, to record the `wanted` values at every tick. A path that cannot be taken (no
    /// executable memory, or more planes than its instructions reach) becomes the portable one.
    ///
    /// # Errors
    /// `E005` when the program is too large for any path.
    pub(in crate::engine) fn new(program: &Program, wanted: &[ValueId], path: Path) -> Result<Self, Diagnostic> {
        let lowered = lower(program, wanted).ok_or_else(|| too_large("more gates than it takes"))?;
        let (layout, segments) = segment(&lowered);
        let (gates, segments) = (&lowered.gates, &segments);
        let line = |instructions| segments.iter().map(move |s| cover(gates, s, instructions));
        let (backend, words, spills) = match path {
            #[cfg(target_arch = "x86_64")]
            Path::Avx512 => native(line(Instructions::Tables), &layout, Vectors::Avx512),
            #[cfg(target_arch = "x86_64")]
            Path::Avx2 => native(line(Instructions::Pairs), &layout, Vectors::Avx2),
            _ => None,
        }
        .unwrap_or_else(|| interpreted(line(Instructions::Pairs), &layout));
        let most_ticks = (HISTORY_BYTES / (layout.history.max(1) as usize * words * 8)).clamp(8, 128);
        let roms = program.graph.roms.iter().map(|rom| rom.image.clone()).collect();
        let mut rams = vec![MemoryImage::from_words(1, []); program.graph.rams.len()];
        for store in &layout.stores {
            rams[store.ram.index()] = program.graph.rams[store.ram.index()].image.clone();
        }
        let compiled = Self { layout, backend, words, spills, most_ticks, roms, rams };
        let bytes = compiled.bytes_of_a_machine();
        if bytes > MOST_BYTES {
            return Err(too_large(&format!("{} MiB for its lanes, of {} at most", bytes >> 20, MOST_BYTES >> 20)));
        }
        Ok(compiled)
    }

    /// Bytes that a machine takes: planes, and the RAMs of every lane.
    fn bytes_of_a_machine(&self) -> u64 {
        let ram_words: u64 = self.rams.iter().map(|image| image.depth() as u64).sum();
        8 * (self.words_of_memory() as u64 + ram_words.saturating_mul(self.lanes() as u64))
    }

    /// Lanes that run at once.
    pub(in crate::engine) fn lanes(&self) -> usize {
        self.words * 64
    }

    /// The planes of the history that hold a wanted value, low bit first.
    pub(in crate::engine) fn planes(&self, value: ValueId) -> &[u32] {
        &self.layout.values[&value]
    }

    /// Whether nothing is to do between or after the segments.
    pub(super) fn is_plain(&self) -> bool {
        self.layout.lookups.len() == 1 && self.layout.lookups[0].is_empty() && self.layout.stores.is_empty()
    }

    /// Whether all state is in planes.
    pub(in crate::engine) fn can_rewind(&self) -> bool {
        self.layout.stores.is_empty()
    }

    pub(super) fn sizes(&self) -> Sizes {
        let fixed = (self.layout.fixed as usize + self.spills) * self.words;
        Sizes { fixed, state: self.layout.init.len() * self.words }
    }

    pub(super) fn words_of_memory(&self) -> usize {
        let sizes = self.sizes();
        sizes.fixed + 2 * sizes.state + self.most_ticks * self.layout.history as usize * self.words
    }
}

#[cfg(target_arch = "x86_64")]
fn native(lines: impl Iterator<Item = Straight>, layout: &Layout, vectors: Vectors) -> Option<(Backend, usize, usize)> {
    let mut code = Vec::new();
    let mut spills = 0;
    for straight in lines {
        let (finished, spilled) = allocate(&straight, vectors, layout.fixed, layout.history)?;
        spills = spills.max(spilled);
        code.push(Code::new(&finished).ok()?);
    }
    Some((Backend::Native(code), vectors.bytes() / 8, spills as usize))
}

fn interpreted(lines: impl Iterator<Item = Straight>, layout: &Layout) -> (Backend, usize, usize) {
    let mut code = Vec::new();
    let mut temporaries = 0;
    for straight in lines {
        let (portable, used) = Portable::new(&straight, layout.fixed);
        temporaries = temporaries.max(used);
        code.push(portable);
    }
    (Backend::Portable(code), portable::WORDS, temporaries as usize)
}
