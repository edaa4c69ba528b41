//! A session: a circuit and what shall be done with it, before anything is read or checked.

use super::circuit::name_of;
use super::stimulus::{self, DEFAULT_LIMIT};
use super::{Circuit, Design, EngineKind, Run, names};
use crate::base::{Diagnostic, Report, Sources};
use crate::compile;
use crate::files::Text;
use crate::scenario::{self, Expectations, Named, Number, Scenario, Stop, UntilNet};
use crate::trace::Select;

/// A circuit with its parameters, inputs and stop rule, on an engine of choice.
///
/// ```
/// use stepwright::simulation::Session;
///
/// let mut run = Session::open("su1522157/table1")?.input("minor_34", 2).start()?;
/// assert_eq!(run.finish()?.pulses("step_xy_38"), Some(3)); // a combined step is 3/4 of one along Y: 3 of them come nearest to 2
/// # Ok::<(), stepwright::base::Report>(())
/// ```
#[derive(Clone, Debug)]
pub struct Session {
    circuit: Circuit,
    scenario: Scenario,
    /// The scenario's file, for messages.
    text: Option<Text>,
    engine: EngineKind,
    observed: Select,
}

impl Circuit {
    /// A session with this circuit: power-on, all inputs 0.
    #[must_use]
    pub fn session(&self) -> Session {
        Session::of(self.clone())
    }

    /// A session with this circuit as the text of a scenario says, whatever circuit that names; `name` is what messages
    /// call the text.
    ///
    /// # Errors
    /// `S` codes, for all that is wrong in it.
    pub fn scenario(&self, name: &str, text: &str) -> Result<Session, Report> {
        let scenario = scenario::parse(name, text)?;
        Ok(Session::of_scenario(self.clone(), scenario, Text { name: name.to_owned(), path: None, text: text.into() }))
    }
}

impl Session {
    fn of(circuit: Circuit) -> Self {
        Self { circuit, scenario: Scenario::default(), text: None, engine: EngineKind::AUTO, observed: Select::all() }
    }

    pub(super) fn of_scenario(circuit: Circuit, scenario: Scenario, text: Text) -> Self {
        Self { scenario, text: Some(text), ..Self::of(circuit) }
    }

    /// The circuit.
    #[must_use]
    pub fn circuit(&self) -> &Circuit {
        &self.circuit
    }

    /// The same session on another circuit, with another scenario.
    pub(super) fn on(mut self, circuit: Circuit, scenario: impl FnOnce(Scenario) -> Scenario) -> Self {
        self.circuit = circuit;
        self.scenario = scenario(self.scenario);
        self
    }

    /// What the scenario says, with what was changed since.
    #[must_use]
    pub fn scenario(&self) -> &Scenario {
        &self.scenario
    }

    /// The scenario's file, if there is one.
    #[must_use]
    pub fn scenario_file(&self) -> Option<&Text> {
        self.text.as_ref()
    }

    /// The scenario's name, if there is one: that of its file without the ending and without the folder `circuits`. A
    /// circuit's default scenario has the circuit's name.
    #[must_use]
    pub fn scenario_name(&self) -> Option<&str> {
        self.text.as_ref().map(name_of)
    }

    /// Sets a parameter of the circuit's top module.
    #[must_use]
    pub fn parameter(mut self, name: &str, value: i64) -> Self {
        overlay(&mut self.scenario.parameters, name, value);
        self.changed()
    }

    /// Holds an input at a value from tick 0 on.
    #[must_use]
    pub fn input(mut self, name: &str, value: impl Into<Number>) -> Self {
        overlay(&mut self.scenario.inputs, name, value.into());
        self.changed()
    }

    /// Runs so many ticks.
    #[must_use]
    pub fn ticks(mut self, ticks: u64) -> Self {
        self.scenario.stop = Some(Stop::Ticks(ticks));
        self.changed()
    }

    /// Runs until a net is high (`NET`) or low (`!NET`), at most as long as the scenario did, or [`super::DEFAULT_LIMIT`].
    #[must_use]
    pub fn until(mut self, net: &str) -> Self {
        let limit = match self.scenario.stop {
            Some(Stop::Until { limit, .. }) => limit,
            _ => DEFAULT_LIMIT,
        };
        self.scenario.stop = Some(Stop::Until { net: UntilNet::parse(net, None), limit });
        self.changed()
    }

