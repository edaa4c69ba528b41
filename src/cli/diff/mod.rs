//! `stepwright diff`: two waveform files, where they first differ, and which nets went wrong first.

mod arguments;

use std::fmt::Write as _;

use serde_json::{Value, json};

use super::drivers::drivers;
use super::result::json as line;
use super::{Ending, print};
use crate::base::{Diagnostic, Report};
use crate::golden::{self, Cause, Changed, Comparison, Divergence, How, Input, Names, Signals};
use crate::simulation::Session;
pub use arguments::DiffArguments;

pub(super) fn diff(arguments: &DiffArguments) -> Result<Ending, Report> {
    let (a, b) = (Input::file(&arguments.a), Input::file(&arguments.b));
    let how = how(arguments, [&a, &b])?;
    let (comparison, causes) = match &arguments.circuit {
        Some(circuit) => {
            let design = Session::open(circuit)?.elaborate()?;
            golden::explain(&a, &b, &how, &drivers(design.netlist()))?
        }
        None => (golden::diff(&a, &b, &how)?, Vec::new()),
    };
    print(&if arguments.json { line("diff", object(&comparison, &causes)) } else { text(&comparison, &causes) })?;
    Ok(match comparison.is_equal() {
        true => Ending::Done,
        false if comparison.nets == 0 || comparison.span.is_empty() => Ending::Nothing,
        false => Ending::Different,
    })
}

/// How the arguments say that two files are compared.
///
/// # Errors
/// `C008` a window without a tick; those of [`golden::edges`].
fn how(arguments: &DiffArguments, inputs: [&Input; 2]) -> Result<How, Report> {
    let (from, to) = (arguments.from, arguments.to);
    if let (Some(from), Some(to)) = (from, to)
        && from > to
    {
        let message = format!("--from {from} is after --to {to}: no tick is between them");
        return Err(Diagnostic::new("C008", message).help("--from is the first tick, --to the last one").into());
    }
    let window = from.unwrap_or(0)..to.map_or(u64::MAX, |to| to.saturating_add(1));
    let at = match &arguments.at {
        Some(net) => golden::edges(inputs, net.trim_start_matches('!'), !net.starts_with('!'))?,
        None => [None, None],
    };
    Ok(How {
        signals: Signals::Common,
        names: Names::Tails(arguments.map.clone()),
        at,
        unknown: arguments.mask,
        late: arguments.late,
        near: arguments.near,
        window: (from.is_some() || to.is_some()).then_some(window),
    })
}

fn text(comparison: &Comparison, causes: &[Cause]) -> String {
    let mut text = comparison.to_string();
    for cause in causes {
        let _ = write!(text, "{cause}");
    }
    for Changed { name, first, ticks } in comparison.changed.iter().take(MOST_NAMES) {
        let _ = writeln!(text, "{name} differs in {ticks} ticks, first in tick {first}");
    }
    if comparison.changed.len() > MOST_NAMES {
        let _ = writeln!(text, "and {} more", comparison.changed.len() - MOST_NAMES);
    }
    text
}

/// How many of the signals that differ are listed for a person.
const MOST_NAMES: usize = 20;

fn object(comparison: &Comparison, causes: &[Cause]) -> Value {
    let differing = comparison.changed.iter().map(|Changed { name, ticks, .. }| (name.clone(), (*ticks).into()));
    let widths = comparison.widths.iter().map(|(name, a, b)| json!({ "net": name, "a": a, "b": b }));
    let causes: Vec<_> = causes.iter().map(cause).collect();
    json!({
        "equal": comparison.is_equal(),
        "compared": comparison.nets,
        "tick_fs": comparison.unit,
        "first": comparison.divergence.as_ref().map(first),
        "differing": Value::Object(differing.collect()),
        "only_a": comparison.missing,
        "only_b": comparison.extra,
        "uncompared": comparison.uncompared,
        "widths": widths.collect::<Vec<_>>(),
        "ticks": comparison.spans.as_ref().map(|(a, b)| json!({ "a": [a.start, a.end], "b": [b.start, b.end] })),
        "cause": causes.first(),
        "causes": causes,
    })
}

/// A net that first went wrong.
pub(super) fn cause(cause: &Cause) -> Value {
    let (a, b) = cause.values();
    json!({
        "net": cause.net,
        "block": cause.place,
        "tick": cause.tick,
        "a": number(a),
        "b": number(b),
        "untraced": cause.untraced,
        "follows": cause.follows,
    })
}

/// The first tick at which two waveforms differ, with the first of the nets that do.
pub(super) fn first(divergence: &Divergence) -> Value {
    let at = (divergence.tick - divergence.around.start) as usize;
    let Some(net) = divergence.nets.first() else { return Value::Null };
    json!({
        "tick": divergence.tick,
        "net": net.name,
        "a": number(&net.expected[at]),
        "b": number(&net.got[at]),
    })
}

/// A word as a number; as text where it is none, or longer than a number of JSON.
fn number(shown: &str) -> Value {
    u64::from_str_radix(shown, 16).map_or_else(|_| shown.into(), Value::from)
}
