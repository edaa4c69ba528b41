//! What stands in a module: nets, assigns, parameters, instances, gates, generate loops.

use std::rc::Rc;

use super::lexer::Kind;
use super::parser::{Parsed, Parser};
use super::refuse::{self, Skip};
use super::tree::{Connection, Expr, For, GateInstance, Instance, Item, Name};
use crate::base::{Diagnostic, Span};
use crate::blocks::Gate;
use crate::netlist::limits;

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
        let fraction = self.attributes()?;
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
    fn skip_statement(&mut self, mut brackets: u32) {
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
    fn end_of_list(&mut self) -> Parsed<bool> {
        if self.take(",").is_some() {
            return Ok(false);
        }
        self.expect(";", "after this")?;
        Ok(true)
    }

    fn no_delay(&mut self) -> Parsed<()> {
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

    /// `generate ... endgenerate` only groups: what is inside stands in the module itself.
    fn generate(&mut self, items: &mut Vec<Item>) -> Parsed<()> {
        self.bump();
        if self.blocks > 0 || self.at_word("generate") {
            let span = self.token.span;
            return self.refuse(span, "`generate` inside `generate` is", "one `generate` around all is enough");
        }
        self.blocks += 1;
        self.items(items, &["endgenerate"]);
        self.blocks -= 1;
        self.expect_word("endgenerate", "after the generate region")?;
        Ok(())
    }

    /// `for (i = 0; i < N; i = i + 1) begin : name ... end`
    fn generate_for(&mut self, items: &mut Vec<Item>) -> Parsed<()> {
        let start = self.bump().span;
        let Ok((genvar, first, condition, next, label)) = self.for_header() else {
            self.skip_statement(1);
            return Ok(());
        };
        if self.blocks >= limits::GENERATE_DEPTH {
            let message = format!("more than {} `for` blocks inside one another", limits::GENERATE_DEPTH);
            let diagnostic = Diagnostic::new("N006", message).at(start, "this one is too deep");
            let _ = self.error::<()>(diagnostic.help("put the inner ones into a module of their own"));
            self.skip_block();
            return Ok(());
        }
        self.blocks += 1;
        let mut inside = Vec::new();
        self.items(&mut inside, &["end"]);
        self.blocks -= 1;
        self.expect_word("end", &format!("of the block `{}`", label.text))?;
        items.push(Item::For(For { genvar, first, condition, next, label, items: inside }));
        Ok(())
    }

    /// Goes past the `end` of the block that is open.
    fn skip_block(&mut self) {
        let mut open = 1_u32;
        while open > 0 && !self.at_end() && !self.at_word("endmodule") && !self.at_word("module") {
            open += u32::from(self.at_word("begin"));
            open -= u32::from(self.at_word("end"));
            self.bump();
        }
    }

    /// `(i = 0; i < N; i = i + 1) begin : name`
    fn for_header(&mut self) -> Parsed<(Name, Expr, Expr, Expr, Name)> {
        self.expect("(", "after `for`")?;
        if self.at_word("genvar") {
            let span = self.token.span;
            return self.refuse(span, "`genvar` inside `for` is", "declare it before the loop: `genvar i;`");
        }
        let (genvar, first) = self.step("the genvar")?;
        self.expect(";", "after the first value")?;
        let condition = self.expression()?;
        self.expect(";", "after the condition")?;
        let (again, next) = self.step("the genvar")?;
        if again.text != genvar.text {
            let diagnostic = Diagnostic::new("N003", format!("this loop counts `{}`", genvar.text))
                .at(again.span, "but another name is stepped here")
                .at(genvar.span, "counted here");
            return self.error(diagnostic);
        }
        self.expect(")", "after the step")?;
        Ok((genvar, first, condition, next, self.block_label()?))
    }

    /// `i = value`
    fn step(&mut self, of_what: &str) -> Parsed<(Name, Expr)> {
        let name = self.name(of_what)?;
        if self.at("+") || self.at("-") {
            let span = self.token.span;
            let instead = format!("write `{0} = {0} + 1`", name.text);
            return self.refuse(span, "this step is", &instead);
        }
        self.expect("=", &format!("after `{}`", name.text))?;
        Ok((name, self.expression()?))
    }

    fn block_label(&mut self) -> Parsed<Name> {
        let begin = self.expect_word("begin", "after `for ( )`")?;
        if self.take(":").is_none() {
            let help = "name it: `begin : lane`; its turns are then `lane[0]`, `lane[1]`, ... in the waveform";
            let diagnostic = Diagnostic::new("N003", "the block of a `for` has no name");
            let _ = self.error::<()>(diagnostic.at(begin, "name wanted after this").help(help));
            return Ok(Name { text: "unnamed".into(), span: begin });
        }
        self.name("the block")
    }

    /// `module #(...) name (...), name (...);`
    fn instances(&mut self, items: &mut Vec<Item>) -> Parsed<()> {
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
        if self.at("*") {
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
    fn gates(&mut self, items: &mut Vec<Item>, gate: Gate) -> Parsed<()> {
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
