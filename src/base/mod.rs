//! Words and widths, typed ids, ops, diagnostics: what every other room speaks.

pub mod diagnostic;
pub mod graph;
pub mod id;
pub mod memory;
pub mod signal;
pub mod stimulus;
pub mod word;

pub use diagnostic::{Diagnostic, Report, SourceId, Sources, Span};
pub use graph::{Graph, MemoryWrite, Node, Op, Ram, RamId, Register, RegisterId, Rom, RomId, ValueId};
pub use memory::MemoryImage;
pub use signal::{Edge, Port, Signal};
pub use stimulus::{Change, Stimulus, StopRule, StoppedBy};
