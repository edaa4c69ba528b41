//! Tests that walk the registry.

use std::collections::HashSet;

use super::*;

/// The defaults, and each parameter at either end of its range, as far as the block accepts them.
fn corners(block: &Block) -> Vec<Parameters> {
    let description = block.description();
    let mut all = vec![Parameters::defaults(description)];
    for parameter in description.parameters {
        for value in [parameter.min, parameter.max] {
            let mut parameters = Parameters::defaults(description);
            parameters.set(parameter.name, value);
            all.push(parameters);
        }
    }
    all.retain(|parameters| block.check(parameters).is_ok());
    all
}

#[test]
fn names_are_unique_and_well_formed() {
    let mut seen = HashSet::new();
    for block in REGISTRY {
        let name = block.description().name;
        assert!(seen.insert(name), "two blocks are called {name}");
        assert!(name.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_'), "{name}");
        assert!(Gate::from_keyword(name).is_none(), "{name} is a Verilog keyword");
    }
}

#[test]
fn every_block_port_and_parameter_is_documented_and_every_default_in_range() {
    for block in REGISTRY {
        let d = block.description();
        for text in [d.summary, d.doc, d.source] {
            assert!(text.len() > 10, "{}: documentation", d.name);
        }
        assert!(d.summary.ends_with('.'), "{}: the summary is a sentence", d.name);
        for port in d.ports {
            assert!(port.doc.len() > 3 && port.name != "clk", "{}.{}", d.name, port.name);
        }
        for p in d.parameters {
            assert!(p.doc.len() > 3, "{}.{}", d.name, p.name);
            assert!((p.min..=p.max).contains(&p.default), "{}.{}: default out of range", d.name, p.name);
        }
        assert!(block.check(&Parameters::defaults(d)).is_ok(), "{}: the defaults are refused", d.name);
    }
}

#[test]
fn every_block_builds_at_the_ends_of_its_parameters_ranges() {
    for block in REGISTRY {
        for parameters in corners(block) {
            let body = Builder::build(block, &parameters);
            let stateful = !body.graph.registers.is_empty() || !body.graph.rams.is_empty();
            if parameters == Parameters::defaults(block.description()) {
                assert_eq!(stateful, block.description().clocked, "{:?}: clocked", block);
            }
        }
    }
}

#[test]
fn every_block_stands_in_the_folder_of_its_kind_and_the_registry_is_in_that_order() {
    let kinds: Vec<_> = REGISTRY.iter().map(|block| block.description().kind).collect();
    assert!(kinds.is_sorted(), "a block's kind is not that of its folder: {kinds:?}");
}
