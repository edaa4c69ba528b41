//! What several concerns need.

pub mod netlist_check;
pub mod program;

use std::sync::Arc;

use stepwright::base::Report;
use stepwright::netlist::{Library, Netlist, load};

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
