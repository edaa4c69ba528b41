//! From what was typed to a circuit that can run: texts found and read, values set, names resolved.

use super::args::Target;
use super::files::{self, Found, Modules, Text};
use crate::base::{Diagnostic, Report, Sources};
use crate::netlist::{self, Netlist};
use crate::scenario::{self, Named, Scenario, Stop, UntilNet};
use crate::simulation::{DEFAULT_LIMIT, Stimulus, resolve};

/// A circuit with its stimulus.
pub(super) struct Prepared {
    /// The circuit's name, such as `su1522157/interpolator`.
    pub circuit: String,
    /// What is done to it.
    pub scenario: Scenario,
    /// The checked netlist.
    pub netlist: Netlist,
    /// The scenario resolved.
    pub stimulus: Stimulus,
}

/// The scenario behind a target (an empty one for a circuit that has none), its text, and the circuit file.
pub(super) fn find(target: &str) -> Result<(Scenario, Option<Text>, Text), Report> {
    match files::find(target)? {
        Found::Circuit(circuit, scenario) => {
            let read = scenario.as_ref().map(|text| scenario::parse(&text.name, &text.text)).transpose()?;
            Ok((read.unwrap_or_default(), scenario, circuit))
        }
        Found::Scenario(text) => {
            let read = scenario::parse(&text.name, &text.text)?;
            let circuit = files::circuit_of(&text, &read.circuit)?;
            Ok((read, Some(text), circuit))
        }
    }
}

/// Prepares what was typed.
pub(super) fn prepare(target: &Target) -> Result<Prepared, Report> {
    let (mut scenario, text, circuit) = find(&target.target)?;
    refuse_short_limit(target)?;
    overlay(&mut scenario, target);
    build(scenario, text.as_ref(), circuit)
}

/// Prepares a scenario as it stands.
pub(super) fn build(scenario: Scenario, text: Option<&Text>, circuit: Text) -> Result<Prepared, Report> {
    let parameters: Vec<_> = scenario.parameters.iter().map(|p| (p.name.clone(), p.value)).collect();
    let netlist = netlist::load(&circuit.name, &circuit.text, None, &Modules::of(&circuit), &parameters)?;
    let stimulus = resolve(&netlist, &scenario).map_err(|errors| {
        let mut sources = Sources::default();
        if let Some(text) = text {
            sources.add(text.name.clone(), text.text.clone());
        }
        Report::new(sources, errors)
    })?;
    Ok(Prepared { circuit: circuit_name(&circuit.name), scenario, netlist, stimulus })
}

/// The name of a circuit or scenario: its file without the ending and without the folder `circuits`.
pub(super) fn circuit_name(file: &str) -> String {
    let stem = file.rsplit_once('.').map_or(file, |(stem, _)| stem);
    stem.strip_prefix("circuits/").unwrap_or(stem).to_owned()
}

/// A limit that would end the run before the ticks asked for contradicts them.
fn refuse_short_limit(typed: &Target) -> Result<(), Diagnostic> {
    match (typed.ticks, typed.limit) {
        (Some(ticks), Some(limit)) if limit < ticks => {
            let diagnostic = Diagnostic::new("C007", format!("--limit {limit} is less than --ticks {ticks}"));
            Err(diagnostic.help("leave one of them out"))
        }
        _ => Ok(()),
    }
}

/// What was typed wins over what the scenario says.
fn overlay(scenario: &mut Scenario, typed: &Target) {
    for (name, value) in &typed.set {
        overlay_one(&mut scenario.inputs, name, *value);
    }
    for (name, value) in &typed.param {
        overlay_one(&mut scenario.parameters, name, *value);
    }
    let typed_net = typed.until.as_ref().map(|text| UntilNet::parse(text, None));
    scenario.stop = match (typed.ticks, typed_net, scenario.stop.take()) {
        (Some(ticks), ..) => Some(Stop::Ticks(ticks)),
        (None, Some(net), old) => Some(Stop::Until { net, limit: typed.limit.unwrap_or(limit_of(old.as_ref())) }),
        (None, None, Some(Stop::Until { net, limit })) => {
            Some(Stop::Until { net, limit: typed.limit.unwrap_or(limit) })
        }
        (None, None, old) => typed.limit.map(Stop::Ticks).or(old),
    };
}

fn limit_of(stop: Option<&Stop>) -> u64 {
    match stop {
        Some(Stop::Until { limit, .. }) => *limit,
        _ => DEFAULT_LIMIT,
    }
}

fn overlay_one<T>(entries: &mut Vec<Named<T>>, name: &str, value: T) {
    entries.retain(|entry| entry.name != name);
    entries.push(Named { name: name.to_owned(), value, span: None });
}
