//! Circuits that measure others: those whose scenario has a table `[measure]`.

use super::{Session, shipped};
use crate::base::{Diagnostic, Report};
use crate::scenario::{self, Expectations, Scenario};

impl Session {
    /// The same session on the shipped circuit that measures this one, which has the same inputs and parameters and a meter
    /// behind it; as it is, when its own scenario measures. What the scenario shows and expects is left out.
    ///
    /// # Errors
    /// `A001` no shipped circuit measures this one.
    pub fn measured(self) -> Result<Self, Report> {
        if self.scenario().measure.is_some() {
            return Ok(self);
        }
        let name = self.circuit().name().to_owned();
        let Some((found, meter)) = measuring().find(|(_, meter)| of(meter) == Some(&name)) else {
            return Err(unknown(&name).into());
        };
        let circuit = Session::open(found)?.circuit().clone();
        let (trace, table, plot, expect) = (Vec::new(), None, None, Expectations::default());
        Ok(self.on(circuit, |own| Scenario { measure: meter.measure, trace, table, plot, expect, ..own }))
    }
}

/// The shipped scenarios that measure, with their names.
fn measuring() -> impl Iterator<Item = (&'static str, Scenario)> {
    let parsed = shipped::names("toml").filter_map(|name| {
        let file = shipped::file(name, "toml")?;
        // Only few texts have the table, and reading all of them takes long.
        let scenario = file.text.contains("[measure]").then(|| scenario::parse(&file.name, &file.text))?.ok()?;
        Some((name, scenario))
    });
    parsed.filter(|(_, scenario)| scenario.measure.is_some())
}

fn of(scenario: &Scenario) -> Option<&str> {
    scenario.measure.as_ref().map(|measure| measure.of.as_str())
}

/// The shipped circuits that a shipped circuit measures.
#[must_use]
pub fn measurable() -> Vec<String> {
    measuring().filter_map(|(_, scenario)| of(&scenario).map(str::to_owned)).collect()
}

fn unknown(name: &str) -> Diagnostic {
    let known = measurable();
    let wrong = Diagnostic::new("A001", format!("no circuit that measures `{name}` is known"));
    let wrong = wrong.nearest(name, known.iter().map(String::as_str));
    wrong.help("for a circuit of yours write one with a deviation_meter, and a scenario of it with a table [measure]")
}
