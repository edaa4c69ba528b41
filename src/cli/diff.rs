//! `stepwright diff`: two waveform files, and where they first differ.

use std::path::Path;

use serde_json::{Value, json};

use super::result::json as line;
use super::{Ending, print};
use crate::base::Report;
use crate::golden::{self, Changed, Comparison, Divergence, How, Input};

pub(super) fn diff(a: &Path, b: &Path, json: bool) -> Result<Ending, Report> {
    let comparison = golden::diff(&Input::file(a), &Input::file(b), &How::default())?.comparison;
    print(&if json { line("diff", object(&comparison)) } else { comparison.to_string() })?;
    Ok(if comparison.is_equal() { Ending::Done } else { Ending::Different })
}

fn object(comparison: &Comparison) -> Value {
    let differing = comparison.changed.iter().map(|Changed { name, ticks, .. }| (name.clone(), (*ticks).into()));
    let widths = comparison.widths.iter().map(|(name, a, b)| json!({ "net": name, "a": a, "b": b }));
    json!({
        "equal": comparison.is_equal(),
        "first": comparison.divergence.as_ref().map(first),
        "differing": Value::Object(differing.collect()),
        "only_a": comparison.missing,
        "only_b": comparison.extra,
        "uncompared": comparison.uncompared,
        "widths": widths.collect::<Vec<_>>(),
        "ticks": comparison.spans.as_ref().map(|(a, b)| json!({ "a": [a.start, a.end], "b": [b.start, b.end] })),
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
