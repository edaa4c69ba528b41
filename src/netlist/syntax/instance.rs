//! Instances of modules, blocks and gates.

use std::rc::Rc;

use super::lexer::Kind;
use super::parser::{Parsed, Parser};
use super::refuse;
use super::tree::{Connection, Expr, GateInstance, Instance, Item};
use crate::base::{Diagnostic, Span};
use crate::blocks::Gate;

impl Parser<'_> {
    /// `module #(...) name (...), name (...);`
    pub(super) fn instances(&mut self, items: &mut Vec<Item>) -> Parsed<()> {
        let module = self.name("a module or block")?;
        let overrides = self.overrides()?;
        if self.at("(") {
            let message = format!("this instance of `{}` has no name", module.text);
            let help = format!("write `{0} {0}_1 (...)`, with the figure's numeral", module.text);
            return self.error(Diagnostic::new("N003", message).at(module.span, "name wanted after this").help(help));
        }
        loop {
            let name = self.name(&format!("an instance of `{}`", module.text))?;
            self.no_array()?;
            self.expect("(", "and the connections after the instance's name")?;
            let connections = self.named_list("connection", ".port(net)")?;
            items.push(Item::Instance(Instance {
                module: module.clone(),
                overrides: overrides.clone(),
                name,
                connections,
            }));
            if self.end_of_list()? {
                return Ok(());
            }
        }
    }

    fn no_array(&mut self) -> Parsed<()> {
        if self.at("[") {
            let span = self.token.span;
            return self.refuse(span, "an array of instances is", "use a generate `for`");
        }
        Ok(())
    }

    fn overrides(&mut self) -> Parsed<Rc<[Connection]>> {
        let Some(hash) = self.take("#") else { return Ok(Rc::from([])) };
        if self.take("(").is_none() {
            return self.refuse(hash, "a delay or a bare parameter is", "write parameters by name: `#(.WIDTH(12))`");
        }
        Ok(self.named_list("parameter", ".WIDTH(12)")?.into())
    }

    /// `.name(value), ...)`, the opening bracket being taken already.
    fn named_list(&mut self, what: &str, example: &str) -> Parsed<Vec<Connection>> {
        let mut list = Vec::new();
        if self.take(")").is_some() {
            return Ok(list);
        }
        loop {
            self.attributes()?;
            list.push(self.named(what, example)?);
            if self.take(",").is_none() {
                self.expect(")", &format!("after the {what}s"))?;
                return Ok(list);
            }
        }
    }

    fn named(&mut self, what: &str, example: &str) -> Parsed<Connection> {
        let Some(dot) = self.take(".") else {
            let span = self.token.span;
            let construct = format!("a {what} by position is");
            return self.refuse(span, &construct, &format!("write it by name: `{example}`"));
        };
        if self.at("*") || self.at("*)") {
            let span = self.token.span;
            return self.refuse(span, "`.*` is", "name every port: a circuit is read like its figure");
        }
        let name = self.name(&format!("the {what}"))?;
        self.expect("(", &format!("after `.{}`", name.text))?;
        let value = if self.at(")") { None } else { Some(self.expression()?) };
        let close = self.expect(")", &format!("after the value of `.{}`", name.text))?;
        Ok(Connection { span: dot.to(close), name, value })
    }

    /// `and and_1 (out, a, b), and_2 (...);`
    pub(super) fn gates(&mut self, items: &mut Vec<Item>, gate: Gate) -> Parsed<()> {
        let keyword = self.bump().span;
        self.no_delay()?;
        loop {
            let start = self.token.span;
            let name = if self.at("(") { None } else { Some(self.name("the gate")?) };
            self.no_array()?;
            let open = self.expect("(", "and the terminals of the gate")?;
            self.no_strength()?;
            let (terminals, close) = self.terminals(gate, open)?;
            let span = name.as_ref().map_or(keyword, |_| start).to(close);
            items.push(Item::Gate(GateInstance { gate, name, terminals, span }));
            if self.end_of_list()? {
                return Ok(());
            }
        }
    }

    fn no_strength(&mut self) -> Parsed<()> {
        if self.token.kind == Kind::Word && refuse::is_strength(self.text()) {
            let span = self.token.span;
            return self.refuse(span, "a drive strength is", "leave it out: nets have one driver");
        }
        Ok(())
    }

    fn terminals(&mut self, gate: Gate, open: Span) -> Parsed<(Vec<Expr>, Span)> {
        if self.at(".") {
            let instead =
                format!("a gate's terminals go by position, output first: `{} g_1 (out, a, b);`", gate.keyword());
            return self.refuse(open, "a gate with named connections is", &instead);
        }
        let mut terminals = vec![self.expression()?];
        while self.take(",").is_some() {
            terminals.push(self.expression()?);
        }
        Ok((terminals, self.expect(")", "after the terminals")?))
    }
}
