//! The names in a scenario's trace, table, plot and expectations, held against the circuit before anything runs.

use std::collections::HashMap;

use super::stimulus::located;
use crate::base::{Diagnostic, Signal};
use crate::netlist::Netlist;
use crate::scenario::{Axis, Named, Number, Scenario};
use crate::trace::Select;

/// How many mistakes are told.
const MOST_ERRORS: usize = 20;

/// What is wrong with them: `S011` a number that does not fit, `S012` unknown net, `S016` pulses of what is no output of
/// one bit, `W001` what is no glob, `W002` a glob that matches nothing; each with its place.
pub(super) fn check(netlist: &Netlist, scenario: &Scenario, signals: &[Signal]) -> Vec<Diagnostic> {
    let names: Vec<_> = signals.iter().map(Signal::name).collect();
    let places = names.iter().zip(0..).map(|(name, place)| (name.as_str(), place)).collect();
    let known = Known { signals, names: &names, places };
    let globs = scenario.trace.iter().filter_map(|glob| matches_something(signals, glob).err());
    let tables = scenario.table.iter().flat_map(|table| table.when.iter().chain(&table.columns));
    let pens = scenario.plot.iter().filter_map(|plot| plot.pen.as_ref());
    let axes = scenario.plot.iter().flat_map(|plot| [&plot.x, &plot.y]).flat_map(named_by);
    let nets = tables.chain(pens).cloned().chain(axes).filter_map(|net| known.signal(&net).err());
    let values = scenario.expect.outputs.iter().filter_map(|net| known.fits(net).err());
    let pulses = scenario.expect.pulses.iter().filter_map(|output| gives_pulses(netlist, output).err());
    globs.chain(nets).chain(values).chain(pulses).take(MOST_ERRORS).collect()
}

fn matches_something(signals: &[Signal], glob: &Named<()>) -> Result<(), Diagnostic> {
    let wrong = Select::new([&glob.name]).and_then(|select| select.of(signals)).err();
    let wrong = wrong.into_iter().flat_map(|report| report.diagnostics).next();
    wrong.map_or(Ok(()), |wrong| Err(located(wrong, glob.span)))
}

fn named_by(axis: &Axis) -> Vec<Named<()>> {
    match axis {
        Axis::Signal(net) => vec![net.clone()],
        Axis::Steps(steps) => {
            steps.iter().map(|step| Named { name: step.name.clone(), value: (), span: step.span }).collect()
        }
    }
}

struct Known<'a> {
    signals: &'a [Signal],
    names: &'a [String],
    places: HashMap<&'a str, usize>,
}

impl Known<'_> {
    fn signal<T>(&self, net: &Named<T>) -> Result<&Signal, Diagnostic> {
        self.places.get(net.name.as_str()).map(|&place| &self.signals[place]).ok_or_else(|| {
            let wrong = Diagnostic::new("S012", format!("there is no net `{}`", net.name));
            located(wrong.nearest(&net.name, self.names.iter().map(String::as_str)), net.span)
        })
    }

    fn fits(&self, net: &Named<Number>) -> Result<(), Diagnostic> {
        let signal = self.signal(net)?;
        let word = net.value.encode(signal.width, signal.signed, signal.fraction);
        let wrong = |error| located(Diagnostic::new("S011", format!("net `{}`: {error}", net.name)), net.span);
        word.map(drop).map_err(wrong)
    }
}

fn gives_pulses<T>(netlist: &Netlist, output: &Named<T>) -> Result<(), Diagnostic> {
    let outputs = netlist.outputs.iter().map(|net| &netlist.nets[net.index()]);
    let names: Vec<_> = outputs.filter(|net| net.width == 1).map(|net| net.name.as_str()).collect();
    if names.contains(&output.name.as_str()) {
        return Ok(());
    }
    let wrong = Diagnostic::new("S016", format!("`{}` is no output of one bit, whose pulses are counted", output.name))
        .nearest(&output.name, names.iter().copied())
        .help(format!("those of this circuit: {}", if names.is_empty() { "none".into() } else { names.join(", ") }));
    Err(located(wrong, output.span))
}
