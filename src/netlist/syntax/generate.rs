//! Generate regions and loops.

use super::parser::{Parsed, Parser};
use super::tree::{Expr, For, Item, Name};
use crate::base::Diagnostic;
use crate::netlist::limits;

impl Parser<'_> {
    /// `generate ... endgenerate` only groups: what is inside stands in the module itself.
    pub(super) fn generate(&mut self, items: &mut Vec<Item>) -> Parsed<()> {
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
    pub(super) fn generate_for(&mut self, items: &mut Vec<Item>) -> Parsed<()> {
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
}
