//! Instances: of blocks, of modules, and gates.

use std::collections::HashMap;
use std::rc::Rc;

use super::connect::{Bits, bit_count, mismatch, width};
use super::evaluate::{evaluate, number};
use super::inside::Inside;
use super::names::Meaning;
use super::template::{LocalCell, LocalInstance, LocalSource, Override, PortKind};
use crate::base::word::MAX_WIDTH;
use crate::base::{Diagnostic, Span};
use crate::blocks::{self, Block, Description, Direction, Gate, Parameters, PortDescription};
use crate::netlist::checked::CellKind;
use crate::netlist::syntax::{Connection, Expr, ExprKind, GateInstance, Instance, Module, Name};

/// Connections of one instance that no port has taken yet.
type Open<'t> = HashMap<&'t str, &'t Connection>;

/// A port as a connection sees it.
struct PortPlace<'a> {
    name: &'a str,
    /// For messages: `summer.sum`.
    owner: &'a str,
    width: u32,
    /// Where it is declared, if that is in a text.
    declared: Option<Span>,
    /// How its width comes about, if that is more than a number.
    formula: Option<String>,
}

impl<'t> Inside<'_, '_, 't> {
    pub(super) fn instance(&mut self, instance: &'t Instance) {
        self.elaborator.count_parts(1, instance.name.span);
        self.declare(&instance.name, Meaning::Instance);
        if let Some(block) = blocks::find(&instance.module.text) {
            self.block_instance(block, instance);
        } else if let Some(module) = self.elaborator.modules.get(&*instance.module.text).copied() {
            self.module_instance(module, instance);
        } else {
            self.unsure = true;
            let name = &instance.module;
            let registry = blocks::REGISTRY.iter().map(|block| block.description().name);
            let known = registry.chain(self.elaborator.modules.keys().copied());
            let diagnostic = Diagnostic::new("N012", format!("there is no block or module `{}`", name.text))
                .at(name.span, "unknown")
                .nearest(&name.text, known)
                .help(format!(
                    "a module of its own file stands in `{}.v`; blocks: `stepwright list blocks`",
                    name.text
                ));
            self.report(diagnostic);
        }
    }

