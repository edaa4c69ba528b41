//! Instances of blocks and of modules.

use std::rc::Rc;
use std::sync::Arc;

use super::evaluate::{evaluate, number};
use super::inside::Inside;
use super::names::Meaning;
use super::pieces::Bits;
use super::ports::PortPlace;
use super::template::{LocalCell, LocalInstance, LocalSource, Override, PortKind};
use crate::base::word::MAX_WIDTH;
use crate::base::{Diagnostic, Span};
use crate::blocks::{self, Block, Body, Description, Direction, Parameters, PortDescription};
use crate::netlist::checked::CellKind;
use crate::netlist::syntax::{Connection, Expr, Instance, Module, Name};

impl<'t> Inside<'_, '_, 't> {
    pub(super) fn instance(&mut self, instance: &'t Instance) {
        self.elaborator.count_named(&instance.name);
        self.declare(&instance.name, Meaning::Instance);
        if let Some(block) = blocks::find(&instance.module.text) {
            self.block_instance(block, instance);
        } else if let Some(module) = self.elaborator.modules.get(&*instance.module.text).copied() {
            self.module_instance(module, instance);
        } else {
            self.unsure = true;
            self.report(self.unknown_module(&instance.module));
        }
    }

    fn unknown_module(&self, name: &Name) -> Diagnostic {
        let registry = blocks::REGISTRY.iter().map(|block| block.description().name);
        let known = registry.chain(self.elaborator.modules.keys().copied());
        Diagnostic::new("N012", format!("there is no block or module `{}`", name.text))
            .at(name.span, "unknown")
            .nearest(&name.text, known)
            .help(format!("a module of its own file stands in `{}.v`; blocks: `stepwright list blocks`", name.text))
    }

    fn block_instance(&mut self, block: &'static Block, instance: &'t Instance) {
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
        self.elaborator.tell_excess(instance.name.span);
        let Some(body) = self.keep(body.map_err(|why| unbuildable(description, &parameters, &why, instance))) else {
            return;
        };
        self.cell(
            instance.name.text.to_string(),
            CellKind::Block { block, parameters },
            inputs,
            body,
            instance.name.span,
        );
    }

    /// Adds a cell to the template.
    pub(super) fn cell(&mut self, name: String, kind: CellKind, inputs: Vec<Bits>, body: Arc<Body>, span: Span) {
        self.template.cells.push(LocalCell { scope: self.scope, name, kind, inputs, body, span });
    }

    fn block_parameters(&mut self, block: &'static Block, instance: &'t Instance) -> Option<Parameters> {
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
        if !good || !self.load_image(block, &mut parameters, instance) {
            return None;
        }
        if let Err(why) = block.check(&parameters) {
            let diagnostic = Diagnostic::new("N015", format!("`{}` refuses its parameters: {why}", description.name));
            self.report(diagnostic.at(instance.name.span, "at this instance").help(values(&parameters)));
            return None;
        }
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
}

/// Parameters as a list for a message.
fn values(parameters: &Parameters) -> String {
    let values: Vec<_> = parameters.iter().map(|(name, value)| format!("{name} = {value}")).collect();
    values.join(", ")
}

/// A block that accepts its parameters but cannot be made of ops with them.
fn unbuildable(description: &Description, parameters: &Parameters, why: &str, instance: &Instance) -> Diagnostic {
    let message = format!("`{}` cannot be built with these parameters: {why}", description.name);
    let diagnostic = Diagnostic::new("N032", message).at(instance.name.span, "at this instance");
    diagnostic.help(format!("lower the widths among {}", values(parameters)))
}

fn block_port<'a>(description: &'a Description, port: &'a PortDescription, parameters: &Parameters) -> PortPlace<'a> {
    let width = port.width.bits(parameters) as u32;
    let formula = Some(port.width.to_string()).filter(|text| *text != width.to_string());
    PortPlace { name: port.name, owner: description.name, width, declared: None, formula }
}
