//! The blocks: one file each, in folders by kind, and the registry that names them all.
//!
//! Adding a block is one file and its `pub mod` line; the tests of this room walk the registry.

mod block;
mod body;
mod builder;
mod describe;
mod gate;
mod image;
mod sine;

pub mod arithmetic;
pub mod logic;
pub mod memory;
pub mod pulses;
pub mod routing;
pub mod timing;

pub use block::Block;
pub use body::{Body, Cost, InnerSignal};
pub use builder::{Builder, Held};
pub use describe::{Description, Direction, Kind, Parameter, Parameters, PortDescription, Width};
pub use gate::Gate;
pub use image::ImageFormat;

/// Every block there is, by kind and then by name: each `pub static NAME: Block` in a file of a kind's folder, found
/// when the crate is built.
pub static REGISTRY: &[&Block] = include!(concat!(env!("OUT_DIR"), "/registry.rs"));

/// The block of a name.
#[must_use]
pub fn find(name: &str) -> Option<&'static Block> {
    REGISTRY.iter().copied().find(|block| block.description().name == name)
}

#[cfg(test)]
pub(crate) mod bench;
#[cfg(test)]
mod tests;
