//! Icarus and the interpreter agree on every output of every block, and of random ops.

use std::collections::HashSet;
use std::sync::Arc;

use stepwright::blocks::{Block, Builder, Parameters, REGISTRY};
use stepwright::compile::{Observe, compile};
use stepwright::engine::{Engine, Interpreter};
use stepwright::export;

use super::duts::{Duts, random_words};
use super::mixture::MIXTURE;
use super::random::Random;
use super::tools;
use super::wave::Wave;

const TICKS: u64 = 300;

/// The defaults, each parameter at either end, each two of them at ends chosen at random, and three sets at random, as
/// far as the block can be built with them.
fn corners(block: &Block, random: &mut Random) -> Vec<Parameters> {
    let description = block.description();
    let mut all = vec![Parameters::defaults(description)];
    for parameter in description.parameters {
        for value in [parameter.min, parameter.max] {
            let mut parameters = Parameters::defaults(description);
            parameters.set(parameter.name, value);
            all.push(parameters);
        }
    }
    for (i, a) in description.parameters.iter().enumerate() {
        for b in &description.parameters[i + 1..] {
            let mut parameters = Parameters::defaults(description);
            for parameter in [a, b] {
                let ends = [parameter.min, parameter.max];
                parameters.set(parameter.name, ends[random.below(2) as usize]);
            }
            all.push(parameters);
        }
    }
    for _ in 0..3 {
        let mut parameters = Parameters::defaults(description);
        for p in description.parameters {
            let values = p.max.abs_diff(p.min).saturating_add(1);
            parameters.set(p.name, p.min.wrapping_add(random.below(values) as i64));
        }
        all.push(parameters);
    }
    all.retain(|parameters| block.check(parameters).is_ok() && Builder::build(block, parameters).is_ok());
    all
}

/// Runs `duts` here and there, and compares every output at every tick.
fn judge(duts: &Duts) {
    let folder = tempfile::tempdir().expect("a folder");
    let stimulus = random_words(TICKS);
    // Levels below the top would be ops by the thousand.
    let bench = export::bench(&duts.netlist, &stimulus, TICKS).replace("$dumpvars(0,", "$dumpvars(1,");
    for (name, text) in [("blocks.v", &export::verilog([&duts.netlist])), ("duts.v", &duts.text), ("bench.v", &bench)] {
        std::fs::write(folder.path().join(name), text).expect("a file");
    }
    tools::icarus(folder.path(), "duts_bench");
    let wave = Wave::of_bench(&folder.path().join("bench.vcd"));

    let program = Arc::new(compile(&duts.netlist, &Observe::OUTPUTS));
    let theirs = program.outputs.iter().map(|port| wave.find(&format!("duts.{}", port.name)).expect("an output"));
    let theirs: Vec<_> = theirs.collect();
    let mut engine = Interpreter::new(Arc::clone(&program));
    for tick in 0..TICKS {
        let due = stimulus.changes.iter().filter(|change| change.tick == tick);
        due.for_each(|change| engine.set_input(change.input, change.word));
        engine.settle();
        for (output, port) in program.outputs.iter().enumerate() {
            let (ours, theirs) = (engine.value(port.value), theirs[output].at(tick));
            assert_eq!(Some(ours), theirs, "tick {tick}, {} (ours, then Icarus)", duts.describe(output));
        }
        engine.advance(1, false);
    }
}

#[test]
fn icarus_agrees_on_every_block_at_the_corners_of_its_parameters() {
    if !tools::present(&["iverilog", "vvp"]) {
        return;
    }
    let mut random = Random(3);
    let mut instances: Vec<(&'static Block, Parameters)> = Vec::new();
    for block in REGISTRY {
        // Twice: the second time other bits of the random words reach its inputs.
        let corners = corners(block, &mut random);
        assert!(!corners.is_empty(), "{block:?} accepts no parameters");
        instances.extend(corners.iter().chain(&corners).map(|parameters| (*block, parameters.clone())));
    }
    judge(&Duts::new(instances));
}

#[test]
fn icarus_agrees_on_random_ops_of_every_kind() {
    if !tools::present(&["iverilog", "vvp"]) {
        return;
    }
    let seeds = (0..64).map(|seed| {
        let mut parameters = Parameters::defaults(MIXTURE.description());
        assert!(parameters.set("SEED", seed));
        parameters
    });
    let duts = Duts::new(seeds.map(|parameters| (&MIXTURE, parameters)).collect());
    let nodes = duts.netlist.cells.iter().flat_map(|cell| &cell.body.graph.nodes);
    let kinds: HashSet<_> = nodes.map(|node| std::mem::discriminant(&node.op)).collect();
    // All but `Copy`, which only connections are made of.
    assert_eq!(kinds.len(), 26, "some op is not covered");
    judge(&duts);
}

#[test]
fn a_block_with_other_parameters_than_the_exported_ones_does_not_compile() {
    if !tools::present(&["iverilog"]) {
        return;
    }
    let summer = stepwright::blocks::find("summer").expect("a block");
    let duts = Duts::new(vec![(summer, Parameters::defaults(summer.description()))]);
    let folder = tempfile::tempdir().expect("a folder");
    let compile = |text: &str| {
        std::fs::write(folder.path().join("duts.v"), text).expect("a file");
        let mut iverilog = std::process::Command::new("iverilog");
        iverilog.args(["-g2005", "-s", "duts", "-o", "duts.vvp", "duts.v"]).current_dir(folder.path());
        iverilog.output().expect("iverilog runs")
    };
    let text = export::verilog([&duts.netlist]) + &duts.text;
    assert!(compile(&text).status.success());
    let other = compile(&text.replace(".NEGATIVE(0)", ".NEGATIVE(1)"));
    assert!(!other.status.success());
    assert!(String::from_utf8_lossy(&other.stderr).contains("summer_was_not_exported_with_these_parameters"));
}
