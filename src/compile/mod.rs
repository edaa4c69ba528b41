//! From a checked netlist to a program: flatten, levelize, fold.
//!
//! What is observable is decided first ([`Observe`]); everything else may be optimised away.

mod flatten;
mod fold;
mod levelize;
mod observe;
mod program;

pub use fold::{Simple, simplify};
pub use observe::{Observe, Until};
pub use program::{Owner, OwnerId, Program};

use crate::base::Signal;
use crate::netlist::Netlist;

/// Compiles a netlist for those who want to see what `observe` says.
#[must_use]
pub fn compile(netlist: &Netlist, observe: &Observe<'_>) -> Program {
    let program = flatten::flatten(netlist, observe);
    compile_graph(program)
}

/// Every signal of a netlist, by name and shape; their values belong to no program that [`compile`] makes.
#[must_use]
pub fn signals(netlist: &Netlist) -> Vec<Signal> {
    flatten::flatten(netlist, &Observe::EVERYTHING).signals
}

/// Orders and optimises a program that was put together from ops in any order. Its ops must be free of loops.
#[must_use]
pub fn compile_graph(program: Program) -> Program {
    let program = levelize::levelize(program);
    let program = fold::fold(program);
    levelize::levelize(program)
}
