//! Lanes: many copies of one program at once, every bit of every word a plane that holds that bit of all copies.
//!
//! The program is [lowered](lower) to single-bit gates, equal gates being shared and constants folded; the gates are
//! [covered](cover) with the machine's logic instructions, and [machine code](allocate) runs whole blocks of ticks
//! over planes of 256 or 512 lanes. Where there is no such machine, [plain Rust](portable) does it.

#[cfg(target_arch = "x86_64")]
mod allocate;
mod build;
#[cfg(target_arch = "x86_64")]
mod code;
mod cover;
#[cfg(target_arch = "x86_64")]
mod encode;
mod engine;
mod gates;
mod lower;
mod machine;
mod portable;
mod segment;
mod straight;
mod tables;
mod transpose;
mod words;

pub(in crate::engine) use build::Compiled;
pub use build::Path;
pub(super) use engine::ENGINE;
pub use engine::LanesEngine;
pub(in crate::engine) use machine::Machine;

#[cfg(test)]
pub(in crate::engine) mod tests;
