//! `stepwright list`: circuits with their scenarios, shipped or in a folder, or the blocks.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::Path;

use serde_json::{Value, json};

use super::result::json as line;
use super::{Ending, complain, print};
use crate::base::{Diagnostic, Report};
use crate::blocks::{Description, REGISTRY};
use crate::files;
use crate::simulation::{Circuit, Session, shipped};

/// Lists `circuits`, `blocks`, or what is in a folder.
pub(super) fn list(what: &str, json: bool) -> Result<Ending, Report> {
    if what == "blocks" {
        print(&if json { line("list", json!({ "blocks": block_objects() })) } else { blocks() })?;
        return Ok(Ending::Done);
    }
    let mut found = Found::default();
    let below = Path::new("circuits").join(what);
    if what == "circuits" {
        found.add_folder(Path::new("circuits"));
        found.add_shipped("");
    } else if Path::new(what).is_dir() {
        found.add_folder(Path::new(what));
    } else {
        found.add_folder(&below);
        found.add_shipped(&format!("{}/", what.trim_end_matches('/')));
    }
    if found.circuits.is_empty() && found.broken == 0 {
        return Err(nothing(what));
    }
    print(&if json { line("list", found.object()) } else { found.text() })?;
    Ok(if found.broken == 0 { Ending::Done } else { Ending::Wrong })
}

fn nothing(what: &str) -> Report {
    let names = shipped::names("v").filter_map(|name| name.split_once('/')).map(|(folder, _)| folder);
    Diagnostic::new("C001", format!("there is no circuit or scenario in a folder `{what}`"))
        .nearest(what, names.chain(["circuits", "blocks"]))
        .help("write `circuits`, `blocks`, or a folder by its path or below ./circuits")
        .into()
}

/// Circuits by name, each with its scenarios by name and their titles.
#[derive(Default)]
struct Found {
    circuits: BTreeMap<String, BTreeMap<String, String>>,
    broken: usize,
}

impl Found {
    fn add_folder(&mut self, folder: &Path) {
        for path in files::below(folder, "v") {
            if let Ok(circuit) = Circuit::open(&path) {
                self.circuits.entry(circuit.name().to_owned()).or_default();
            }
        }
        for path in files::below(folder, "toml") {
            self.add_scenario(&path.display().to_string());
        }
    }

    /// The shipped ones whose names begin so, but for those that are in a folder already.
    fn add_shipped(&mut self, prefix: &str) {
        for name in shipped::names("v").filter(|name| name.starts_with(prefix)) {
            self.circuits.entry(name.to_owned()).or_default();
        }
        for name in shipped::names("toml").filter(|name| name.starts_with(prefix)) {
            if !self.circuits.values().any(|scenarios| scenarios.contains_key(name)) {
                self.add_scenario(&format!("{name}.toml"));
            }
        }
    }

    /// A scenario below the circuit that it names. One that cannot be read is told, and the others are listed.
    fn add_scenario(&mut self, file: &str) {
        match Session::open(file) {
            Ok(session) => {
                let scenarios = self.circuits.entry(session.circuit().name().to_owned()).or_default();
                let name = session.scenario_name().unwrap_or(file).to_owned();
                scenarios.insert(name, session.scenario().title.clone());
            }
            Err(report) => {
                self.broken += 1;
                complain(&report);
            }
        }
    }

    fn text(&self) -> String {
        let mut text = String::new();
        for (circuit, scenarios) in &self.circuits {
            let _ = writeln!(text, "{circuit}");
            for (name, title) in scenarios {
                let _ = writeln!(text, "{}", format!("    {name:40} {title}").trim_end());
            }
        }
        text
    }

    fn object(&self) -> Value {
        let scenario = |(name, title): (&String, &String)| json!({ "name": name, "title": title });
        let circuits = self.circuits.iter().map(|(name, scenarios)| {
            json!({ "name": name, "scenarios": scenarios.iter().map(scenario).collect::<Vec<_>>() })
        });
        json!({ "circuits": circuits.collect::<Vec<_>>() })
    }
}

fn descriptions() -> impl Iterator<Item = &'static Description> {
    REGISTRY.iter().map(|block| block.description())
}

fn blocks() -> String {
    let mut text = String::new();
    let mut kinds: Vec<_> = descriptions().map(|block| block.kind).collect();
    kinds.sort_unstable();
    kinds.dedup();
    for kind in kinds {
        let _ = writeln!(text, "{kind}");
        for block in descriptions().filter(|block| block.kind == kind) {
            let _ = writeln!(text, "    {:28} {}", block.name, block.summary);
        }
    }
    text
}

fn block_objects() -> Vec<Value> {
    let object =
        |block: &Description| json!({ "name": block.name, "folder": block.kind.to_string(), "summary": block.summary });
    descriptions().map(object).collect()
}
