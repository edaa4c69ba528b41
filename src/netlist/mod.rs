//! From circuit text to a checked netlist: lexer, tree, parser, elaboration, checks.
//!
//! ```text
//! text --syntax--> modules --elaborate--> templates --assemble--> Netlist
//! ```
//!
//! [`load()`] reads structural Verilog-2005: modules with ANSI headers, parameters, constant expressions, wires, assigns
//! that only route bits, instances with named connections, gate primitives, generate loops, attributes. Anything else
//! is an error that says what to write instead. Two things are stricter than Verilog: widths must agree, and a name is
//! declared before it is used.
//!
//! Attributes tell what Verilog has no words for: `(* fraction = 3 *)` before a port or wire, that so many of its bits
//! stand behind the point; `(* MODE_min = 0, MODE_max = 4 *)` before a module, the range of its parameter `MODE`, which
//! holds for every instance.
//!
//! The codes of its errors begin with N; `docs/diagnostics.md` lists them.

mod assemble;
mod checked;
mod elaborate;
mod errors;
mod limits;
mod load;
mod syntax;

pub use checked::{
    Cell, CellId, CellKind, Drive, Net, NetId, Netlist, Part, PortOf, Scope, ScopeId, Source, TopParameter,
};
pub use load::load;

use std::sync::Arc;

use crate::base::Report;

/// Where the files come from that a circuit file uses: modules that it does not hold, and memory images.
pub trait Library {
    /// The name that messages show for `file`, for example `summer_432.v`, and its text; `None` when there is no such
    /// file.
    ///
    /// # Errors
    /// The file is there but cannot be read.
    fn find(&self, file: &str) -> Option<Result<(String, Arc<str>), Report>>;
}
