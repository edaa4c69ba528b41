//! What `stepwright run` tells about a run: in words, or as one JSON object.

use std::fmt::Write as _;

use serde_json::{Map, Value, json};

use super::args::RunArguments;
use super::observers::Observers;
use super::{print, say};
use crate::base::Report;
use crate::netlist::Netlist;
use crate::simulation::{Broken, Design, Outcome};
use crate::trace::{Path, Picture, Table};

/// The number of the form that JSON objects have.
const FORMAT: u32 = 1;

/// The line that a command prints with `--json`: its object, with the form's number and the command's name in it.
pub(super) fn json(command: &str, mut object: Value) -> String {
    object["format"] = FORMAT.into();
    object["command"] = command.into();
    format!("{object}\n")
}

/// The parameters of a circuit with the values in force, as JSON.
pub(super) fn parameters(netlist: &Netlist) -> Map<String, Value> {
    netlist.parameters.iter().map(|one| (one.name.clone(), one.value.into())).collect()
}

/// Prints the result; on standard error when standard output is taken.
pub(super) fn show(
    arguments: &RunArguments,
    design: &Design,
    observers: &Observers,
    outcome: &Outcome,
) -> Result<(), Report> {
    let text = if arguments.json {
        json("run", object(design, observers, outcome))
    } else {
        let table = observers.table.as_ref().map(ToString::to_string).unwrap_or_default();
        let picture = observers.path.as_ref().map(|path| Picture(path).to_string()).unwrap_or_default();
        table + &picture + &summary(design, outcome)
    };
    if observers.take_standard_output() {
        say(text.trim_end());
        return Ok(());
    }
    print(&text)
}

/// A sentence for each requirement of the scenario that the inputs do not satisfy.
pub(super) fn warnings(design: &Design) -> Vec<String> {
    let broken = design.broken_requirements(&design.stimulus().initial);
    let sentence = |broken: Broken| {
        let Broken { place, tick, numbers } = broken;
        let requirement = &design.scenario().require[place].value;
        format!("the inputs should satisfy {requirement}, but at tick {tick} that is {numbers}")
    };
    broken.into_iter().map(sentence).collect()
}

fn summary(design: &Design, outcome: &Outcome) -> String {
    let mut text = design.circuit().name().to_owned();
    let title = &design.scenario().title;
    if !title.is_empty() {
        let _ = write!(text, ": {title}");
    }
    let _ = writeln!(text, "\n{} ticks, stopped by {}", outcome.ticks, outcome.stopped_by);
    for output in &outcome.outputs {
        let _ = write!(text, "    {:24} {}", output.port.name, output.number());
        if let Some(real) = output.real() {
            let _ = write!(text, " = {real}");
        }
        if let Some(pulses) = output.pulses {
            let _ = write!(text, "    {}, high in {}", counted(pulses.rising, "pulse"), counted(pulses.high, "tick"));
        }
        text.push('\n');
    }
    text
}

fn counted(count: u64, what: &str) -> String {
    format!("{count} {what}{}", if count == 1 { "" } else { "s" })
}

fn object(design: &Design, observers: &Observers, outcome: &Outcome) -> Value {
    let of_outputs = |value: &dyn Fn(&crate::simulation::Output) -> Option<Value>| {
        let all = outcome.outputs.iter().filter_map(|output| Some((output.port.name.clone(), value(output)?)));
        Value::Object(all.collect())
    };
    let mut object = json!({
        "circuit": design.circuit().name(),
        "parameters": parameters(design.netlist()),
        "ticks": outcome.ticks,
        "stopped_by": outcome.stopped_by.to_string(),
        "outputs": of_outputs(&|output| Some(whole(output.number()))),
        "real": of_outputs(&|output| output.real().map(Value::from)),
        "pulses": of_outputs(&|output| Some(output.pulses?.rising.into())),
        "high": of_outputs(&|output| Some(output.pulses?.high.into())),
        "warnings": warnings(design),
    });
    if let Some(table) = &observers.table {
        object["table"] = rows(table);
    }
    if let Some(path) = &observers.path {
        object["path"] = strokes(path);
    }
    object
}

/// The headings, and a list of numbers for each row.
fn rows(table: &Table) -> Value {
    let row = |(tick, numbers): (u64, Vec<i128>)| {
        let numbers = numbers.into_iter().map(whole);
        Value::Array(std::iter::once(tick.into()).chain(numbers).collect())
    };
    json!({ "columns": table.headings(), "rows": table.rows().map(row).collect::<Vec<_>>() })
}

/// A list of points for each stroke.
fn strokes(path: &Path) -> Value {
    json!(path.strokes())
}

/// A port holds 64 bits at most, signed or not, which JSON numbers of this crate do too.
fn whole(value: i128) -> Value {
    i64::try_from(value).map_or_else(|_| u64::try_from(value).unwrap_or(u64::MAX).into(), Into::into)
}
