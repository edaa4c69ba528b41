//! What makes the rows of a sweep what they are, kept in a file beside theirs: `OUT.sweep`.
//!
//! Rows of one description belong together, whoever computed them and in how many goes; a CSV file has no place for it
//! that its readers would pass over.

use std::ffi::OsString;
use std::path::{Path, PathBuf};

use serde_json::{Map, Value, json};
use sha2::{Digest, Sha256};

use super::SweepArguments;
use super::plan::Part;
use crate::base::word::decode;
use crate::base::{Diagnostic, Report, StopRule};
use crate::files;
use crate::netlist::{Net, Netlist};
use crate::simulation::Design;

/// The number of the form of descriptions and rows.
const FORMAT: u32 = 2;

/// What makes the rows of a sweep what they are, as JSON.
#[derive(PartialEq, Debug)]
pub struct Description(Value);

impl Description {
    /// That of a sweep: the circuit by the hash of all its texts, its parameters, the inputs that are held and those
    /// that change over time, when a run stops, the stimuli, and what varies of the parameters and is measured.
    pub fn new(arguments: &SweepArguments, part: &Part) -> Self {
        let (design, stimuli) = (part.design(), &part.stimuli);
        let (netlist, stimulus) = (design.netlist(), design.stimulus());
        let number = |input: usize, word: u64| {
            let Net { width, signed, .. } = input_net(netlist, input);
            decode(word, *width, *signed).to_string()
        };
        let name = |input: usize| input_net(netlist, input).name.clone();
        let held = stimulus.initial.iter().enumerate().filter(|(input, _)| !stimuli.varied().contains(input));
        let held: Map<_, _> = held.map(|(input, &word)| (name(input), number(input, word).into())).collect();
        let changes = stimulus.changes.iter().map(|change| {
            let (name, number) = (name(change.input), number(change.input, change.word));
            format!("tick {}: {name} = {number}", change.tick)
        });
        let parameters: Map<_, _> = netlist.parameters.iter().map(|one| (one.name.clone(), one.value.into())).collect();
        let varied = arguments.over.iter().filter(|over| over.name.starts_with("p:")).map(ToString::to_string);
        Self(json!({
            "format": FORMAT,
            "stepwright": env!("CARGO_PKG_VERSION"),
            "circuit": { "module": netlist.scopes[0].module.to_string(), "sha256": hash_of(netlist) },
            "parameters": parameters,
            "inputs": held,
            "changes": changes.collect::<Vec<_>>(),
            "stop": stop(design),
            "stimuli": stimuli.describe(),
            "over_parameters": varied.collect::<Vec<_>>(),
            "measure": arguments.measure.iter().map(|quantity| quantity.name()).collect::<Vec<_>>(),
        }))
    }

    /// Where that of the rows in `out` is.
    pub fn path(out: &Path) -> PathBuf {
        let mut name = OsString::from(out);
        name.push(".sweep");
        name.into()
    }

    /// Writes that of the rows in `out`.
    ///
    /// # Errors
    /// `C003`.
    pub fn write(&self, out: &Path) -> Result<(), Report> {
        files::write_bytes(&Self::path(out), format!("{:#}\n", self.0).as_bytes())
    }

    /// Checks that the rows in `out` are of this sweep.
    ///
    /// # Errors
    /// `C066` they are not, with what differs, or nothing tells.
    pub fn check(&self, out: &Path) -> Result<(), Report> {
        let path = Self::path(out);
        let wrong = |message: String| {
            Diagnostic::new("C066", message).help("resume with the command that began it, or leave out --resume")
        };
        let read = files::read(&path).map_err(|report| {
            let why = report.diagnostics.iter().map(|d| d.message.as_str()).collect::<Vec<_>>().join("; ");
            wrong(format!("nothing tells what sweep {} is of: {why}", out.display()))
        })?;
        let there: Value = serde_json::from_str(&read.text).map_err(|error| {
            wrong(format!("nothing tells what sweep {} is of: {}: {error}", out.display(), path.display()))
        })?;
        let mut different = Vec::new();
        differences("", &there, &self.0, &mut different);
        if different.is_empty() {
            return Ok(());
        }
        let diagnostic = wrong(format!("{} is of another sweep", out.display()));
        Err(different.into_iter().fold(diagnostic, Diagnostic::help).into())
    }
}

fn input_net(netlist: &Netlist, input: usize) -> &Net {
    &netlist.nets[netlist.inputs[input].index()]
}

/// The hash of all texts, in the order in which they were read; their places do not matter.
pub(in crate::cli) fn hash_of(netlist: &Netlist) -> String {
    let mut hasher = Sha256::new();
    for (_, text) in netlist.sources.iter() {
        hasher.update((text.len() as u64).to_le_bytes());
        hasher.update(text.as_bytes());
    }
    hex(hasher)
}

/// A hash as text.
pub fn hex(hasher: Sha256) -> String {
    hasher.finalize().iter().map(|byte| format!("{byte:02x}")).collect()
}

fn stop(design: &Design) -> String {
    match (design.stimulus().stop, design.until()) {
        (StopRule::Until { limit }, Some(until)) => {
            let not = if until.high { "" } else { "!" };
            format!("until {not}{}, limit {limit}", design.netlist().net_name(until.net))
        }
        (StopRule::Until { limit: ticks } | StopRule::Ticks(ticks), _) => format!("ticks {ticks}"),
    }
}

/// A line for each value that differs, by its place.
pub(in crate::cli) fn differences(place: &str, there: &Value, here: &Value, lines: &mut Vec<String>) {
    match (there, here) {
        (Value::Object(a), Value::Object(b)) => {
            let names: std::collections::BTreeSet<_> = a.keys().chain(b.keys()).collect();
            for name in names {
                let place = if place.is_empty() { name.clone() } else { format!("{place}.{name}") };
                let of = |object: &Map<_, _>| object.get(name).cloned().unwrap_or(Value::Null);
                differences(&place, &of(a), &of(b), lines);
            }
        }
        _ if there == here => {}
        _ => lines.push(format!("{place}: {there} in the file, {here} now")),
    }
}
