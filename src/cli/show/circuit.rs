//! A page about a circuit, or about a module in it.

use serde_json::{Map, Value, json};

use super::super::result::parameters;
use super::page::{self, bits, entry, section, word};
use super::wiring::{Instance, Wiring};
use crate::netlist::{Net, Netlist, ScopeId};
use crate::simulation::Design;

/// The circuit: its comment, parameters, ports, and the instances it is made of.
pub(super) fn text(design: &Design) -> String {
    let (netlist, title) = (design.netlist(), &design.scenario().title);
    let mut page = format!("circuit {}\n", design.circuit().name());
    if !title.is_empty() {
        page.push_str(&format!("default scenario: {title} (show {}.toml)\n", design.circuit().name()));
    }
    page.push_str(&format!("\n{}", header_comment(design.circuit().source())));
    let given = netlist.parameters.iter().map(|one| {
        let range = match (one.least, one.most) {
            (Some(least), Some(most)) => format!("{least} to {most}"),
            (Some(least), None) => format!("at least {least}"),
            (None, Some(most)) => format!("at most {most}"),
            (None, None) => String::new(),
        };
        format!("{:20} {:<10} {range}", one.name, one.value)
    });
    section(&mut page, "parameters", given);
    section(
        &mut page,
        "ports",
        ports(design).map(|(direction, net)| {
            let fraction = net.fraction.map_or_else(String::new, |bits| format!(", {bits} of them fraction"));
            format!("{direction:7} {:20} {}{fraction}", net.name, bits(&net.width.to_string(), net.signed))
        }),
    );
    let instances = Wiring::of(netlist).instances(ScopeId::new(0));
    section(&mut page, "instances", instances.iter().flat_map(entry));
    let (cells, nets, modules) = (netlist.cells.len(), netlist.nets.len(), netlist.scopes.len());
    page + &format!("\nin all {cells} blocks and gates, {nets} nets, {modules} modules\n")
}

/// The same as JSON.
pub(super) fn object(design: &Design) -> Value {
    let netlist = design.netlist();
    let ports = ports(design).map(|(direction, net)| {
        json!({
            "name": net.name,
            "direction": direction,
            "width": net.width,
            "signed": net.signed,
            "fraction": net.fraction,
        })
    });
    let instances = Wiring::of(netlist).instances(ScopeId::new(0));
    let ranges = netlist.parameters.iter().map(|one| (one.name.clone(), json!([one.least, one.most])));
    json!({
        "kind": "circuit",
        "name": design.circuit().name(),
        "title": design.scenario().title,
        "comment": header_comment(design.circuit().source()),
        "parameters": parameters(netlist),
        "ranges": ranges.collect::<Map<_, _>>(),
        "ports": ports.collect::<Vec<_>>(),
        "instances": instances.iter().map(page::object).collect::<Vec<_>>(),
    })
}

fn ports(design: &Design) -> impl Iterator<Item = (&'static str, &Net)> {
    design.inputs().chain(design.outputs()).filter_map(|net| Some((word(net.port?), net)))
}

/// A module that stands in a circuit: its comment, its ports with the nets of this instance, what is in it.
pub(super) fn module_text(netlist: &Netlist, scope: ScopeId, instance: &Instance) -> String {
    let Instance { name, of, place, .. } = instance;
    let mut page = format!("{name}: module {of}, at {place}\n");
    page.push_str(&format!("\n{}", module_source(netlist, of).map(header_comment).unwrap_or_default()));
    section(
        &mut page,
        "ports",
        instance.ports.iter().map(|port| {
            let width = bits(&port.width.to_string(), port.signed);
            format!("{:7} {:20} {width:28} {}", word(port.direction), port.name, port.nets)
        }),
    );
    section(&mut page, "instances", Wiring::of(netlist).instances(scope).iter().flat_map(entry));
    page
}

/// The text of the file that is called as a module, which a module of its own is found by.
pub(super) fn module_source<'n>(netlist: &'n Netlist, module: &str) -> Option<&'n str> {
    let file = format!("{module}.v");
    let is_it = |name: &str| name.rsplit(['/', '\\']).next() == Some(&file);
    netlist.sources.iter().find(|(name, _)| is_it(name)).map(|(_, text)| &**text)
}

/// The comment that a circuit file opens with, after its compiler directives.
fn header_comment(text: &str) -> String {
    let lines = text.lines().skip_while(|line| line.starts_with('`') || line.trim().is_empty());
    let comment = lines.map_while(|line| line.strip_prefix("//"));
    comment.map(|line| line.strip_prefix(' ').unwrap_or(line).to_owned() + "\n").collect()
}
