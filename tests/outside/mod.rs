//! Outside judges: other people's tools read what we write and must come to the same values.

mod blocks;
mod circuits;
mod composites;
mod differences;
mod duts;
mod goldens;
mod images;
mod language;
mod linters;
mod mixture;
mod random;
pub mod tools;
mod trace;
mod wave;
mod waveforms;
