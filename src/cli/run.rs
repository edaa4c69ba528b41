//! `stepwright run`: one circuit, one stimulus; results, tables, waveforms, a picture.

use std::fmt::Write as _;
use std::sync::Arc;

use super::args::RunArguments;
use super::judge;
use super::picture::Picture;
use super::prepare::{self, Prepared};
use super::waves::Waves;
use super::{Ending, files, print};
use crate::base::word::decode;
use crate::base::{Diagnostic, Report, Signal};
use crate::compile::{Observe, Program, compile};
use crate::engine::Engine;
use crate::scenario::{Expectations, Named, Plot, Scenario, Table as TableOf};
use crate::simulation::{self, Outcome, StoppedBy};
use crate::trace::{Plan, SaveFile, Select, Table};

pub(super) fn run(arguments: &RunArguments) -> Result<Ending, Report> {
    let prepared = prepare::prepare(&arguments.target)?;
    let watched = Watched::of(arguments, &prepared)?;
    let program = Arc::new(watched.compile(&prepared));
    watched.check(&prepared, &program)?;
    let mut table = watched.table(&program)?;
    let mut picture = watched.picture(&program)?;
    let mut waves = Waves::open(arguments, &watched.traced_signals(&program))?;
    let mut engine = arguments.target.engine.build(Arc::clone(&program), prepared.stimulus.stop.ticks)?;
    if let Some(waves) = &waves {
        engine.watch(waves.values());
    }
    let mut sample = |tick: u64, engine: &dyn Engine| {
        let read = |id| engine.value(id);
        if let Some(waves) = &mut waves {
            waves.sample(tick, engine);
        }
        if let Some(table) = &mut table {
            table.sample(tick, read);
        }
        if let Some(picture) = &mut picture {
            picture.sample(read);
        }
    };
    let outcome = if watched.each_tick(arguments) {
        simulation::run(engine.as_mut(), &program, &prepared.stimulus, Some(&mut sample))
    } else {
        simulation::run(engine.as_mut(), &program, &prepared.stimulus, None)
    };
    waves.map_or(Ok(()), Waves::finish)?;
    write_save_file(arguments, &prepared, &watched, &program)?;
    if arguments.json {
        print(&json(&prepared, &program, &outcome));
    } else {
        let shown = [table.map(|table| table.to_string()), picture.map(|picture| picture.to_string())];
        print(&(shown.into_iter().flatten().collect::<String>() + &summary(&prepared, &program, &outcome)));
    }
    let failed = judge::failed_expectations(&unchanged_expectations(arguments, &prepared), &program, &outcome);
    failed.iter().for_each(|line| eprintln!("{line}"));
    let limit = outcome.stopped_by == StoppedBy::Limit;
    if limit {
        eprintln!("the limit of {} ticks was reached before the net to wait for came", outcome.ticks);
    }
    Ok(if limit || !failed.is_empty() { Ending::Different } else { Ending::Done })
}

/// A scenario's expectations hold only for the scenario as written.
fn unchanged_expectations(arguments: &RunArguments, prepared: &Prepared) -> Expectations {
    let typed = &arguments.target;
    let changed = !typed.set.is_empty()
        || !typed.param.is_empty()
        || typed.ticks.is_some()
        || typed.until.is_some()
        || typed.limit.is_some();
    if changed { Expectations::default() } else { prepared.scenario.expect.clone() }
}

/// What of the circuit has to be read while it runs.
struct Watched {
    traced: Option<Select>,
    table: Option<TableOf>,
    picture: Option<Plot>,
}

impl Watched {
    fn of(arguments: &RunArguments, prepared: &Prepared) -> Result<Self, Report> {
        let scenario = &prepared.scenario;
        let traced = arguments.vcd.is_some() || arguments.fst.is_some() || arguments.gtkw.is_some();
        Ok(Self {
            traced: if traced { Some(selection(&arguments.trace, scenario)?) } else { None },
            table: arguments.table.then(|| table_of(prepared)),
            picture: scenario.plot.clone().filter(|_| !arguments.json),
        })
    }

    fn compile(&self, prepared: &Prepared) -> Program {
        let names = self.names();
        let signals =
            |name: &str| self.traced.as_ref().is_some_and(|traced| traced.matches(name)) || names.contains(&name);
        compile(&prepared.netlist, &Observe { signals: &signals, until: prepared.stimulus.stop.until, pulses: true })
    }

    /// The names that table and picture ask for.
    fn names(&self) -> Vec<&str> {
        let table = self.table.iter().flat_map(|table| table.columns.iter().chain(&table.when));
        let table = table.map(|column| column.name.as_str());
        table.chain(self.picture.iter().flat_map(Plot::names)).collect()
    }

    fn check(&self, prepared: &Prepared, program: &Program) -> Result<(), Report> {
        let all = || signal_names(prepared);
        self.traced.as_ref().map_or(Ok(()), |traced| traced.check(&program.signals, all))
    }

    fn traced_signals(&self, program: &Program) -> Vec<Signal> {
        let traced = |signal: &&Signal| self.traced.as_ref().is_some_and(|t| t.matches(&signal.name()));
        program.signals.iter().filter(traced).cloned().collect()
    }

