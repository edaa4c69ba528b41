//! What stands in a module: nets, assigns, parameters; and how to get past what does not belong there.

use std::rc::Rc;

use super::lexer::Kind;
use super::parser::{Parsed, Parser};
use super::refuse::{self, Skip};
use super::tree::{Expr, Item};
use crate::blocks::Gate;

impl Parser<'_> {
    /// Items up to one of the words `until` (not taken), another module, or the end of the file.
    pub(super) fn items(&mut self, items: &mut Vec<Item>, until: &[&str]) {
        while !self.at_end() && !self.at_word("module") {
            if self.token.kind == Kind::Word && (until.contains(&self.text()) || self.text() == "endmodule") {
                return;
            }
            let start = self.token.span;
            if self.item(items).is_err() {
                self.recover();
            }
            if self.token.span == start && !self.at_end() {
                self.bump();
            }
        }
    }

    fn item(&mut self, items: &mut Vec<Item>) -> Parsed<()> {
        let fraction = self.fraction()?;
        match self.token.kind {
            Kind::Directive => {
                self.directive();
                Ok(())
            }
            Kind::Symbol(";") => {
                self.bump();
                Ok(())
            }
            Kind::Word => self.item_of_word(items, fraction),
            _ => self.expected("a declaration, an instance, a gate or an `assign`"),
        }
    }

    fn item_of_word(&mut self, items: &mut Vec<Item>, fraction: Option<Expr>) -> Parsed<()> {
        let word = self.text();
        if let Some(gate) = Gate::from_keyword(word) {
            return self.gates(items, gate);
        }
        match word {
            "wire" => self.nets(items, fraction),
            "assign" => self.assigns(items),
            "parameter" | "localparam" => self.parameters(items),
            "genvar" => self.genvars(items),
            "generate" => self.generate(items),
            "for" => self.generate_for(items),
            _ => match refuse::in_module(word) {
                Some(refused) => self.refuse_item(&refused),
                None if refuse::is_keyword(word) => {
                    let span = self.token.span;
                    let construct = format!("`{word}` is");
                    let _ = self.refuse::<()>(span, &construct, refuse::SUBSET);
                    self.bump();
                    self.recover();
                    Ok(())
                }
                None => self.instances(items),
            },
        }
    }

    /// Notes a construct outside the subset and goes past its end.
    fn refuse_item(&mut self, refused: &refuse::Refused) -> Parsed<()> {
        let span = self.token.span;
        let _ = self.refuse::<()>(span, refused.construct, refused.instead);
        match refused.skip {
            Skip::Statement => self.skip_statement(0),
            Skip::To(word) => {
                while !self.at_end() && !self.at_word("endmodule") && !self.at_word("module") {
                    let done = self.at_word(word);
                    self.bump();
                    if done {
                        break;
                    }
                }
            }
        }
        Ok(())
    }

    /// Goes past a statement inside so many brackets: to its `;`, or to the `end` of its block, and on while an
    /// `else` follows.
    pub(super) fn skip_statement(&mut self, mut brackets: u32) {
        let mut open = 0_u32;
        while !self.at_end() && !self.at_word("endmodule") && !self.at_word("module") {
            let word = if self.token.kind == Kind::Word { self.text() } else { "" };
            if open == 0 && word == "end" {
                return;
            }
            match word {
                "begin" | "case" | "casex" | "casez" | "fork" => (open, brackets) = (open + 1, 0),
                "end" | "endcase" | "join" => open = open.saturating_sub(1),
                _ if self.at("(") => brackets += 1,
                _ if self.at(")") => brackets = brackets.saturating_sub(1),
                _ => {}
            }
            let closed = matches!(word, "end" | "endcase" | "join") || (self.at(";") && brackets == 0);
            self.bump();
            if closed && open == 0 {
                // `end : label`
                if self.take(":").is_some() {
                    self.bump();
                }
                if !self.at_word("else") {
                    return;
                }
            }
        }
    }

    /// `wire signed [3:0] a, b = c;`
    fn nets(&mut self, items: &mut Vec<Item>, fraction: Option<Expr>) -> Parsed<()> {
        let net_type = self.net_type(fraction)?;
        self.no_delay()?;
        loop {
            let name = self.name("the net")?;
            if self.at("[") {
                let span = self.token.span;
                return self.refuse(span, "an array of nets is", "put its range before the name, or use several nets");
            }
            let value = if self.take("=").is_some() { Some(self.expression()?) } else { None };
            items.push(Item::Net { name, net_type: Rc::clone(&net_type), value });
            if self.end_of_list()? {
                return Ok(());
            }
        }
    }

    /// `,` or `;`, telling whether it was the latter.
    pub(super) fn end_of_list(&mut self) -> Parsed<bool> {
        if self.take(",").is_some() {
            return Ok(false);
        }
        self.expect(";", "after this")?;
        Ok(true)
    }

    pub(super) fn no_delay(&mut self) -> Parsed<()> {
        if self.at("#") {
            let span = self.token.span;
            return self.refuse(span, "a delay is", "time is whole ticks: use a delay block, which has a clock");
        }
        Ok(())
    }

    /// `assign a = b, c = d;`
    fn assigns(&mut self, items: &mut Vec<Item>) -> Parsed<()> {
        self.bump();
        self.no_delay()?;
        loop {
            let target = self.operand()?;
            self.expect("=", "after the target of the `assign`")?;
            let value = self.expression()?;
            items.push(Item::Assign { target, value });
            if self.end_of_list()? {
                return Ok(());
            }
        }
    }

    fn parameters(&mut self, items: &mut Vec<Item>) -> Parsed<()> {
        let local = self.at_word("localparam");
        self.bump();
        let kind = self.parameter_kind()?;
        loop {
            let parameter = self.parameter(kind.clone(), local)?;
            items.push(Item::Parameter(parameter));
            if self.end_of_list()? {
                return Ok(());
            }
        }
    }

    fn genvars(&mut self, items: &mut Vec<Item>) -> Parsed<()> {
        self.bump();
        loop {
            let name = self.name("the genvar")?;
            items.push(Item::Genvar(name));
            if self.end_of_list()? {
                return Ok(());
            }
        }
    }
}
