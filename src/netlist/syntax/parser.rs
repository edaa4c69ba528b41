//! The parser's ground: the present token, what is expected of it, and how to go on after an error.

use super::lexer::{Kind, Lexer, Token};
use super::refuse;
use super::tree::{Module, Name};
use crate::base::{Diagnostic, SourceId, Span};
use crate::netlist::errors::Errors;
use crate::netlist::limits;

/// An error that has been noted already.
#[derive(Clone, Copy, Debug)]
pub(super) struct Noted;

pub(super) type Parsed<T> = Result<T, Noted>;

/// Reads all modules of a text; what is wrong goes to `errors`.
pub(in crate::netlist) fn parse(source: SourceId, text: &str, errors: &mut Errors) -> Vec<Module> {
    let mut lexer = Lexer::new(source, text);
    lexer.errors = std::mem::take(errors);
    let token = lexer.next();
    let mut parser = Parser { lexer, token, depth: 0, blocks: 0 };
    let modules = parser.file();
    *errors = parser.lexer.errors;
    modules
}

pub(super) struct Parser<'t> {
    lexer: Lexer<'t>,
    /// The token that is looked at.
    pub(super) token: Token,
    /// Expressions open around it.
    pub(super) depth: u32,
    /// `for` blocks open around it.
    pub(super) blocks: u32,
}

impl<'t> Parser<'t> {
    /// The text of the present token.
    pub(super) fn text(&self) -> &'t str {
        self.lexer.text(self.token.span)
    }

    /// Goes to the next token and returns the one left behind.
    pub(super) fn bump(&mut self) -> Token {
        let next = self.lexer.next();
        std::mem::replace(&mut self.token, next)
    }

    /// Whether the present token is this symbol.
    pub(super) fn at(&self, symbol: &str) -> bool {
        matches!(self.token.kind, Kind::Symbol(present) if present == symbol)
    }

    /// Whether the present token is this word.
    pub(super) fn at_word(&self, word: &str) -> bool {
        self.token.kind == Kind::Word && self.text() == word
    }

    pub(super) fn at_end(&self) -> bool {
        self.token.kind == Kind::End
    }

    /// Takes this symbol, if it is there.
    pub(super) fn take(&mut self, symbol: &str) -> Option<Span> {
        self.at(symbol).then(|| self.bump().span)
    }

    /// Takes this word, if it is there.
    pub(super) fn take_word(&mut self, word: &str) -> Option<Span> {
        self.at_word(word).then(|| self.bump().span)
    }

    /// Takes this symbol or notes that it is missing.
    pub(super) fn expect(&mut self, symbol: &str, place: &str) -> Parsed<Span> {
        self.take(symbol).ok_or(()).or_else(|()| self.expected(&format!("`{symbol}` {place}")))
    }

    /// Takes this keyword or notes that it is missing.
    pub(super) fn expect_word(&mut self, word: &str, place: &str) -> Parsed<Span> {
        self.take_word(word).ok_or(()).or_else(|()| self.expected(&format!("`{word}` {place}")))
    }

    /// Takes a name that is no keyword.
    pub(super) fn name(&mut self, of_what: &str) -> Parsed<Name> {
        if self.token.kind != Kind::Word {
            return self.expected(&format!("the name of {of_what}"));
        }
        let text = self.text();
        if refuse::is_keyword(text) {
            return self.expected(&format!("the name of {of_what} (`{text}` is a keyword)"));
        }
        let span = self.bump().span;
        if text.len() > limits::NAME_BYTES {
            let message = format!("a name of more than {} letters", limits::NAME_BYTES);
            return self.error(Diagnostic::new("N006", message).at(span, "too long"));
        }
        Ok(Name { text: text.into(), span })
    }

    /// Notes that something else was expected here.
    pub(super) fn expected<T>(&mut self, what: &str) -> Parsed<T> {
        let found = match self.token.kind {
            Kind::End => "the end of the file".to_owned(),
            _ => format!("`{}`", shorten(self.text())),
        };
        let diagnostic = Diagnostic::new("N003", format!("expected {what}, found {found}"));
        self.error(diagnostic.at(self.token.span, format!("expected {what}")))
    }

    /// Notes that a construct is outside the subset.
    pub(super) fn refuse<T>(&mut self, span: Span, construct: &str, instead: &str) -> Parsed<T> {
        let message = format!("{construct} outside the structural subset");
        self.error(Diagnostic::new("N004", message).at(span, "not understood here").help(instead))
    }

    pub(super) fn error<T>(&mut self, diagnostic: Diagnostic) -> Parsed<T> {
        self.lexer.errors.push(diagnostic);
        Err(Noted)
    }

    /// How many errors have been noted so far.
    pub(super) fn errors(&self) -> usize {
        self.lexer.errors.count
    }

    /// Goes past the next `;`, or to a word that opens or closes something, to go on after an error.
    pub(super) fn recover(&mut self) {
        while !self.at_end() && !self.at_boundary() {
            if self.bump().kind == Kind::Symbol(";") {
                return;
            }
        }
    }

    pub(super) fn at_boundary(&self) -> bool {
        self.token.kind == Kind::Word
            && matches!(self.text(), "module" | "endmodule" | "end" | "generate" | "endgenerate")
    }

    fn file(&mut self) -> Vec<Module> {
        let mut modules = Vec::new();
        let mut attributes = Vec::new();
        while !self.at_end() && !self.lexer.errors.is_full() {
            match self.token.kind {
                Kind::Directive => self.directive(),
                Kind::Symbol("(*") => {
                    attributes.extend(self.attributes().unwrap_or_default());
                }
                _ if self.at_word("module") => modules.extend(self.module(std::mem::take(&mut attributes))),
                _ => self.stray(),
            }
        }
        modules
    }

    /// Something between modules that is no module: noted once, up to the next one.
    fn stray(&mut self) {
        let span = self.token.span;
        match refuse::at_top(self.text()) {
            Some((construct, instead)) => {
                let _ = self.refuse::<()>(span, construct, instead);
            }
            None => {
                let _ = self.expected::<()>("`module`");
            }
        }
        while !self.at_end() && !self.at_word("module") && self.token.kind != Kind::Directive {
            self.bump();
        }
    }

    /// A compiler directive, wherever it stands.
    pub(super) fn directive(&mut self) {
        let span = self.token.span;
        match self.text() {
            "`timescale" => {
                self.lexer.skip_line();
                self.bump();
            }
            "`default_nettype" => {
                self.bump();
                if self.take_word("none").or_else(|| self.take_word("wire")).is_none() {
                    let _ = self.expected::<()>("`none` or `wire` after `default_nettype`");
                }
            }
            other => {
                let construct = format!("the directive `{}` is", shorten(other.trim_start_matches('`')));
                self.lexer.skip_line();
                self.bump();
                let instead = refuse::instead_of_directive(other);
                let _ = self.refuse::<()>(span, &construct, instead);
            }
        }
    }
}

/// The start of a text, to be shown in a message.
pub(super) fn shorten(text: &str) -> String {
    let mut short: String = text.chars().take(40).collect();
    if short.len() < text.len() {
        short.push_str("...");
    }
    short
}
