//! Module headers: name, parameters, ports, and the attributes and types they share with nets.

use std::rc::Rc;

use super::lexer::Kind;
use super::parser::{Parsed, Parser};
use super::refuse;
use super::tree::{Attribute, Expr, Module, Name, NetType, Parameter, ParameterKind, Port, Range};
use crate::base::Diagnostic;
use crate::blocks::Direction;

impl Parser<'_> {
    /// `module name #(...) (...); ... endmodule`
    pub(super) fn module(&mut self, attributes: Vec<Attribute>) -> Option<Module> {
        let errors = self.errors();
        self.bump();
        let Ok(name) = self.name("the module") else {
            self.recover();
            return None;
        };
        let attributes = attributes.into_iter().map(|attribute| (attribute.name.text.clone(), attribute)).collect();
        let (parameters, ports, items) = (Vec::new(), Vec::new(), Vec::new());
        let mut module = Module { name, attributes, parameters, ports, items, damaged: false };
        if self.header(&mut module).is_err() {
            self.recover();
        }
        self.items(&mut module.items, &["endmodule"]);
        if self.take_word("endmodule").is_none() {
            let _ = self.expected::<()>(&format!("`endmodule` of `{}`", module.name.text));
        }
        module.damaged = self.errors() > errors;
        Some(module)
    }

    fn header(&mut self, module: &mut Module) -> Parsed<()> {
        if self.take("#").is_some() {
            self.expect("(", "after `#`")?;
            self.header_parameters(&mut module.parameters)?;
        }
        if self.take("(").is_some() && self.take(")").is_none() {
            self.ports(&mut module.ports)?;
        }
        self.expect(";", "after the module's header")?;
        Ok(())
    }

    fn header_parameters(&mut self, parameters: &mut Vec<Parameter>) -> Parsed<()> {
        loop {
            let local = self.at_word("localparam");
            if self.take_word("localparam").is_none() {
                self.expect_word("parameter", "in `#( )`")?;
            }
            let kind = self.parameter_kind()?;
            loop {
                parameters.push(self.parameter(kind.clone(), local)?);
                if self.take(",").is_none() {
                    self.expect(")", "after the parameters")?;
                    return Ok(());
                }
                if self.at_word("parameter") || self.at_word("localparam") {
                    break;
                }
            }
        }
    }

    /// What stands between `parameter` and its name.
    pub(super) fn parameter_kind(&mut self) -> Parsed<ParameterKind> {
        if self.take_word("integer").is_some() {
            return Ok(ParameterKind::Integer);
        }
        if self.token.kind == Kind::Word
            && matches!(self.text(), "real" | "realtime" | "time" | "string" | "int" | "logic" | "bit")
        {
            let span = self.token.span;
            let construct = format!("parameters of type `{}` are", self.text());
            return self.refuse(span, &construct, "parameters are whole numbers: leave the type out");
        }
        let signed = self.take_word("signed").is_some();
        let range = self.range()?;
        Ok(if signed || range.is_some() {
            ParameterKind::Vector(Rc::new(NetType { signed, range, fraction: None }))
        } else {
            ParameterKind::Untyped
        })
    }

    /// `NAME = value`
    pub(super) fn parameter(&mut self, kind: ParameterKind, local: bool) -> Parsed<Parameter> {
        let name = self.name("the parameter")?;
        self.expect("=", "and a value after the parameter's name")?;
        let value = self.expression()?;
        Ok(Parameter { name, kind, value, local })
    }

    fn ports(&mut self, ports: &mut Vec<Port>) -> Parsed<()> {
        let mut shared: Option<(Direction, Rc<NetType>)> = None;
        loop {
            let fraction = self.fraction()?;
            if let Some(direction) = self.direction()? {
                shared = Some((direction, self.net_type(fraction)?));
            }
            let Some((direction, net_type)) = shared.clone() else {
                let span = self.token.span;
                return self.refuse(
                    span,
                    "a port list without directions is",
                    "write directions and widths in the header: `module m (input wire [3:0] a, output wire b);`",
                );
            };
            let name = self.name("the port")?;
            ports.push(Port { direction, name, net_type });
            if self.at("=") || self.at("[") {
                let (span, construct) = if self.at("=") {
                    (self.token.span, "a default on a port is")
                } else {
                    (self.token.span, "an array of nets is")
                };
                return self.refuse(span, construct, "the range stands before the name, and a port has no value here");
            }
            if self.take(",").is_none() {
                self.expect(")", "after the ports")?;
                return Ok(());
            }
        }
    }

    fn direction(&mut self) -> Parsed<Option<Direction>> {
        if self.token.kind != Kind::Word {
            return Ok(None);
        }
        let direction = match self.text() {
            "input" => Direction::Input,
            "output" => Direction::Output,
            "inout" => {
                let span = self.token.span;
                return self.refuse(span, "`inout` is", "use one `input` and one `output`: nets have one driver");
            }
            _ => return Ok(None),
        };
        self.bump();
        Ok(Some(direction))
    }

    /// What stands between a direction, or `wire`, and the names: `wire signed [msb:lsb]`.
    pub(super) fn net_type(&mut self, fraction: Option<Expr>) -> Parsed<Rc<NetType>> {
        self.take_word("wire");
        let signed = self.take_word("signed").is_some();
        if !signed {
            self.take_word("unsigned");
        }
        if self.token.kind == Kind::Word
            && let Some((construct, instead)) = refuse::net_kind(self.text())
        {
            let span = self.token.span;
            return self.refuse(span, construct, instead);
        }
        let range = self.range()?;
        Ok(Rc::new(NetType { signed, range, fraction }))
    }

    /// `[msb:lsb]`, if it is there.
    fn range(&mut self) -> Parsed<Option<Range>> {
        let Some(open) = self.take("[") else { return Ok(None) };
        let msb = self.expression()?;
        self.expect(":", "in the range `[msb:lsb]`")?;
        let lsb = self.expression()?;
        let close = self.expect("]", "after the range")?;
        Ok(Some(Range { msb, lsb, span: open.to(close) }))
    }

    /// Attributes, if there are any.
    pub(super) fn attributes(&mut self) -> Parsed<Vec<Attribute>> {
        let mut attributes = Vec::new();
        while self.take("(*").is_some() {
            loop {
                if self.token.kind != Kind::Word {
                    return self.expected("the name of an attribute");
                }
                let name = Name { text: self.text().into(), span: self.token.span };
                self.bump();
                let value = if self.take("=").is_some() { self.attribute_value()? } else { None };
                attributes.push(Attribute { name, value });
                if self.take(",").is_none() {
                    self.expect("*)", "after the attributes")?;
                    break;
                }
            }
        }
        Ok(attributes)
    }

    fn attribute_value(&mut self) -> Parsed<Option<Expr>> {
        if self.token.kind == Kind::String {
            self.bump();
            return Ok(None);
        }
        self.expression().map(Some)
    }

    /// Attributes of a net, if there are any: the value of `fraction`; others mean nothing here.
    pub(super) fn fraction(&mut self) -> Parsed<Option<Expr>> {
        let found = self.attributes()?.into_iter().rfind(|attribute| *attribute.name.text == *"fraction");
        match found {
            Some(Attribute { name, value: None }) => {
                let diagnostic = Diagnostic::new("N030", "`fraction` without a number");
                self.error(diagnostic.at(name.span, "how many fraction bits?").help("as in `(* fraction = 3 *)`"))
            }
            found => Ok(found.and_then(|attribute| attribute.value)),
        }
    }
}