    /// Gives up after so many ticks.
    #[must_use]
    pub fn limit(mut self, ticks: u64) -> Self {
        self.scenario.stop = Some(match self.scenario.stop.take() {
            Some(Stop::Until { net, .. }) => Stop::Until { net, limit: ticks },
            Some(Stop::Ticks(wanted)) => Stop::Ticks(wanted.min(ticks)),
            None => Stop::Ticks(ticks),
        });
        self.changed()
    }

    /// A scenario's title and expectations hold only for the scenario as written.
    fn changed(mut self) -> Self {
        self.scenario.title = String::new();
        self.scenario.expect = Expectations::default();
        self
    }

    /// Chooses the engine; [`EngineKind::AUTO`] is what suits the length of the run.
    #[must_use]
    pub fn engine(self, engine: EngineKind) -> Self {
        Self { engine, ..self }
    }

    /// Chooses what of a circuit can be read by name in [`Session::start`]ed runs; everything, when nothing is chosen.
    /// Outputs always can.
    #[must_use]
    pub fn observe(self, observed: Select) -> Self {
        Self { observed, ..self }
    }

    /// Reads and checks the circuit and resolves all names.
    ///
    /// # Errors
    /// All that is wrong with the circuit, or with the names and numbers of the scenario, at once.
    pub fn elaborate(self) -> Result<Design, Report> {
        let parameters: Vec<_> = self.scenario.parameters.iter().map(|p| (p.name.clone(), p.value)).collect();
        let elaborated = self.circuit.elaborate_from_files(&parameters);
        let (netlist, mut files) = elaborated.map_err(|report| self.placed(report))?;
        files.extend(self.text.iter().filter_map(|text| text.path.clone()));
        let (resolved, mut wrong) = match stimulus::resolve(&netlist, &self.scenario) {
            Ok(resolved) => (Some(resolved), Vec::new()),
            Err(wrong) => (None, wrong),
        };
        if self.text.is_some() {
            wrong.extend(names::check(&netlist, &self.scenario, &compile::signals(&netlist)));
        }
        match resolved {
            Some(resolved) if wrong.is_empty() => {
                Ok(Design::new(self.circuit, self.scenario, netlist, resolved, self.engine, files))
            }
            _ => Err(Report::new(self.sources(), wrong)),
        }
    }

    /// The scenario's file: what the places in it point into.
    fn sources(&self) -> Sources {
        let mut sources = Sources::default();
        if let Some(text) = &self.text {
            sources.add(text.name.clone(), text.text.clone());
        }
        sources
    }

    /// An unknown parameter has no place in the circuit's files; here it gets that in the scenario.
    fn placed(&self, report: Report) -> Report {
        let unknown = |diagnostic: &Diagnostic| diagnostic.code == "N014" && diagnostic.labels.is_empty();
        if self.text.is_none() || !report.diagnostics.iter().all(unknown) {
            return report;
        }
        let place = |diagnostic: Diagnostic| {
            let quoted = |entry: &&Named<i64>| diagnostic.message.contains(&format!("`{}`", entry.name));
            let span = self.scenario.parameters.iter().find(quoted).and_then(|entry| entry.span);
            stimulus::located(diagnostic, span)
        };
        Report::new(self.sources(), report.diagnostics.into_iter().map(place).collect())
    }

    /// Puts the circuit at tick 0, with the scenario's inputs applied.
    ///
    /// # Errors
    /// As for [`Session::elaborate`]; `W002` when a chosen name is no signal; `E001` when there is no such engine here.
    pub fn start(self) -> Result<Run<'static>, Report> {
        let observed = self.observed.clone();
        self.elaborate()?.start(&observed)
    }
}

fn overlay<T>(entries: &mut Vec<Named<T>>, name: &str, value: T) {
    entries.retain(|entry| entry.name != name);
    entries.push(Named { name: name.to_owned(), value, span: None });
}
