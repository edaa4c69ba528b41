//! Circuits and scenarios by what people call them.

use std::path::Path;

use super::library::circuits_root;
use super::{Circuit, Session, shipped};
use crate::base::Report;
use crate::files::{self, Text};
use crate::scenario::{self, Scenario};

impl Session {
    /// The session of a scenario, or of a circuit with its default scenario: a path to a `.toml` or `.v` file, a name
    /// below `./circuits`, or the name of a shipped one. A circuit's default scenario is that of the same name beside
    /// it, if it is one of this circuit.
    ///
    /// # Errors
    /// `C001` nothing of that name, `C002` a file that cannot be read, `S` codes for what is wrong in a scenario.
    pub fn open(target: impl AsRef<Path>) -> Result<Self, Report> {
        find(target.as_ref())
    }
}

fn find(target: &Path) -> Result<Session, Report> {
    let is_path = target.is_absolute() || target.starts_with(".") || target.starts_with("..");
    match target.extension().and_then(|ending| ending.to_str()) {
        Some("toml") => return of_scenario(files::read(target)?),
        Some("v") => return of_circuit(files::read(target)?),
        _ if target.is_file() || is_path => return of_circuit(files::read(target)?),
        _ => {}
    }
    let name = target.to_string_lossy();
    let of_name = |ending: &str| -> Result<Option<Text>, Report> {
        let below = Path::new("circuits").join(format!("{name}.{ending}"));
        if below.is_file() { files::read(&below).map(Some) } else { Ok(shipped::file(&name, ending)) }
    };
    if let Some(circuit) = of_name("v")? {
        return of_circuit(circuit);
    }
    of_scenario(of_name("toml")?.ok_or_else(|| shipped::unknown(&name))?)
}

fn of_circuit(circuit: Text) -> Result<Session, Report> {
    let circuit = Circuit::from(circuit);
    let beside = match &circuit.text.path {
        Some(path) => Some(path.with_extension("toml")).filter(|path| path.is_file()).map(|path| files::read(&path)),
        None => shipped::file(circuit.name(), "toml").map(Ok),
    };
    let Some(text) = beside.transpose()? else { return Ok(circuit.session()) };
    let scenario = scenario::parse(&text.name, &text.text)?;
    match circuit_of(&text, &scenario) {
        Ok(named) if named.text.text == circuit.text.text => Ok(Session::of_scenario(circuit, scenario, text)),
        _ => Ok(circuit.session()),
    }
}

fn of_scenario(text: Text) -> Result<Session, Report> {
    let scenario = scenario::parse(&text.name, &text.text)?;
    Ok(Session::of_scenario(circuit_of(&text, &scenario)?, scenario, text))
}

/// The circuit that a scenario names: a path relative to the scenario, or a name below the `circuits` folder that the
/// scenario stands in, or a name beside it, or a shipped one.
fn circuit_of(text: &Text, scenario: &Scenario) -> Result<Circuit, Report> {
    let circuit = &scenario.circuit;
    let folder = text.path.as_deref().map(|path| path.parent().unwrap_or(Path::new("")));
    if let Some(folder) = folder.filter(|_| circuit.ends_with(".v")) {
        return Circuit::open(folder.join(circuit));
    }
    let file = format!("{circuit}.v");
    let below = folder.and_then(circuits_root).into_iter().chain(folder.map(Path::to_owned));
    match below.map(|root| root.join(&file)).find(|path| path.is_file()) {
        Some(path) => Circuit::open(path),
        None => Circuit::shipped(circuit),
    }
}
