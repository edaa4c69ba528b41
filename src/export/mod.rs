//! Export: the blocks of a netlist as Verilog, printed from their ops, and a bench that drives it in another simulator.
//!
//! The circuit files themselves are Verilog already: beside the exported blocks they compile unchanged. A block's
//! module has the name, parameters and ports of its description, and one `generate if` branch for each set of
//! parameters in use, since a block is made of ops for one set at a time. Any other set does not compile.

mod bench;
mod body;
mod expression;
mod files;
mod module;
mod page;

pub use bench::{bench, bench_name};
pub use files::{File, MARK, files, names};
pub use module::{BRANCH, block, verilog};
