//! A scenario resolved against a netlist: names become input numbers and nets, numbers become words.

use crate::base::{Change, Diagnostic, Span, Stimulus, StopRule};
use crate::compile::Until;
use crate::netlist::{Net, NetId, Netlist};
use crate::scenario::{Named, Number, Requirement, Scenario, Stop, UntilNet};

/// How long a run may last when nobody says so.
pub const DEFAULT_LIMIT: u64 = 1_000_000;

/// What a scenario does to the inputs of a netlist, and when it stops.
#[derive(Debug)]
pub(super) struct Resolved {
    /// Inputs in words, and the stop rule.
    pub stimulus: Stimulus,
    /// The net to wait for, if any.
    pub until: Option<Until>,
    /// What the inputs have to satisfy, by their places.
    pub required: Vec<Requirement<usize>>,
}

/// Resolves a scenario against the circuit it names.
///
/// # Errors
/// `S010` unknown input, `S011` a number that does not fit, `S012` unknown net to wait for, `S013` no tick to run;
/// all of them at once.
pub(super) fn resolve(netlist: &Netlist, scenario: &Scenario) -> Result<Resolved, Vec<Diagnostic>> {
    let mut wrong = Vec::new();
    let mut word = |entry: &Named<Number>| input_word(netlist, entry).map_err(|error| wrong.push(error)).ok();
    let mut initial = vec![0; netlist.inputs.len()];
    for (input, value) in scenario.inputs.iter().filter_map(&mut word) {
        initial[input] = value;
    }
    let mut changes = Vec::new();
    for change in &scenario.changes {
        let words = change.set.iter().filter_map(&mut word);
        changes.extend(words.map(|(input, word)| Change { tick: change.tick, input, word }));
    }
    let required = required(netlist, scenario, &mut wrong);
    let stop = stop_rule(netlist, scenario).map_err(|error| wrong.push(error));
    match stop {
        Ok((stop, until)) if wrong.is_empty() => {
            Ok(Resolved { stimulus: Stimulus { initial, changes, stop }, until, required })
        }
        _ => Err(wrong),
    }
}

/// The requirements whose inputs there are; what is wrong with the others goes to `wrong`.
fn required(netlist: &Netlist, scenario: &Scenario, wrong: &mut Vec<Diagnostic>) -> Vec<Requirement<usize>> {
    let mut all = Vec::new();
    for entry in &scenario.require {
        let place = |name: &String| {
            let input = Named { name: name.clone(), value: (), span: entry.span };
            find_input(netlist, &input).map(|(place, _)| place)
        };
        let before = wrong.len();
        wrong.extend(entry.value.inputs().filter_map(|name| place(name).err()));
        if wrong.len() == before {
            all.push(entry.value.map(|name| place(name).unwrap_or_default()));
        }
    }
    all
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

/// The diagnostic with the place of what it is about, when that stands in a file.
pub(super) fn located(diagnostic: Diagnostic, span: Option<Span>) -> Diagnostic {
    match span {
        Some(span) => diagnostic.at(span, "here"),
        None => diagnostic,
    }
}

fn stop_rule(netlist: &Netlist, scenario: &Scenario) -> Result<(StopRule, Option<Until>), Diagnostic> {
    let (rule, until, ticks) = match &scenario.stop {
        Some(Stop::Until { net, limit }) => (StopRule::Until { limit: *limit }, Some(until_net(netlist, net)?), *limit),
        Some(Stop::Ticks(ticks)) => (StopRule::Ticks(*ticks), None, *ticks),
        None => (StopRule::Ticks(DEFAULT_LIMIT), None, DEFAULT_LIMIT),
    };
    if ticks == 0 {
        return Err(Diagnostic::new("S013", "a run of 0 ticks shows nothing").help("run at least 1 tick"));
    }
    Ok((rule, until))
}

/// Finds the net of a `NET` or `!NET`, by its dotted name below the top module.
///
/// # Errors
/// `S012`, with the nearest name; `S015` the clock.
fn until_net(netlist: &Netlist, wanted: &UntilNet) -> Result<Until, Diagnostic> {
    let name = |i| netlist.net_name(NetId::new(i));
    match (0..netlist.nets.len()).find(|&i| name(i) == wanted.net) {
        Some(net) if netlist.nets[net].is_clock => {
            let message = format!("`{}` is the clock, which is high and low in every tick", wanted.net);
            let diagnostic =
                Diagnostic::new("S015", message).help("to stop after so many ticks: --ticks N, or ticks = N in [stop]");
            Err(located(diagnostic, wanted.span))
        }
        Some(net) => Ok(Until { net: NetId::new(net), high: wanted.high }),
        None => {
            let names: Vec<_> = (0..netlist.nets.len()).filter(|&i| !netlist.nets[i].is_clock).map(name).collect();
            let diagnostic = Diagnostic::new("S012", format!("there is no net `{}` to wait for", wanted.net));
            Err(located(diagnostic.nearest(&wanted.net, names.iter().map(String::as_str)), wanted.span))
        }
    }
}
