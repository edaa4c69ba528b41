//! A page about a block, or about an instance of it.

use serde_json::{Value, json};

use super::page::{bits, section, word};
use super::wiring::Instance;
use crate::blocks::Description;

/// What a block does, with the ranges of its parameters; for an instance, with the values and nets of that.
pub(super) fn text(block: &Description, instance: Option<&Instance>) -> String {
    let Description { name, kind, summary, doc, source, .. } = block;
    let mut page = match instance {
        Some(instance) => format!("{}: block {name} ({kind}), at {}\n", instance.name, instance.place),
        None => format!("block {name} ({kind})\n"),
    };
    page.push_str(&format!("{summary}\n\n{doc}\n\nsource: {source}\n"));
    let values = block.parameters.iter().map(|parameter| {
        let given = instance.and_then(|instance| instance.parameters.iter().find(|(name, _)| name == parameter.name));
        let value = match given {
            Some((_, value)) => value.to_string(),
            None => format!("{} to {}, default {}", parameter.min, parameter.max, parameter.default),
        };
        format!("{:20} {value:28} {}", parameter.name, parameter.doc)
    });
    section(&mut page, "parameters", values);
    let clock = block.clocked.then(|| format!("{:7} {:20} {:28} the global tick", "input", "clk", "1 bit"));
    let ports = block.ports.iter().map(|port| {
        let made = instance.and_then(|instance| instance.ports.iter().find(|made| made.name == port.name));
        let width = made.map_or_else(|| port.width.to_string(), |made| made.width.to_string());
        let about = match made {
            Some(made) if made.nets.is_empty() => format!("(open): {}", port.doc),
            Some(made) => format!("{}: {}", made.nets, port.doc),
            None => port.doc.to_owned(),
        };
        format!("{:7} {:20} {:28} {about}", word(port.direction), port.name, bits(&width, port.signed))
    });
    section(&mut page, "ports", clock.into_iter().chain(ports));
    page
}

/// The description of a block.
pub(super) fn object(block: &Description) -> Value {
    let parameters = block
        .parameters
        .iter()
        .map(|p| json!({ "name": p.name, "min": p.min, "max": p.max, "default": p.default, "doc": p.doc }));
    let ports = block.ports.iter().map(|port| {
        json!({
            "name": port.name,
            "direction": word(port.direction),
            "width": port.width.to_string(),
            "signed": port.signed,
            "doc": port.doc,
        })
    });
    json!({
        "kind": "block",
        "name": block.name,
        "folder": block.kind.to_string(),
        "summary": block.summary,
        "doc": block.doc,
        "source": block.source,
        "clocked": block.clocked,
        "parameters": parameters.collect::<Vec<_>>(),
        "ports": ports.collect::<Vec<_>>(),
    })
}
