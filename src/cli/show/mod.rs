//! `stepwright show`: what a circuit, scenario, block or instance is, in words, as JSON, or its source.

mod block;
mod circuit;
mod page;
mod scenario;
mod wiring;

use std::path::Path;

use serde_json::Value;

use super::result::json;
use super::{Ending, print};
use crate::base::{Diagnostic, Report};
use crate::blocks::{self, Block, Body, Builder, Parameters, REGISTRY};
use crate::export;
use crate::netlist::CellKind;
use crate::simulation::{Design, Session, shipped};
use page::word;
use wiring::{Found, Instance, Wiring};

pub(in crate::cli) use wiring::paths;

/// Shows what a name stands for: its page, with `as_json` as an object, with `source` its text.
pub(super) fn show(name: &str, source: bool, as_json: bool) -> Result<Ending, Report> {
    let subject = Subject::of(name)?;
    print(&match (source, as_json) {
        (true, _) => subject.source()?,
        (false, true) => json("show", subject.object()?),
        (false, false) => subject.page()?,
    })?;
    Ok(Ending::Done)
}

/// What can be shown.
enum Subject {
    Block(&'static Block),
    Circuit(Session),
    Scenario(Session),
    Instance(Box<Design>, Found),
    /// The image of a memory, which is shipped beside the circuits.
    Image(&'static str),
}

impl Subject {
    fn of(name: &str) -> Result<Self, Report> {
        if let Some(block) = blocks::find(name) {
            return Ok(Self::Block(block));
        }
        if let Some(text) = shipped::text(name).filter(|_| name.ends_with(".glyphs")) {
            return Ok(Self::Image(text));
        }
        let wrong = match Session::open(name) {
            Ok(session) if is_scenario(name, &session) => return Ok(Self::Scenario(session)),
            Ok(session) => return Ok(Self::Circuit(session)),
            Err(report) if is_missing(&report) => report,
            Err(report) => return Err(report),
        };
        // Names of files and of instances both have dots: the longest name that opens is the circuit's.
        for (dot, _) in name.rmatch_indices('.') {
            match Session::open(&name[..dot]) {
                Ok(session) => return Self::instance(session, &name[dot + 1..]),
                Err(report) if is_missing(&report) => {}
                Err(report) => return Err(report),
            }
        }
        Err(unknown(name, wrong))
    }

    fn instance(session: Session, path: &str) -> Result<Self, Report> {
        let design = session.elaborate()?;
        let found = wiring::find(design.netlist(), path).ok_or_else(|| {
            let paths = paths(design.netlist());
            let message = format!("`{}` has no instance `{path}`", design.circuit().name());
            let wrong = Diagnostic::new("C009", message).nearest(path, paths.iter().map(String::as_str));
            wrong.help(format!("`stepwright show {}` lists its instances", design.circuit().name()))
        })?;
        Ok(Self::Instance(Box::new(design), found))
    }

    fn page(self) -> Result<String, Report> {
        Ok(match self {
            Self::Image(text) => text.to_owned(),
            Self::Block(block) => block::text(block.description(), None),
            Self::Circuit(session) => circuit::text(&session.elaborate()?),
            Self::Scenario(session) => match session.scenario_file() {
                Some(file) => scenario::text(&session, file),
                None => String::new(),
            },
            Self::Instance(design, found) => {
                let netlist = design.netlist();
                let instance = Wiring::of(netlist).instance(found);
                match (found, block_of(&design, found)) {
                    (_, Some((block, ..))) => block::text(block.description(), Some(&instance)),
                    (Found::Scope(scope), None) => circuit::module_text(netlist, scope, &instance),
                    (Found::Cell(_), None) => gate(&instance),
                }
            }
        })
    }

    fn object(self) -> Result<Value, Report> {
        Ok(match self {
            Self::Image(text) => serde_json::json!({ "kind": "image", "text": text }),
            Self::Block(block) => block::object(block.description()),
            Self::Circuit(session) => circuit::object(&session.elaborate()?),
            Self::Scenario(session) => match session.scenario_file() {
                Some(file) => scenario::object(&session, file),
                None => Value::Null,
            },
            Self::Instance(design, found) => {
                let wiring = Wiring::of(design.netlist());
                let mut object = page::object(&wiring.instance(found));
                object["kind"] = "instance".into();
                object["block"] =
                    block_of(&design, found).map_or(Value::Null, |(of, ..)| block::object(of.description()));
                if let Found::Scope(scope) = found {
                    object["instances"] = wiring.instances(scope).iter().map(page::object).collect();
                }
                object
            }
        })
    }

    /// The file of a circuit, scenario or module; a block as Verilog, printed from its ops.
    fn source(self) -> Result<String, Report> {
        Ok(match self {
            Self::Image(text) => text.to_owned(),
            Self::Block(block) => {
                let parameters = Parameters::defaults(block.description());
                let body = Builder::build(block, &parameters).map_err(|why| Diagnostic::new("N032", why))?;
                export::block(block.description(), &parameters, &body)
            }
            Self::Circuit(session) => session.circuit().source().to_owned(),
            Self::Scenario(session) => session.scenario_file().map(|file| file.text.to_string()).unwrap_or_default(),
            Self::Instance(design, found) => match (found, block_of(&design, found)) {
                (_, Some((block, parameters, body))) => export::block(block.description(), parameters, body),
                (found, None) => {
                    let of = Wiring::of(design.netlist()).instance(found).of;
                    let text = circuit::module_source(design.netlist(), &of);
                    text.unwrap_or(design.circuit().source()).to_owned()
                }
            },
        })
    }
}

/// Whether a name means the scenario rather than the circuit whose default it is.
fn is_scenario(name: &str, session: &Session) -> bool {
    name.ends_with(".toml") || session.scenario_name().is_some_and(|scenario| scenario != session.circuit().name())
}

fn is_missing(report: &Report) -> bool {
    report
        .diagnostics
        .iter()
        .all(|diagnostic| ["C001", "C002"].contains(&diagnostic.code) && diagnostic.labels.is_empty())
}

/// The block that an instance is of.
fn block_of(design: &Design, found: Found) -> Option<(&'static Block, &Parameters, &Body)> {
    let Found::Cell(id) = found else { return None };
    let cell = &design.netlist().cells[id.index()];
    match &cell.kind {
        CellKind::Block { block, parameters } => Some((block, parameters, &cell.body)),
        CellKind::Gate(_) => None,
    }
}

fn gate(instance: &Instance) -> String {
    let mut page = format!("{}: gate {}, at {}\n", instance.name, instance.of, instance.place);
    let ports = instance.ports.iter().map(|port| format!("{:7} {:20} {}", word(port.direction), port.name, port.nets));
    page::section(&mut page, "ports", ports);
    page
}

/// The name may have been meant for a block.
fn unknown(name: &str, mut report: Report) -> Report {
    let names = REGISTRY.iter().map(|block| block.description().name);
    let names = names.chain(shipped::names("v")).chain(shipped::names("toml"));
    if let [diagnostic @ Diagnostic { code: "C001", .. }] = report.diagnostics.as_mut_slice() {
        if Path::new(name).is_dir() {
            return report;
        }
        *diagnostic = Diagnostic::new("C001", format!("there is no circuit, scenario or block `{name}`"))
            .nearest(name, names)
            .help("`stepwright list` and `stepwright list blocks` name them");
    }
    report
}
