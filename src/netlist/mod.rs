//! From circuit text to a checked netlist: lexer, tree, parser, elaboration, checks.

mod assemble;
mod checked;
mod elaborate;
mod errors;
mod limits;
mod load;
mod syntax;

pub use checked::{Cell, CellId, CellKind, Drive, Net, NetId, Netlist, Part, PortOf, Scope, ScopeId, Source};
pub use load::load;

use std::sync::Arc;

/// Where modules come from that a circuit file uses but does not hold.
pub trait Library {
    /// The text of the file that holds `module`, and the name that messages show for it.
    fn find(&self, module: &str) -> Option<(String, Arc<str>)>;
}

#[cfg(test)]
mod tests;
