//! Tests that walk the registry.

use std::collections::HashSet;

use super::*;

/// Every combination of the parameters' defaults and the ends of their ranges, as far as the block accepts them.
fn corners(block: &Block) -> Vec<Parameters> {
    let description = block.description();
    let mut all = vec![Parameters::defaults(description)];
    for parameter in description.parameters {
        let mut more = Vec::new();
        for parameters in &all {
            for value in [parameter.default, parameter.min, parameter.max] {
                let mut parameters = parameters.clone();
                parameters.set(parameter.name, value);
                more.push(parameters);
            }
        }
        all = more;
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
fn every_block_builds_at_every_combination_of_the_ends_of_its_parameters_ranges() {
    let mut too_wide = Vec::new();
    for block in REGISTRY {
        for parameters in corners(block) {
            match Builder::build(block, &parameters) {
                Ok(body) => assert!(body.graph.nodes.len() < 1000, "{block:?}: {parameters:?}"),
                // The one thing that combinations may do; all else is a mistake in the block's file.
                Err(why) if why.contains("a word of") && why.contains("bits is needed") => too_wide.push(block),
                Err(why) => panic!("{block:?}: {parameters:?}: {why}"),
            }
        }
        let body = Builder::build(block, &Parameters::defaults(block.description())).expect("a body");
        let stateful = !body.graph.registers.is_empty() || !body.graph.rams.is_empty();
        assert_eq!(stateful, block.description().clocked, "{block:?}: clocked");
    }
    assert!(!too_wide.is_empty(), "no combination is refused: nothing shows that one would be");
}

#[test]
fn every_block_stands_in_the_folder_of_its_kind_and_the_registry_is_in_that_order() {
    let kinds: Vec<_> = REGISTRY.iter().map(|block| block.description().kind).collect();
    assert!(kinds.is_sorted(), "a block's kind is not that of its folder: {kinds:?}");
}

/// What a builder says of a block made of `build`, which has an input of 8 bits and no output.
fn failure(build: fn(&mut Builder)) -> String {
    static DESCRIPTION: Description = Description {
        name: "made_for_a_test",
        kind: Kind::Logic,
        summary: "",
        doc: "",
        source: "",
        parameters: &[],
        ports: &[PortDescription::input("a", Width::Fixed(8), ""), PortDescription::output("y", Width::BIT, "")],
        clocked: false,
    };
    let block = Block::new(&DESCRIPTION, build);
    Builder::build(&block, &Parameters::defaults(&DESCRIPTION)).expect_err("a failure")
}

#[test]
fn a_builder_tells_the_first_thing_that_cannot_be_and_never_panics() {
    type Case = (fn(&mut Builder), &'static str);
    let cases: [Case; 10] = [
        (|_| (), "its output `y` gets no value"),
        (|b| _ = b.constant(0, 65), "a word of 65 bits is needed, and 1 to 64 are possible"),
        (|b| _ = b.hold(0, 0), "a word of 0 bits is needed, and 1 to 64 are possible"),
        (|b| _ = b.zero_extend(b.input("a"), 7), "a word of 8 bits is to be widened to 7"),
        (|b| _ = b.slice(b.input("a"), 4, 5), "5 bits from bit 4 on are wanted of a word of 8"),
        (|b| b.output("y", b.input("a")), "its output `y` of 1 bits gets 8"),
        (|b| _ = b.mux(b.input("a"), b.input("a"), b.input("a")), "8 bits stand where one is wanted"),
        (
            |b| {
                let bit = b.bit(true);
                b.add(b.input("a"), bit);
            },
            "operands of 8 and 1 bits meet",
        ),
        (
            |b| _ = b.block("r", "reference", &[("WIDTH", 64)], &[]),
            "`reference` inside it: WIDTH is 64, but is 1 to 63",
        ),
        (
            |b| {
                let wide = (0..9).fold(b.input("a"), |wide, _| b.concat(wide, b.input("a")));
                b.output("y", wide);
            },
            "a word of 72 bits is needed, and 1 to 64 are possible",
        ),
    ];
    for (build, why) in cases {
        assert_eq!(failure(build), why);
    }
}
