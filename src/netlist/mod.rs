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
//! # Codes
//!
//! | code | what is wrong |
//! |------|---------------|
//! | N001 | the text is empty, no text, too long, or holds no module |
//! | N002 | a character, comment or string that is no token |
//! | N003 | something else was expected here |
//! | N004 | a construct of Verilog that is outside the structural subset |
//! | N005 | a number: digits, size, `x` or `z` |
//! | N006 | a limit: depth, length, number of parts or errors |
//! | N007 | bits with two drivers |
//! | N008 | bits without a driver |
//! | N009 | widths that differ |
//! | N010 | a name that means nothing, or no net |
//! | N011 | a name, port or parameter given twice |
//! | N012 | a module or block that does not exist |
//! | N013 | a port that does not exist |
//! | N014 | a parameter that does not exist or is given no value |
//! | N015 | a parameter's value out of its range, or refused by the block |
//! | N016 | an input left open |
//! | N017 | a gate with too many or too few terminals |
//! | N018 | a word of more than 64 bits |
//! | N019 | a select outside its net |
//! | N020 | a constant expression without a value |
//! | N021 | a number without a size where bits are counted |
//! | N022 | an operator on nets |
//! | N023 | the clock used as a signal, or missing |
//! | N024 | a combinational loop |
//! | N025 | a net that drives itself |
//! | N026 | a module that contains itself |
//! | N027 | no one top module |
//! | N028 | a range or select that runs upwards |
//! | N029 | something that cannot be driven |
//! | N030 | the attribute `fraction` out of its range |
//! | N031 | a generate loop without a genvar or without an end |
//! | N050 | a memory image: its name, or its file that is missing |

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

/// Where the files come from that a circuit file uses: modules that it does not hold, and memory images.
pub trait Library {
    /// The text of `file`, for example `summer_432.v`, and the name that messages show for it.
    fn find(&self, file: &str) -> Option<(String, Arc<str>)>;
}