    /// The connections by name; a name twice is an error.
    fn open(&mut self, list: &'t [Connection], what: &str) -> Open<'t> {
        let mut open = Open::new();
        for connection in list {
            if let Some(first) = open.insert(&connection.name.text, connection) {
                let diagnostic = Diagnostic::new("N011", format!("{what} `{}` is given twice", connection.name.text));
                self.report(diagnostic.at(connection.span, "again here").at(first.span, "first here"));
            }
        }
        open
    }

    fn block_instance(&mut self, block: &'static dyn Block, instance: &'t Instance) {
        let Some(parameters) = self.block_parameters(block, instance) else {
            self.unsure = true;
            return;
        };
        let description = block.description();
        if !self.port_widths_fit(description, &parameters, instance) {
            self.unsure = true;
            return;
        }
        let mut open = self.open(&instance.connections, "the port");
        if description.clocked {
            let clock = open.remove("clk");
            self.clock(clock, &instance.name, description.name);
        }
        let mut inputs = Vec::new();
        for port in description.ports_of(Direction::Input) {
            let place = block_port(description, port, &parameters);
            inputs.extend(self.input(&place, open.remove(port.name), &instance.name));
        }
        let cell = self.template.cells.len() as u32;
        for (output, port) in description.ports_of(Direction::Output).enumerate() {
            let place = block_port(description, port, &parameters);
            let source = LocalSource::Cell { cell, output: output as u32, low: 0 };
            self.output(&place, open.remove(port.name), source);
        }
        let names: Vec<_> = description.ports.iter().map(|port| port.name).collect();
        self.unknown_ports(open, description.name, &names, None);
        let body = self.elaborator.body(block, &parameters);
        self.cell(
            instance.name.text.to_string(),
            CellKind::Block { block, parameters },
            inputs,
            body,
            instance.name.span,
        );
    }

    fn cell(
        &mut self,
        name: String,
        kind: CellKind,
        inputs: Vec<Bits>,
        body: std::sync::Arc<blocks::Body>,
        span: Span,
    ) {
        self.template.cells.push(LocalCell { scope: self.scope, name, kind, inputs, body, span });
    }

    fn block_parameters(&mut self, block: &'static dyn Block, instance: &'t Instance) -> Option<Parameters> {
        let description = block.description();
        let mut parameters = Parameters::defaults(description);
        let mut good = true;
        self.open(&instance.overrides, "the parameter");
        for given in instance.overrides.iter() {
            match self.block_parameter(description, given) {
                Some(value) => good &= parameters.set(&given.name.text, value),
                None => good = false,
            }
        }
        if !good {
            return None;
        }
        block
            .check(&parameters)
            .map_err(|why| {
                let diagnostic =
                    Diagnostic::new("N015", format!("`{}` refuses its parameters: {why}", description.name));
                let values: Vec<_> = parameters.iter().map(|(name, value)| format!("{name} = {value}")).collect();
                self.report(diagnostic.at(instance.name.span, "at this instance").help(values.join(", ")));
            })
            .ok()?;
        Some(parameters)
    }

    fn block_parameter(&mut self, description: &'static Description, given: &'t Connection) -> Option<i64> {
        let name = &*given.name.text;
        let Some(known) = description.parameters.iter().find(|parameter| parameter.name == name) else {
            let names = description.parameters.iter().map(|parameter| parameter.name);
            let diagnostic = Diagnostic::new("N014", format!("`{}` has no parameter `{name}`", description.name));
            let list: Vec<_> = names.clone().collect();
            let diagnostic = diagnostic.at(given.span, "unknown").nearest(name, names);
            self.report(if list.is_empty() {
                diagnostic
            } else {
                diagnostic.help(format!("its parameters: {}", list.join(", ")))
            });
            return None;
        };
        let expr = self.given_value(given)?;
        let value = number(&self.names, expr);
        let value = self.keep(value)?;
        if !(known.min..=known.max).contains(&value) {
            let message =
                format!("`{name}` of `{}` is {value}, but is {} to {}", description.name, known.min, known.max);
            let diagnostic = Diagnostic::new("N015", message).at(expr.span, format!("{value}"));
            self.report(diagnostic.help(format!("{name}: {}", known.doc)));
            return None;
        }
        Some(value)
    }

    fn given_value(&mut self, given: &'t Connection) -> Option<&'t Expr> {
        if given.value.is_none() {
            let diagnostic = Diagnostic::new("N014", format!("`{}` is given no value", given.name.text));
            self.report(diagnostic.at(given.span, "empty").help("write the value, or leave it out for the default"));
        }
        given.value.as_ref()
    }

    fn port_widths_fit(&mut self, description: &Description, parameters: &Parameters, instance: &Instance) -> bool {
        let mut fit = true;
        for port in description.ports {
            let bits = port.width.bits(parameters);
            if !(1..=i64::from(MAX_WIDTH)).contains(&bits) {
                fit = false;
                let message = format!("`{}.{}` would have {bits} bits", description.name, port.name);
                let diagnostic = Diagnostic::new("N018", message).at(instance.name.span, "with these parameters");
                self.report(diagnostic.help(format!("its width is {}; a word has 1 to {MAX_WIDTH} bits", port.width)));
            }
        }
        fit
    }

    fn module_instance(&mut self, module: &'t Module, instance: &'t Instance) {
        let overrides = self.module_overrides(instance);
        let template = overrides.and_then(|overrides| self.elaborator.template(module, overrides));
        let Some(template) = template.filter(|_| !module.damaged) else {
            self.unsure = true;
            return;
        };
        let index = self.template.instances.len() as u32;
        let mut open = self.open(&instance.connections, "the port");
        let mut inputs = Vec::new();
        let ports = Rc::clone(&self.elaborator.ports[template.index()]);
        for (port, place) in ports.iter().enumerate() {
            let connection = open.remove(&*place.name);
            let span = connection.map_or(instance.name.span, |connection| connection.span);
            let (name, owner) = (&*place.name, &*module.name.text);
            let as_place = PortPlace { name, owner, width: place.width, declared: Some(place.span), formula: None };
            let bits = match place.kind {
                PortKind::Clock => {
                    self.clock(connection, &instance.name, &module.name.text);
                    None
                }
                PortKind::Input => self.input(&as_place, connection, &instance.name),
                PortKind::Output => {
                    let source = LocalSource::Instance { instance: index, port: port as u32, low: 0 };
                    self.output(&as_place, connection, source);
                    None
                }
            };
            inputs.push((bits.unwrap_or_default(), span));
        }
        let names: Vec<_> = ports.iter().map(|port| &*port.name).collect();
        self.unknown_ports(open, &module.name.text, &names, Some(module.name.span));
        let (name, span) = (instance.name.text.to_string(), instance.name.span);
        self.template.instances.push(LocalInstance { scope: self.scope, name, template, inputs, span });
    }

    fn module_overrides(&mut self, instance: &'t Instance) -> Option<Vec<Override<'t>>> {
        let mut overrides = Vec::new();
        let mut good = true;
        self.open(&instance.overrides, "the parameter");
        for given in instance.overrides.iter() {
            let value = self.given_value(given).map(|expr| evaluate(&self.names, expr));
            match value.and_then(|value| self.keep(value)) {
                Some(value) => overrides.push(Override { name: &given.name.text, value, span: Some(given.span) }),
                None => good = false,
            }
        }
        good.then_some(overrides)
    }

    /// Checks that a clock port gets the clock.
    fn clock(&mut self, connection: Option<&Connection>, instance: &Name, module: &str) {
        let value = connection.and_then(|connection| connection.value.as_ref());
        let is_clock = value.is_some_and(|expr| match &expr.kind {
            ExprKind::Name(name) => match self.names.find(name) {
                Some(Meaning::Net(net)) => self.template.nets[net as usize].is_clock,
                _ => false,
            },
            _ => false,
        });
        if !is_clock {
            let message = format!("`{module}` holds state and wants the clock");
            let place = connection.map_or(instance.span, |connection| connection.span);
            let diagnostic = Diagnostic::new("N023", message).at(place, "`.clk(clk)` wanted here");
            self.report(
                diagnostic.help("there is one clock: `input wire clk` in the header, `.clk(clk)` at the instance"),
            );
        }
    }

    /// The bits that an input port gets.
    fn input(&mut self, port: &PortPlace<'_>, connection: Option<&'t Connection>, instance: &Name) -> Option<Bits> {
        let Some(value) = connection.and_then(|connection| connection.value.as_ref()) else {
            let diagnostic = Diagnostic::new("N016", format!("the input `{}` of `{}` is open", port.name, port.owner));
            let place = connection.map_or(instance.span, |connection| connection.span);
            let help = format!("connect it; to a constant if it is not used: `.{}({}'d0)`", port.name, port.width);
            self.report(diagnostic.at(place, format!("`{}` has nothing", port.name)).help(help));
            return None;
        };
        let bits = self.bits(value);
        let bits = self.keep(bits)?;
        self.elaborator.count_parts(bits.len() as u64, value.span);
        self.same_width(port, value, width(&bits)).then_some(bits)
    }

    /// Connects an output port, which may be left open.
    fn output(&mut self, port: &PortPlace<'_>, connection: Option<&'t Connection>, source: LocalSource) {
        let Some(value) = connection.and_then(|connection| connection.value.as_ref()) else { return };
        let target = self.target(value);
        let Some(target) = self.keep(target) else {
            self.unsure = true;
            return;
        };
        let wanted = width(&target);
        let source = if self.same_width(port, value, wanted) { source } else { LocalSource::Wrong };
        self.drive(&target, &[(source, wanted)], value.span);
    }

    fn same_width(&mut self, port: &PortPlace<'_>, value: &Expr, given: u32) -> bool {
        if given == port.width {
            return true;
        }
        let mut diagnostic = mismatch(value.span, given, port.width);
        diagnostic.message = format!(
            "`{}.{}` has {}, but is connected to {}",
            port.owner,
            port.name,
            bit_count(port.width),
            bit_count(given)
        );
        if let Some(declared) = port.declared {
            diagnostic = diagnostic.at(declared, bit_count(port.width));
        }
        if let Some(formula) = &port.formula {
            diagnostic = diagnostic.help(format!("the width of `{}` is {formula} = {}", port.name, port.width));
        }
        self.report(diagnostic);
        false
    }

    fn unknown_ports(&mut self, open: Open<'t>, owner: &str, names: &[&str], declared: Option<Span>) {
        let mut left: Vec<_> = open.into_values().collect();
        left.sort_by_key(|connection| connection.span);
        for connection in left {
            let name = &*connection.name.text;
            let message = format!("`{owner}` has no port `{name}`");
            let mut diagnostic = Diagnostic::new("N013", message).at(connection.span, "unknown");
            if let Some(span) = declared {
                diagnostic = diagnostic.at(span, "the module");
            }
            diagnostic = if name == "clk" {
                diagnostic.help(format!("`{owner}` holds no state and has no clock: leave `.clk` out"))
            } else {
                diagnostic.nearest(name, names.iter().copied()).help(format!("its ports: {}", names.join(", ")))
            };
            self.unsure = true;
            self.report(diagnostic);
        }
    }

    pub(super) fn gate(&mut self, gate: &'t GateInstance) {
        self.elaborator.count_parts(1 + gate.terminals.len() as u64, gate.span);
        let name = match &gate.name {
            Some(name) => {
                self.declare(name, Meaning::Instance);
                name.text.to_string()
            }
            None => {
                self.unnamed += 1;
                format!("{}_unnamed_{}", gate.gate.keyword(), self.unnamed)
            }
        };
        let [output, inputs @ ..] = &gate.terminals[..] else { return };
        let single = matches!(gate.gate, Gate::Buf | Gate::Not);
        if inputs.is_empty() || (single && inputs.len() > 1) {
            let keyword = gate.gate.keyword();
            let wanted = if single { "just one input" } else { "at least one input" };
            let diagnostic = Diagnostic::new("N017", format!("`{keyword}` has {wanted}, here {}", inputs.len()));
            let example = if single { "out, a" } else { "out, a, b" };
            self.report(
                diagnostic.at(gate.span, "this gate").help(format!("output first: `{keyword} g_1 ({example});`")),
            );
            self.unsure = true;
            return;
        }
        let keyword = gate.gate.keyword();
        let place = |name| PortPlace { name, owner: keyword, width: 1, declared: None, formula: None };
        let bits: Vec<_> = inputs.iter().map(|input| self.terminal(&place("input"), input)).collect();
        let target = self.target(output);
        let Some(target) = self.keep(target) else {
            self.unsure = true;
            return;
        };
        let wanted = width(&target);
        let good = self.same_width(&place("output"), output, wanted);
        let cell = LocalSource::Cell { cell: self.template.cells.len() as u32, output: 0, low: 0 };
        self.drive(&target, &[(if good { cell } else { LocalSource::Wrong }, wanted)], output.span);
        let body = self.elaborator.gate(gate.gate, inputs.len());
        let span = gate.name.as_ref().map_or(gate.span, |name| name.span);
        let inputs = bits.into_iter().map(Option::unwrap_or_default).collect();
        self.cell(name, CellKind::Gate(gate.gate), inputs, body, span);
    }

    fn terminal(&mut self, place: &PortPlace<'_>, expr: &Expr) -> Option<Bits> {
        let bits = self.bits(expr);
        let bits = self.keep(bits)?;
        self.same_width(place, expr, width(&bits)).then_some(bits)
    }
}

fn block_port<'a>(description: &'a Description, port: &'a PortDescription, parameters: &Parameters) -> PortPlace<'a> {
    let width = port.width.bits(parameters) as u32;
    let formula = Some(port.width.to_string()).filter(|text| *text != width.to_string());
    PortPlace { name: port.name, owner: description.name, width, declared: None, formula }
}
