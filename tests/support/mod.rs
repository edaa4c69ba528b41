//! What several concerns need.

pub mod netlist_check;
pub mod program;

use std::sync::Arc;

use stepwright::base::Report;
use stepwright::netlist::{Library, Netlist, load};

/// A scenario whose frames a sweep can vary: it starts one and waits for its end.
pub const SCENARIO: &str = r#"
title = "Frames"
circuit = "su1522157/interpolator"
[inputs]
x_is_major_35 = 1
[[at]]
tick = 0
set = { start_33 = 1 }
[[at]]
tick = 1
set = { start_33 = 0 }
[stop]
until = "!busy"
limit = 10000
"#;

/// A library without a module: only blocks and what the text itself holds can be used.
pub struct NoLibrary;

impl Library for NoLibrary {
    fn find(&self, _: &str) -> Option<Result<(String, Arc<str>), Report>> {
        None
    }
}

/// Loads a circuit from a text. The top module is `circuit`, or the only one that no other instantiates.
pub fn load_text(text: &str) -> Result<Netlist, Report> {
    load("circuit.v", text, None, &NoLibrary, &[])
}
