//! Machine code that runs: the only unsafe code of this engine.
//!
//! Why it is sound. The bytes come from an [`Encoder`](super::encode::Encoder), whose instructions touch nothing but
//! vector registers, `rcx`, `rdx`, `rsi`, `r8` and flags, all of which a `sysv64` function may change, and memory at
//! `rdi`, `rsi`, `rdx` and `rcx` plus a plane number. The encoder notes the highest plane of each region as it emits the
//! operand; [`Code::run`] checks every region against that before the call, and the history for all ticks of the loop.
//! Regions are disjoint because they are separate `&mut` slices. No instruction needs alignment. The instruction set is
//! checked when the code is made.
#![allow(unsafe_code, reason = "machine code that was made while running can be called in no other way")]

use std::io;

use memmap2::{Mmap, MmapMut};

use super::encode::{Extent, Finished, Vectors};

/// A loop over ticks in machine code.
#[derive(Debug)]
pub(super) struct Code {
    buffer: Mmap,
    vectors: Vectors,
    extent: Extent,
    stride: usize,
}

/// Whether this machine has these vectors.
pub(super) fn has(vectors: Vectors) -> bool {
    match vectors {
        Vectors::Avx2 => is_x86_feature_detected!("avx2"),
        Vectors::Avx512 => is_x86_feature_detected!("avx512f"),
    }
}

impl Code {
    /// Makes the code executable.
    ///
    /// # Errors
    /// When the machine lacks the vectors, or the system allows no executable memory.
    pub(super) fn new(finished: &Finished) -> io::Result<Self> {
        if !has(finished.vectors()) {
            return Err(io::ErrorKind::Unsupported.into());
        }
        let bytes = finished.bytes();
        let mut buffer = MmapMut::map_anon(bytes.len())?;
        buffer.copy_from_slice(bytes);
        Ok(Self {
            buffer: buffer.make_exec()?,
            vectors: finished.vectors(),
            extent: finished.extent(),
            stride: finished.stride(),
        })
    }

    /// Runs `ticks` ticks, at least one. After each, `now` and `next` have changed places.
    ///
    /// # Panics
    /// When a region is smaller than what the code touches.
    pub(super) fn run(&self, fixed: &mut [u64], now: &mut [u64], next: &mut [u64], history: &mut [u64], ticks: usize) {
        let words = self.vectors.bytes() / 8;
        let is_enough = |region: &[u64], planes: usize| region.len() / words >= planes;
        assert!(ticks > 0 && is_enough(fixed, self.extent.fixed));
        assert!(is_enough(now, self.extent.state) && is_enough(next, self.extent.state));
        assert!(is_enough(history, (ticks - 1) * self.stride + self.extent.history));
        type Loop = unsafe extern "sysv64" fn(*mut u64, *mut u64, *mut u64, *mut u64, usize);
        let start = self.buffer.as_ptr();
        // SAFETY: the buffer holds a whole function of this type (see the head of the file), executable as long as
        // `self` lives; the regions are large enough, checked above.
        unsafe {
            let function = std::mem::transmute::<*const u8, Loop>(start);
            function(fixed.as_mut_ptr(), now.as_mut_ptr(), next.as_mut_ptr(), history.as_mut_ptr(), ticks);
        }
    }
}
