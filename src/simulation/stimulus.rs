//! A scenario resolved against a netlist: names become input numbers and nets, numbers become words.

use crate::base::Diagnostic;
use crate::compile::Until;
use crate::netlist::{Net, NetId, Netlist};
use crate::scenario::{Named, Number, Scenario, Stop, UntilNet};

/// What is done to a circuit's inputs, and when to stop.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Stimulus {
    /// The word of every input at tick 0 before the changes of tick 0, in the order of [`Netlist::inputs`].
    pub initial: Vec<u64>,
    /// Ticks in increasing order, each with the inputs that change in it and their new words.
    pub changes: Vec<(u64, Vec<(usize, u64)>)>,
    /// When to stop.
    pub stop: StopRule,
}

/// When a run ends.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct StopRule {
    /// The net to wait for, if any.
    pub until: Option<Until>,
    /// The first tick in which `until` is judged.
    pub first_judged: u64,
    /// Most ticks to run, at least 1.
    pub ticks: u64,
}

/// How long a run may last when neither scenario nor user says so.
pub const DEFAULT_LIMIT: u64 = 1_000_000;

/// Resolves a scenario against the circuit it names.
///
/// # Errors
/// `S010` unknown input, `S011` a number that does not fit, `S012` unknown net to wait for, `S013` no tick to run;
/// all of them at once.
pub fn resolve(netlist: &Netlist, scenario: &Scenario) -> Result<Stimulus, Vec<Diagnostic>> {
    let mut wrong = Vec::new();
    let mut word = |entry: &Named<Number>| input_word(netlist, entry).map_err(|error| wrong.push(error)).ok();
    let mut initial = vec![0; netlist.inputs.len()];
    for (input, value) in scenario.inputs.iter().filter_map(&mut word) {
        initial[input] = value;
    }
    let mut changes: Vec<(u64, Vec<(usize, u64)>)> = Vec::new();
    for change in &scenario.changes {
        let words = change.set.iter().filter_map(&mut word);
        match changes.last_mut() {
            Some((tick, all)) if *tick == change.tick => all.extend(words),
            _ => changes.push((change.tick, words.collect())),
        }
    }
    let stop = stop_rule(netlist, scenario).map_err(|error| wrong.push(error));
    match stop {
        Ok(stop) if wrong.is_empty() => Ok(Stimulus { initial, changes, stop }),
        _ => Err(wrong),
    }
}

fn input_word(netlist: &Netlist, entry: &Named<Number>) -> Result<(usize, u64), Diagnostic> {
    let (input, net) = find_input(netlist, entry)?;
    let word = entry.value.encode(net.width, net.signed, net.fraction);
    word.map(|word| (input, word)).map_err(|error| {
        let diagnostic = Diagnostic::new("S011", format!("input `{}`: {error}", entry.name));
        located(diagnostic, entry.span)
    })
}

fn find_input<'n, T>(netlist: &'n Netlist, entry: &Named<T>) -> Result<(usize, &'n Net), Diagnostic> {
    let nets = || netlist.inputs.iter().map(|net| &netlist.nets[net.index()]);
    nets().enumerate().find(|(_, net)| net.name == entry.name).ok_or_else(|| {
        let circuit = &netlist.scopes[0].name;
        let names: Vec<_> = nets().map(|net| net.name.as_str()).collect();
        let diagnostic = Diagnostic::new("S010", format!("the circuit `{circuit}` has no input `{}`", entry.name))
            .nearest(&entry.name, names.iter().copied())
            .help(format!("its inputs are: {}", names.join(", ")));
        located(diagnostic, entry.span)
    })
}

fn located(diagnostic: Diagnostic, span: Option<crate::base::Span>) -> Diagnostic {
    match span {
        Some(span) => diagnostic.at(span, "here"),
        None => diagnostic,
    }
}

fn stop_rule(netlist: &Netlist, scenario: &Scenario) -> Result<StopRule, Diagnostic> {
    let first_judged = scenario.first_judged_tick();
    let (until, ticks) = match &scenario.stop {
        Some(Stop::Ticks(ticks)) => (None, *ticks),
        Some(Stop::Until { net, limit }) => (Some(until_net(netlist, net)?), *limit),
        None => (None, DEFAULT_LIMIT),
    };
    if ticks == 0 {
        return Err(Diagnostic::new("S013", "a run of 0 ticks shows nothing").help("run at least 1 tick"));
    }
    Ok(StopRule { until, first_judged, ticks })
}

/// Finds the net of a `NET` or `!NET`, by its dotted name below the top module.
///
/// # Errors
/// `S012`, with the nearest name.
fn until_net(netlist: &Netlist, wanted: &UntilNet) -> Result<Until, Diagnostic> {
    let names: Vec<String> = (0..netlist.nets.len()).map(|i| netlist.net_name(NetId::new(i))).collect();
    match names.iter().position(|name| *name == wanted.net) {
        Some(net) => Ok(Until { net: NetId::new(net), high: wanted.high }),
        None => {
            let diagnostic = Diagnostic::new("S012", format!("there is no net `{}` to wait for", wanted.net));
            Err(located(diagnostic.nearest(&wanted.net, names.iter().map(String::as_str)), wanted.span))
        }
    }
}
