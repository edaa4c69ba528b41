//! Expressions, by binding strength; depth is limited so that no text can exhaust the stack.

use super::lexer::Kind;
use super::number::{self, Refused};
use super::parser::{Parsed, Parser, shorten};
use super::tree::{Binary, Expr, ExprKind, Name, Unary};
use crate::base::{Diagnostic, Span};
use crate::netlist::limits;

impl Parser<'_> {
    /// Any expression.
    pub(super) fn expression(&mut self) -> Parsed<Expr> {
        self.deeper(|parser| {
            let condition = parser.binary(1)?;
            if parser.take("?").is_none() {
                return Ok(condition);
            }
            let yes = parser.expression()?;
            parser.expect(":", "of the conditional")?;
            let no = parser.expression()?;
            let span = condition.span.to(no.span);
            parser.make(span, ExprKind::Conditional(Box::new([condition, yes, no])))
        })
    }

    fn deeper<T>(&mut self, inside: impl FnOnce(&mut Self) -> Parsed<T>) -> Parsed<T> {
        if self.depth >= limits::EXPRESSION_DEPTH {
            return self.too_deep(self.token.span);
        }
        self.depth += 1;
        let result = inside(self);
        self.depth -= 1;
        result
    }

    fn too_deep<T>(&mut self, span: Span) -> Parsed<T> {
        let message = format!("an expression more than {} levels deep", limits::EXPRESSION_DEPTH);
        let help = "split it into several nets or localparams";
        self.error(Diagnostic::new("N006", message).at(span, "too deep here").help(help))
    }

    fn make(&mut self, span: Span, kind: ExprKind) -> Parsed<Expr> {
        let depth = kind.parts().iter().map(|part| part.depth + 1).max().unwrap_or(0);
        if depth > limits::EXPRESSION_DEPTH { self.too_deep(span) } else { Ok(Expr { kind, span, depth }) }
    }

    /// Operators that bind at least as strongly as `strength`; all are left associative.
    fn binary(&mut self, strength: u32) -> Parsed<Expr> {
        let mut left = self.operand()?;
        loop {
            let Kind::Symbol(symbol) = self.token.kind else { return Ok(left) };
            let Some((op, binds)) = Binary::from_symbol(symbol).filter(|(_, binds)| *binds >= strength) else {
                return Ok(left);
            };
            self.bump();
            let right = self.deeper(|parser| parser.binary(binds + 1))?;
            let span = left.span.to(right.span);
            left = self.make(span, ExprKind::Binary(op, Box::new([left, right])))?;
        }
    }

    /// A prefix operator and its operand, or a single thing.
    pub(super) fn operand(&mut self) -> Parsed<Expr> {
        match self.token.kind {
            Kind::Number(literal) => {
                let span = self.bump().span;
                self.make(span, ExprKind::Number(literal))
            }
            Kind::Word => self.named_operand(),
            Kind::System => self.system_call(),
            Kind::String => self.string(),
            Kind::Symbol("(") => {
                self.bump();
                let inside = self.expression()?;
                self.expect(")", "to close the bracket")?;
                Ok(inside)
            }
            Kind::Symbol("{") => self.braces(),
            Kind::Symbol(symbol) => match Unary::from_symbol(symbol) {
                Some(op) => {
                    let start = self.bump().span;
                    let inside = self.deeper(Self::operand)?;
                    self.make(start.to(inside.span), ExprKind::Unary(op, Box::new(inside)))
                }
                None => self.expected("a net, a number or `{`"),
            },
            Kind::Directive | Kind::End => self.expected("a net, a number or `{`"),
        }
    }

    fn string(&mut self) -> Parsed<Expr> {
        let span = self.token.span;
        match number::string(self.text()) {
            Ok(literal) => {
                self.bump();
                self.make(span, ExprKind::Number(literal))
            }
            Err(Refused { message, help }) => self.error(Diagnostic::new("N005", message).at(span, "here").help(help)),
        }
    }

    fn named_operand(&mut self) -> Parsed<Expr> {
        let name = self.name("a net or parameter")?;
        if self.at(".") {
            let span = self.token.span;
            return self.refuse(span, "a name inside another scope is", "bring the net out through a port");
        }
        if self.at("(") {
            let span = name.span;
            return self.refuse(span, "a function call is", "use a block; `$clog2` is the one function there is");
        }
        if self.take("[").is_none() {
            return self.make(name.span, ExprKind::Name(name.text));
        }
        let (kind, span) = self.select(name)?;
        if self.at("[") {
            let span = self.token.span;
            return self.refuse(span, "a select of a select is", "select once: `[base +: width]`");
        }
        self.make(span, kind)
    }

    fn select(&mut self, name: Name) -> Parsed<(ExprKind, Span)> {
        let start = name.span;
        let first = self.expression()?;
        let kind = if self.take(":").is_some() {
            ExprKind::Part(name, Box::new([first, self.expression()?]))
        } else if self.at("+:") || self.at("-:") {
            let up = self.at("+:");
            self.bump();
            let base_and_width = Box::new([first, self.expression()?]);
            ExprKind::Indexed { name, up, base_and_width }
        } else {
            ExprKind::Bit(name, Box::new(first))
        };
        let close = self.expect("]", "after the select")?;
        Ok((kind, start.to(close)))
    }

    fn system_call(&mut self) -> Parsed<Expr> {
        let start = self.token.span;
        if self.text() != "$clog2" {
            let construct = format!("`{}` is", shorten(self.text()));
            return self.refuse(start, &construct, "`$clog2` is the one function there is");
        }
        self.bump();
        self.expect("(", "after `$clog2`")?;
        let inside = self.expression()?;
        let close = self.expect(")", "after the value of `$clog2`")?;
        self.make(start.to(close), ExprKind::Clog2(Box::new(inside)))
    }

    /// `{a, b}` or `{n{a, b}}`
    fn braces(&mut self) -> Parsed<Expr> {
        let open = self.bump().span;
        let first = self.expression()?;
        if self.take("{").is_some() {
            let parts = self.expressions()?;
            self.expect("}", "after what is repeated")?;
            let close = self.expect("}", "after the repetition")?;
            return self.make(open.to(close), ExprKind::Replicate(Box::new(first), parts));
        }
        let mut parts = vec![first];
        if self.take(",").is_some() {
            parts.extend(self.expressions()?);
        }
        let close = self.expect("}", "after the concatenation")?;
        self.make(open.to(close), ExprKind::Concat(parts))
    }

    fn expressions(&mut self) -> Parsed<Vec<Expr>> {
        let mut all = vec![self.expression()?];
        while self.take(",").is_some() {
            all.push(self.expression()?);
        }
        Ok(all)
    }
}
