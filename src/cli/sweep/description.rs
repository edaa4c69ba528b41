//! What makes the rows of a sweep what they are, kept in a file beside theirs: `OUT.sweep`.
//!
//! Rows of one description belong together, whoever computed them and in how many goes; a CSV file has no place for it
//! that its readers would pass over.

use std::ffi::OsString;
use std::path::{Path, PathBuf};

use serde_json::{Map, Value, json};
use sha2::{Digest, Sha256};

use super::SweepArguments;
use super::plan::Plan;
use super::shard::Shard;
use crate::base::word::decode;
use crate::base::{Diagnostic, Report, StopRule};
use crate::cli::result::parameters;
use crate::files;
use crate::netlist::{Net, Netlist};
use crate::simulation::Design;

/// The number of the form of descriptions and rows.
const FORMAT: u32 = 2;
/// Whose the values are that differ when a file is gone on with.
pub(in crate::cli) const RESUMED: [&str; 2] = ["in the file", "now"];
const RESUME: &str = "resume with the command that began it, or leave out --resume";
/// The key that only the description of a shard has.
const SHARD: &str = "shard";

/// What makes the rows of a sweep what they are, as JSON.
#[derive(PartialEq, Debug)]
pub struct Description(Value);

impl Description {
    /// That of a sweep: the circuit by the hash of all its texts, its parameters, the inputs that are held and those
    /// that change over time, when a run stops, the stimuli, and what varies of the parameters and is measured; of a
    /// shard also which it is.
    pub fn new(arguments: &SweepArguments, plan: &Plan) -> Self {
        let part = plan.first();
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
        let varied = arguments.over.iter().filter(|over| over.name.starts_with("p:")).map(ToString::to_string);
        let mut description = json!({
            "format": FORMAT,
            "stepwright": env!("CARGO_PKG_VERSION"),
            "circuit": { "module": netlist.scopes[0].module.to_string(), "sha256": hash_of(netlist) },
            "parameters": parameters(netlist),
            "inputs": held,
            "changes": changes.collect::<Vec<_>>(),
            "stop": stop(design),
            "stimuli": stimuli.describe(),
            "over_parameters": varied.collect::<Vec<_>>(),
            "measure": arguments.measure.iter().map(|quantity| quantity.name()).collect::<Vec<_>>(),
        });
        if let Some(Shard { index, of }) = plan.shard() {
            description[SHARD] = json!({ "index": index, "of": of, "rows_of_all": plan.all() });
        }
        Self(description)
    }

    /// That of the rows in `out`.
    ///
    /// # Errors
    /// `C066` nothing tells.
    pub fn of(out: &Path) -> Result<Self, Diagnostic> {
        let path = Self::path(out);
        let message = |why: String| format!("nothing tells what sweep {} is of: {why}", out.display());
        let untold = |why: String| Diagnostic::new("C066", message(why));
        let read = files::read(&path).map_err(|report| {
            untold(report.diagnostics.iter().map(|d| d.message.as_str()).collect::<Vec<_>>().join("; "))
        })?;
        let text = serde_json::from_str(&read.text).map_err(|error| untold(format!("{}: {error}", path.display())))?;
        Ok(Self(text))
    }

    /// That of the sweep that the rows are a shard of; which one, and of how many rows. `None` if they are none.
    pub fn shard(mut self) -> Option<(Self, Shard, u64)> {
        let shard = self.0.as_object_mut()?.remove(SHARD)?;
        let number = |name: &str| shard.get(name)?.as_u64();
        let (index, of, all) = (number("index")?, number("of")?, number("rows_of_all")?);
        Some((self, Shard::new(index, of)?, all))
    }

    /// A line for each value in which this one differs from another; `said` tells whose the values are, the other's first.
    pub fn differences(&self, there: &Self, said: [&str; 2]) -> Vec<String> {
        let mut different = Vec::new();
        differences("", &there.0, &self.0, said, &mut different);
        different
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

    /// Checks that no other shard of this sweep is in `out`.
    ///
    /// # Errors
    /// `C082`.
    pub fn check_shard(&self, out: &Path) -> Result<(), Diagnostic> {
        let split = || Some((Self(self.0.clone()).shard()?, Self::of(out).ok()?.shard()?));
        match split() {
            Some(((sweep, here, _), (other, there, _))) if sweep == other && here != there => {
                let message = format!("{} holds shard {}/{} of this sweep", out.display(), there.index, there.of);
                Err(Diagnostic::new("C082", message).help("give each shard a file of its own, or remove that one"))
            }
            _ => Ok(()),
        }
    }

    /// Checks that the rows in `out` are of this sweep.
    ///
    /// # Errors
    /// `C066` they are not, with what differs, or nothing tells.
    pub fn check(&self, out: &Path) -> Result<(), Report> {
        let different = self.differences(&Self::of(out).map_err(|diagnostic| diagnostic.help(RESUME))?, RESUMED);
        if different.is_empty() {
            return Ok(());
        }
        let diagnostic = Diagnostic::new("C066", format!("{} is of another sweep", out.display())).help(RESUME);
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
pub(in crate::cli) fn differences(place: &str, there: &Value, here: &Value, said: [&str; 2], lines: &mut Vec<String>) {
    match (there, here) {
        (Value::Object(a), Value::Object(b)) => {
            let names: std::collections::BTreeSet<_> = a.keys().chain(b.keys()).collect();
            for name in names {
                let place = if place.is_empty() { name.clone() } else { format!("{place}.{name}") };
                let of = |object: &Map<_, _>| object.get(name).cloned().unwrap_or(Value::Null);
                differences(&place, &of(a), &of(b), said, lines);
            }
        }
        _ if there == here => {}
        _ => lines.push(format!("{place}: {there} {}, {here} {}", said[0], said[1])),
    }
}