    fn table(&self, program: &Program) -> Result<Option<Table>, Report> {
        let Some(table) = &self.table else { return Ok(None) };
        let columns: Vec<_> = table.columns.iter().map(|column| column.name.clone()).collect();
        let when: Vec<_> = table.when.iter().map(|net| net.name.clone()).collect();
        Table::new(&program.signals, &columns, &when).map(Some)
    }

    fn picture(&self, program: &Program) -> Result<Option<Picture>, Report> {
        self.picture.as_ref().map(|plot| Picture::new(plot, &program.signals)).transpose()
    }

    fn each_tick(&self, arguments: &RunArguments) -> bool {
        let waves = arguments.vcd.is_some() || arguments.fst.is_some();
        waves || self.table.is_some() || self.picture.is_some()
    }
}

/// The signals to trace: what was typed, else what the scenario says, else all.
pub(super) fn selection(typed: &[String], scenario: &Scenario) -> Result<Select, Report> {
    let said: Vec<_> = scenario.trace.iter().map(|glob| glob.name.clone()).collect();
    match (typed, said.as_slice()) {
        ([], []) => Select::new(["*"]),
        ([], said) => Select::new(said),
        (typed, _) => Select::new(typed),
    }
}

/// Every name that could be traced; asked only to suggest one.
pub(super) fn signal_names(prepared: &Prepared) -> Vec<String> {
    compile(&prepared.netlist, &Observe::EVERYTHING).signals.iter().map(Signal::name).collect()
}

/// The scenario's table; without one, every input and output at every tick.
fn table_of(prepared: &Prepared) -> TableOf {
    let table = prepared.scenario.table.clone().unwrap_or_default();
    if !table.columns.is_empty() {
        return table;
    }
    let netlist = &prepared.netlist;
    let ports = netlist.inputs.iter().chain(&netlist.outputs).map(|net| netlist.nets[net.index()].name.clone());
    let columns = ports.map(|name| Named { name, value: (), span: None }).collect();
    TableOf { columns, ..table }
}

fn write_save_file(
    arguments: &RunArguments,
    prepared: &Prepared,
    watched: &Watched,
    program: &Program,
) -> Result<(), Report> {
    let Some(path) = &arguments.gtkw else { return Ok(()) };
    let Some(dump) = arguments.vcd.as_ref().or(arguments.fst.as_ref()) else {
        let diagnostic = Diagnostic::new("C004", "--gtkw needs the waveform that the save file is for");
        return Err(diagnostic.help("add --vcd FILE or --fst FILE").into());
    };
    let curves: Vec<_> = prepared.scenario.plot.iter().flat_map(Plot::names).map(str::to_owned).collect();
    let plan = Plan::new(&watched.traced_signals(program));
    let dump = files::seen_from(path, dump);
    files::write_bytes(path, SaveFile { plan: &plan, dump: &dump, curves: &curves }.to_string().as_bytes())
}

fn summary(prepared: &Prepared, program: &Program, outcome: &Outcome) -> String {
    let mut text = prepared.circuit.clone();
    if !prepared.scenario.title.is_empty() {
        let _ = write!(text, ": {}", prepared.scenario.title);
    }
    let _ = writeln!(text, "\n{} ticks, stopped by {}", outcome.ticks, outcome.stopped_by);
    for (i, (port, &word)) in program.outputs.iter().zip(&outcome.outputs).enumerate() {
        let value = decode(word, port.width, port.signed);
        let _ = write!(text, "    {:24} {value}", port.name);
        if let Some(fraction) = port.fraction {
            let _ = write!(text, " = {}", value as f64 / 2f64.powi(fraction as i32));
        }
        let pulses = program.pulses.iter().zip(&outcome.pulses).find(|((output, _), _)| *output == i);
        if let Some((_, ticks)) = pulses {
            let _ = write!(text, "    high in {ticks} ticks");
        }
        text.push('\n');
    }
    text
}

fn json(prepared: &Prepared, program: &Program, outcome: &Outcome) -> String {
    let values = || {
        program.outputs.iter().zip(&outcome.outputs).map(|(port, &word)| (port, decode(word, port.width, port.signed)))
    };
    let outputs: serde_json::Map<_, _> = values().map(|(port, value)| (port.name.clone(), whole(value))).collect();
    let real = values().filter_map(|(port, value)| {
        port.fraction.map(|fraction| (port.name.clone(), (value as f64 / 2f64.powi(fraction as i32)).into()))
    });
    let pulses = program.pulses.iter().zip(&outcome.pulses);
    let pulses = pulses.map(|((output, _), &ticks)| (program.outputs[*output].name.clone(), ticks.into()));
    let parameters = prepared.netlist.parameters.iter().map(|(name, value)| (name.clone(), (*value).into()));
    let object = serde_json::json!({
        "circuit": prepared.circuit,
        "parameters": parameters.collect::<serde_json::Map<_, _>>(),
        "ticks": outcome.ticks,
        "stopped_by": outcome.stopped_by.to_string(),
        "outputs": outputs,
        "real": real.collect::<serde_json::Map<_, _>>(),
        "pulses": pulses.collect::<serde_json::Map<_, _>>(),
    });
    format!("{object}\n")
}

/// A port holds 64 bits at most, signed or not, which JSON numbers of this crate do too.
fn whole(value: i128) -> serde_json::Value {
    i64::try_from(value).map_or_else(|_| u64::try_from(value).unwrap_or(u64::MAX).into(), Into::into)
}
