//! Circuits and scenarios by what people call them.

use std::path::Path;

use super::library::circuits_root;
use super::stimulus::located;
use super::{Circuit, Session, shipped};
use crate::base::{Diagnostic, Report, Sources};
use crate::files::{self, Text};
use crate::scenario::{self, Scenario};

impl Session {
    /// The session of a scenario, or of a circuit with its default scenario: a path to a `.toml` or `.v` file, also
    /// without its ending, or such a path below `./circuits`, or the name of a shipped one. A circuit's default scenario
    /// is that of the same name beside it, if it is one of this circuit.
    ///
    /// # Errors
    /// `C001` nothing of that name, or a folder; `C002` a file that cannot be read; `S` codes for what is wrong in a
    /// scenario.
    pub fn open(target: impl AsRef<Path>) -> Result<Self, Report> {
        let path = target.as_ref();
        let ending =
            path.extension().and_then(|ending| ending.to_str()).filter(|ending| ["v", "toml"].contains(ending));
        if let Some(ending) = ending {
            // A file that is nowhere is told as such.
            let text = of_name(&path.with_extension(""), ending)?.map_or_else(|| files::read(path), Ok)?;
            return if ending == "v" { of_circuit(text) } else { of_scenario(text) };
        }
        if path.is_file() {
            return of_circuit(files::read(path)?);
        }
        if let Some(circuit) = of_name(path, "v")? {
            return of_circuit(circuit);
        }
        match of_name(path, "toml")? {
            Some(scenario) => of_scenario(scenario),
            None if path.is_dir() => Err(is_a_folder(path).into()),
            None if path.is_absolute() || path.starts_with(".") || path.starts_with("..") => {
                of_circuit(files::read(path)?)
            }
            None => Err(shipped::unknown(&path.to_string_lossy()).into()),
        }
    }
}

/// A file by its path without the ending, or by that below `./circuits`, or a shipped one.
fn of_name(name: &Path, ending: &str) -> Result<Option<Text>, Report> {
    let file = name.with_added_extension(ending);
    let near = [file.clone(), Path::new("circuits").join(&file)];
    match near.iter().find(|path| path.exists()) {
        Some(path) => files::read(path).map(Some),
        None => Ok(shipped::file(&name.to_string_lossy(), ending)),
    }
}

/// How many files of a folder are named.
const MOST_NAMES: usize = 20;

fn is_a_folder(folder: &Path) -> Diagnostic {
    let wrong = Diagnostic::new("C001", format!("{} is a folder: name a circuit or scenario in it", folder.display()));
    let all = files::below(folder, "toml").into_iter().chain(files::below(folder, "v"));
    let names: Vec<_> = all.take(MOST_NAMES).map(|path| path.display().to_string()).collect();
    if names.is_empty() {
        wrong.help("there is none below it")
    } else {
        wrong.help(format!("such as {}", names.join(", ")))
    }
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
    let circuit = circuit_of(&text, &scenario).map_err(|report| named_at(&text, &scenario, report))?;
    Ok(Session::of_scenario(circuit, scenario, text))
}

/// A circuit that is not to be found, with the place where the scenario names it.
fn named_at(text: &Text, scenario: &Scenario, report: Report) -> Report {
    let mut sources = Sources::default();
    sources.add(text.name.clone(), text.text.clone());
    let wrong = report.diagnostics.into_iter().map(|wrong| located(wrong, scenario.circuit_span));
    Report::new(sources, wrong.collect())
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
