//! The inside of a module, item by item, loops written out.

use std::collections::HashSet;
use std::sync::Arc;

use super::constant::Const;
use super::evaluate::{evaluate, number};
use super::names::{Meaning, Names};
use super::template::{LocalNet, LocalScope, LocalSource, Override, Template};
use super::{Elaborator, Waiting, drives, header, pieces};
use crate::base::{Diagnostic, Span};
use crate::netlist::limits;
use crate::netlist::syntax::{Expr, For, Item, Name, NetType, Parameter};

/// Elaborates what stands in a module whose header is done.
pub(super) fn elaborate<'t>(elaborator: &mut Elaborator<'_, 't>, waiting: Waiting<'t>) {
    let Waiting { id, names, overrides, unsure } = waiting;
    // The template is put back below; nobody looks at the inside of one in between.
    let ports = &elaborator.templates[id.index()];
    let (module, damaged) = (ports.module, ports.module.damaged);
    let stand_in = header::empty(module);
    let template = std::mem::replace(&mut elaborator.templates[id.index()], stand_in);
    let mut inside =
        Inside { elaborator, template, names, overrides, scope: 0, unnamed: 0, damaged, unsure: unsure || damaged };
    inside.items(&module.items);
    inside.check_drives();
    inside.elaborator.templates[id.index()] = inside.template;
}

/// A module being elaborated.
pub(super) struct Inside<'i, 'e, 't> {
    pub(super) elaborator: &'i mut Elaborator<'e, 't>,
    pub(super) template: Template<'t>,
    pub(super) names: Names<'t>,
    overrides: Vec<Override<'t>>,
    /// Where in the template's scopes we are.
    pub(super) scope: u32,
    /// Gates without a name so far.
    pub(super) unnamed: u32,
    /// Whether a declaration may be missing because it could not be read.
    damaged: bool,
    /// Whether a driver may be missing because of an error that has been told.
    pub(super) unsure: bool,
}

impl<'t> Inside<'_, '_, 't> {
    /// Notes an error, unless it may only follow from another.
    pub(super) fn report(&mut self, diagnostic: Diagnostic) {
        if self.damaged && diagnostic.code == "N010" {
            self.unsure = true;
            return;
        }
        self.elaborator.errors.push(diagnostic);
    }

    /// The result, or nothing after noting its error.
    pub(super) fn keep<T>(&mut self, result: Result<T, Diagnostic>) -> Option<T> {
        result.map_err(|error| self.report(error)).ok()
    }

    fn items(&mut self, items: &'t [Item]) {
        for item in items {
            if self.elaborator.exhausted || self.elaborator.errors.is_full() {
                self.unsure = true;
                return;
            }
            self.item(item);
        }
    }

    fn item(&mut self, item: &'t Item) {
        match item {
            Item::Parameter(parameter) => self.parameter(parameter),
            Item::Net { name, net_type, value } => self.declare_net(name, net_type, value.as_ref()),
            Item::Assign { target, value } => self.assign(target, value),
            Item::Instance(instance) => self.instance(instance),
            Item::Gate(gate) => self.gate(gate),
            Item::Genvar(name) => self.declare(name, Meaning::Genvar),
            Item::For(one) => self.turns(one),
        }
    }

    pub(super) fn declare(&mut self, name: &'t Name, meaning: Meaning) {
        let declared = self.names.declare(name, meaning);
        self.keep(declared);
    }

    fn parameter(&mut self, parameter: &'t Parameter) {
        let value = header::parameter_value(&self.names, self.template.module, parameter, &self.overrides);
        let Some(value) = self.keep(value) else {
            return self.declare(&parameter.name, Meaning::Wrong);
        };
        self.declare(&parameter.name, Meaning::Constant(value));
        if parameter.local {
            return;
        }
        if self.scope != 0 {
            let diagnostic =
                Diagnostic::new("N004", "`parameter` in a generate block is outside the structural subset");
            self.report(diagnostic.at(parameter.name.span, "here").help("write `localparam`"));
        } else if let Some(value) =
            self.keep(header::kept_parameter(&self.names, self.template.module, parameter, value))
        {
            self.template.parameters.push(value);
        }
    }

    fn declare_net(&mut self, name: &'t Name, net_type: &NetType, value: Option<&Expr>) {
        self.elaborator.count_named(name);
        let net = header::net(&self.names, name, net_type);
        let net = match self.keep(net) {
            Some(net) => net,
            // A net that could not be declared still has its name, so that its uses are not reported too.
            None => {
                self.unsure = true;
                return self.declare(name, Meaning::Wrong);
            }
        };
        if *name.text == *"clk" {
            let diagnostic = Diagnostic::new("N023", "`clk` is the name of the clock, an input of the module");
            self.report(diagnostic.at(name.span, "a net here").help("write `input wire clk` in the module's header"));
        }
        let place = self.add_net(net);
        self.declare(name, Meaning::Net(place));
        if let Some(value) = value {
            self.initialise(name, place, value);
        }
    }

