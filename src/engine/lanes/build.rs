//! Build: from a program to planes that can be run on this machine.

use super::cover::{Instructions, cover};
use super::lower::lower;
use super::portable::{self, Portable};
use super::segment::{Layout, segment};
use crate::base::ValueId;
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
    pub(super) rom_words: Vec<Vec<u64>>,
    pub(super) ram_images: Vec<Vec<u64>>,
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
    /// Compiles `program` for one path, to record the `wanted` values at every tick. A path that the system will not let
    /// us take (no executable memory) becomes the portable one.
    pub(in crate::engine) fn new(program: &Program, wanted: &[ValueId], path: Path) -> Self {
        let lowered = lower(program, wanted);
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
        let rom_words = program.graph.roms.iter().map(|rom| rom.image.words().collect()).collect();
        let ram_images = program.graph.rams.iter().map(|ram| ram.image.words().collect()).collect();
        Self { layout, backend, words, spills, most_ticks, rom_words, ram_images }
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
fn native(
    lines: impl Iterator<Item = super::cover::Straight>,
    layout: &Layout,
    vectors: Vectors,
) -> Option<(Backend, usize, usize)> {
    let mut code = Vec::new();
    let mut spills = 0;
    for straight in lines {
        let (finished, spilled) = allocate(&straight, vectors, layout.fixed, layout.history);
        spills = spills.max(spilled);
        code.push(Code::new(&finished).ok()?);
    }
    Some((Backend::Native(code), vectors.bytes() / 8, spills as usize))
}

fn interpreted(lines: impl Iterator<Item = super::cover::Straight>, layout: &Layout) -> (Backend, usize, usize) {
    let mut code = Vec::new();
    let mut temporaries = 0;
    for straight in lines {
        let (portable, used) = Portable::new(&straight, layout.fixed);
        temporaries = temporaries.max(used);
        code.push(portable);
    }
    (Backend::Portable(code), portable::WORDS, temporaries as usize)
}
