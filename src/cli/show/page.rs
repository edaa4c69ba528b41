//! How a page of `show` is laid out.

use std::fmt::Write as _;

use serde_json::{Value, json};

use super::wiring::{Instance, Port};
use crate::blocks::Direction;

/// Columns of a line that lists connections.
const COLUMNS: usize = 110;

/// Appends a heading and lines below it; nothing when there are none.
pub(super) fn section(page: &mut String, heading: &str, lines: impl IntoIterator<Item = String>) {
    let mut lines = lines.into_iter().peekable();
    if lines.peek().is_some() {
        let _ = writeln!(page, "\n{heading}");
    }
    for line in lines {
        let _ = writeln!(page, "    {}", line.trim_end());
    }
}

pub(super) fn word(direction: Direction) -> &'static str {
    match direction {
        Direction::Input => "input",
        Direction::Output => "output",
    }
}

/// `1 bit`, or `12 bits, signed`.
pub(super) fn bits(width: &str, signed: bool) -> String {
    if width == "1" { "1 bit".to_owned() } else { format!("{width} bits{}", if signed { ", signed" } else { "" }) }
}

/// `WIDTH = 12, DELAY = 2`, or nothing.
fn values(parameters: &[(String, i64)]) -> String {
    parameters.iter().map(|(name, value)| format!("{name} = {value}")).collect::<Vec<_>>().join(", ")
}

/// An instance in a list: a line with its name, and below it its connections as the circuit file has them.
pub(super) fn entry(instance: &Instance) -> Vec<String> {
    let mut lines = vec![format!("{:26} {:26} {}", instance.name, instance.of, values(&instance.parameters))];
    let mut line = String::new();
    for Port { name, nets, .. } in &instance.ports {
        let connection = format!(" .{name}({nets})");
        if !line.is_empty() && line.len() + connection.len() > COLUMNS {
            lines.push(format!("   {}", std::mem::take(&mut line)));
        }
        line.push_str(&connection);
    }
    lines.extend((!line.is_empty()).then(|| format!("   {line}")));
    lines
}

/// An instance as JSON.
pub(super) fn object(instance: &Instance) -> Value {
    let ports = instance.ports.iter().map(|port| {
        json!({
            "name": port.name,
            "direction": word(port.direction),
            "width": port.width,
            "signed": port.signed,
            "nets": port.nets,
        })
    });
    json!({
        "name": instance.name,
        "of": instance.of,
        "parameters": parameters(&instance.parameters),
        "ports": ports.collect::<Vec<_>>(),
        "place": instance.place,
    })
}

pub(super) fn parameters(parameters: &[(String, i64)]) -> Value {
    Value::Object(parameters.iter().map(|(name, value)| (name.clone(), (*value).into())).collect())
}