    fn add_net(&mut self, net: LocalNet) -> u32 {
        self.template.nets.push(LocalNet { scope: self.scope, ..net });
        self.template.nets.len() as u32 - 1
    }

    /// `wire x = value;`
    fn initialise(&mut self, name: &Name, net: u32, value: &Expr) {
        let width = self.template.nets[net as usize].width;
        let target = [super::Piece::Net { net, low: 0, width }];
        let span = name.span.to(value.span);
        let bits = self.bits(value);
        let bits = self.keep(bits);
        let given = bits.as_ref().map_or(width, |bits| pieces::width(bits));
        if given != width {
            self.report(pieces::mismatch(value.span, given, width).at(name.span, pieces::bit_count(width)));
        }
        match bits.filter(|_| given == width) {
            Some(bits) => self.drive(&target, &pieces::as_sources(&bits), span),
            None => self.drive(&target, &[(LocalSource::Wrong, width)], span),
        }
    }

    /// A generate loop, turn by turn.
    fn turns(&mut self, one: &'t For) {
        self.declare(&one.label, Meaning::Instance);
        match self.names.find(&one.genvar.text) {
            Some(Meaning::Genvar) => {}
            found => return self.no_genvar(&one.genvar, found.is_some()),
        }
        let first = number(&self.names, &one.first);
        let Some(mut value) = self.keep(first) else {
            self.unsure = true;
            return;
        };
        let around = &self.template.scopes[self.scope as usize].module;
        let module: Arc<str> = format!("{around}.{}", one.label.text).into();
        let mut seen = HashSet::new();
        loop {
            if !seen.insert(value) || seen.len() > limits::TURNS + 1 {
                return self.endless(one, value, seen.len());
            }
            match self.turn(one, &module, value) {
                Some(next) => value = next,
                None => return,
            }
        }
    }

    /// One turn; what the genvar is in the next, if there is one.
    fn turn(&mut self, one: &'t For, module: &Arc<str>, value: i64) -> Option<i64> {
        self.names.open();
        self.declare(&one.genvar, Meaning::Constant(Const::integer(value)));
        let condition = evaluate(&self.names, &one.condition);
        let goes_on = self.keep(condition).map(|condition| condition.word != 0);
        self.unsure |= goes_on.is_none();
        let mut next = None;
        if goes_on == Some(true) && !self.elaborator.exhausted && !self.elaborator.errors.is_full() {
            self.elaborator.count_named(&one.label);
            self.block(one, module, value);
            let step = number(&self.names, &one.next);
            next = self.keep(step);
        }
        self.names.close();
        next
    }

    fn block(&mut self, one: &'t For, module: &Arc<str>, value: i64) {
        let scope = LocalScope {
            parent: Some(self.scope),
            name: format!("{}[{value}]", one.label.text),
            module: Arc::clone(module),
            span: one.label.span,
        };
        self.template.scopes.push(scope);
        let outer = std::mem::replace(&mut self.scope, self.template.scopes.len() as u32 - 1);
        self.items(&one.items);
        self.scope = outer;
    }

    fn no_genvar(&mut self, name: &Name, declared: bool) {
        self.unsure = true;
        let message = format!("`{}` is no free genvar", name.text);
        let diagnostic = Diagnostic::new("N031", message).at(name.span, "counted by this `for`");
        self.report(diagnostic.help(if declared {
            "each loop around another has a genvar of its own".to_owned()
        } else {
            format!("declare it before the loop: `genvar {};`", name.text)
        }));
    }

    fn endless(&mut self, one: &For, value: i64, turns: usize) {
        self.unsure = true;
        let span: Span = one.condition.span;
        let message = if turns > limits::TURNS + 1 {
            format!("this `for` has more than {} turns", limits::TURNS)
        } else {
            format!("this `for` comes back to {} = {value} and never ends", one.genvar.text)
        };
        let diagnostic = Diagnostic::new("N031", message).at(span, "true for too long").at(one.next.span, "the step");
        self.report(diagnostic);
    }

    fn check_drives(&mut self) {
        for at in 0..self.template.nets.len() {
            for diagnostic in drives::check(&mut self.template.nets[at]) {
                if !(self.unsure && diagnostic.code == "N008") {
                    self.report(diagnostic);
                }
            }
        }
    }
}
