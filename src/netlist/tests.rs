//! Tests of the whole way from text to netlist.

use std::sync::Arc;

use super::*;

struct NoLibrary;
impl Library for NoLibrary {
    fn find(&self, _: &str) -> Option<(String, Arc<str>)> {
        None
    }
}

#[test]
fn the_shipped_circuits_load() {
    for (name, text) in [
        ("interpolator.v", include_str!("../../circuits/su1522157/interpolator.v")),
        ("multiplexer_21.v", include_str!("../../circuits/su1522157/multiplexer_21.v")),
    ] {
        let netlist = load(name, text, None, &NoLibrary, &[]).unwrap_or_else(|report| panic!("{report}"));
        assert!(!netlist.cells.is_empty());
    }
}
