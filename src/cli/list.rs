//! `stepwright list`: the shipped circuits with their scenarios, or the blocks.

use std::fmt::Write as _;

use super::args::Listed;
use super::{Ending, print};
use crate::base::Report;
use crate::blocks::REGISTRY;
use crate::scenario;
use crate::simulation::shipped;

pub(super) fn list(what: Listed) -> Result<Ending, Report> {
    print(&match what {
        Listed::Circuits => circuits()?,
        Listed::Blocks => blocks(),
    })?;
    Ok(Ending::Done)
}

/// Each circuit, and below it the scenarios that run it.
fn circuits() -> Result<String, Report> {
    let mut scenarios = Vec::new();
    for name in shipped::names("toml") {
        let path = format!("{name}.toml");
        let text = shipped::text(&path).unwrap_or_default();
        scenarios.push((name, scenario::parse(&format!("circuits/{path}"), text)?));
    }
    let mut text = String::new();
    for circuit in shipped::names("v") {
        let _ = writeln!(text, "{circuit}");
        for (name, scenario) in scenarios.iter().filter(|(_, scenario)| scenario.circuit == circuit) {
            let _ = writeln!(text, "    {name:40} {}", scenario.title);
        }
    }
    Ok(text)
}

fn blocks() -> String {
    let mut text = String::new();
    let mut kinds: Vec<_> = REGISTRY.iter().map(|block| block.description().kind).collect();
    kinds.sort_unstable();
    kinds.dedup();
    for kind in kinds {
        let _ = writeln!(text, "{kind}");
        for block in REGISTRY.iter().map(|block| block.description()).filter(|block| block.kind == kind) {
            let _ = writeln!(text, "    {:28} {}", block.name, block.summary);
        }
    }
    text
}
