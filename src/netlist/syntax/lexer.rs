//! The lexer: from characters to tokens, one at a time, so that a huge text costs no memory.

use super::number::{self, Literal, Refused};
use crate::base::{Diagnostic, SourceId, Span};
use crate::netlist::errors::Errors;

/// What a token is. Its text is that of its span.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Kind {
    /// A name or a keyword.
    Word,
    /// `$name`
    System,
    Number(Literal),
    String,
    /// `` `name ``
    Directive,
    Symbol(&'static str),
    /// The end of the text.
    End,
}

/// A token and where it stands.
#[derive(Clone, Copy, Debug)]
pub(super) struct Token {
    pub(super) kind: Kind,
    pub(super) span: Span,
}

/// The symbols that begin with a byte, longest first. `@`, `#` and the bare quote stand in constructs outside the
/// subset only, so that these can be named and skipped.
fn symbols(first: u8) -> &'static [&'static str] {
    match first {
        b'<' => &["<<<", "<<", "<=", "<"],
        b'>' => &[">>>", ">>", ">=", ">"],
        b'=' => &["===", "==", "="],
        b'!' => &["!==", "!=", "!"],
        b'*' => &["**", "*)", "*"],
        b'&' => &["&&", "&"],
        b'|' => &["||", "|"],
        b'~' => &["~&", "~|", "~^", "~"],
        b'^' => &["^~", "^"],
        b'(' => &["(*", "("],
        b'+' => &["+:", "+"],
        b'-' => &["-:", "->", "-"],
        b')' => &[")"],
        b'[' => &["["],
        b']' => &["]"],
        b'{' => &["{"],
        b'}' => &["}"],
        b';' => &[";"],
        b',' => &[","],
        b'.' => &["."],
        b':' => &[":"],
        b'?' => &["?"],
        b'/' => &["/"],
        b'%' => &["%"],
        b'#' => &["#"],
        b'@' => &["@"],
        b'\'' => &["'"],
        _ => &[],
    }
}

/// Reads tokens of one text.
pub(super) struct Lexer<'t> {
    text: &'t str,
    source: SourceId,
    at: usize,
    pub(super) errors: Errors,
}

impl<'t> Lexer<'t> {
    pub(super) fn new(source: SourceId, text: &'t str) -> Self {
        let at = if text.starts_with('\u{feff}') { '\u{feff}'.len_utf8() } else { 0 };
        Self { text, source, at, errors: Errors::default() }
    }

    /// The text of a span.
    pub(super) fn text(&self, span: Span) -> &'t str {
        &self.text[span.start as usize..span.end as usize]
    }

    /// The next token.
    pub(super) fn next(&mut self) -> Token {
        loop {
            self.skip_blank();
            let start = self.at;
            let Some(first) = self.rest().chars().next() else {
                return self.token(Kind::End, start);
            };
            let kind = match first {
                'a'..='z' | 'A'..='Z' | '_' => self.word(),
                '0'..='9' => self.number(),
                '\'' if self.base_follows() => self.number(),
                '$' => self.prefixed(Kind::System),
                '`' => self.prefixed(Kind::Directive),
                '"' => self.string(),
                '\\' => self.escaped(),
                _ => match self.symbol() {
                    Some(kind) => kind,
                    None => {
                        self.strange(first);
                        continue;
                    }
                },
            };
            return self.token(kind, start);
        }
    }

    /// Skips to the end of the line, for directives that own it.
    pub(super) fn skip_line(&mut self) {
        self.at += self.rest().find('\n').unwrap_or(self.rest().len());
    }

    fn rest(&self) -> &'t str {
        &self.text[self.at..]
    }

    fn span(&self, start: usize) -> Span {
        Span { source: self.source, start: start as u32, end: self.at as u32 }
    }

    fn token(&self, kind: Kind, start: usize) -> Token {
        Token { kind, span: self.span(start) }
    }

    fn error(&mut self, code: &'static str, start: usize, message: impl Into<String>, help: impl Into<String>) {
        let span = self.span(start);
        self.errors.push(Diagnostic::new(code, message).at(span, "here").help(help));
    }

    fn skip_while(&mut self, wanted: impl Fn(u8) -> bool) {
        let rest = self.rest().as_bytes();
        self.at += rest.iter().position(|&byte| !wanted(byte)).unwrap_or(rest.len());
    }

    fn skip_blank(&mut self) {
        loop {
            self.skip_while(|byte| byte.is_ascii_whitespace());
            if self.rest().starts_with("//") {
                self.skip_line();
            } else if self.rest().starts_with("/*") {
                self.block_comment();
            } else {
                return;
            }
        }
    }

    fn block_comment(&mut self) {
        let start = self.at;
        match self.rest()[2..].find("*/") {
            Some(length) => self.at += length + 4,
            None => {
                self.at += 2;
                self.error("N002", start, "this comment has no end", "close it with `*/`");
                self.at = self.text.len();
            }
        }
    }

    fn word(&mut self) -> Kind {
        self.skip_while(is_word);
        Kind::Word
    }

    fn prefixed(&mut self, kind: Kind) -> Kind {
        self.at += 1;
        self.skip_while(is_word);
        kind
    }

    /// A string; only attributes may hold one.
    fn string(&mut self) -> Kind {
        let start = self.at;
        let mut escaped = false;
        let end = self.rest()[1..].bytes().position(|byte| {
            let stop = byte == b'\n' || (byte == b'"' && !escaped);
            escaped = byte == b'\\' && !escaped;
            stop
        });
        let end = end.map_or(self.text.len(), |end| self.at + 1 + end);
        self.at = end;
        if self.rest().starts_with('"') {
            self.at += 1;
        } else {
            self.error("N002", start, "this string has no end on its line", "close it with `\"`");
        }
        Kind::String
    }

    fn escaped(&mut self) -> Kind {
        let start = self.at;
        self.skip_while(|byte| !byte.is_ascii_whitespace());
        self.error(
            "N004",
            start,
            "an escaped name is outside the structural subset",
            "name it with letters, digits and `_` only, so that every waveform viewer shows it",
        );
        Kind::Word
    }

    fn symbol(&mut self) -> Option<Kind> {
        let rest = self.rest();
        let symbol = symbols(*rest.as_bytes().first()?).iter().find(|symbol| rest.starts_with(**symbol))?;
        self.at += symbol.len();
        Some(Kind::Symbol(symbol))
    }

    /// Reports a run of characters that start no token, once.
    fn strange(&mut self, first: char) {
        let start = self.at;
        self.at += first.len_utf8();
        let message = format!("the character `{}` starts nothing in Verilog", first.escape_default());
        self.error("N002", start, message, "letters of other scripts may stand in comments only");
        let more = self.rest().find(|c: char| c.is_ascii()).unwrap_or(self.rest().len());
        self.at += more;
    }

    /// Whether a base follows at the present place: `'`, perhaps `s`, then `b`, `o`, `d` or `h`.
    fn base_follows(&self) -> bool {
        let mut rest = self.rest().bytes();
        if rest.next() != Some(b'\'') {
            return false;
        }
        let mut next = rest.next().unwrap_or(0).to_ascii_lowercase();
        if next == b's' {
            next = rest.next().unwrap_or(0).to_ascii_lowercase();
        }
        matches!(next, b'b' | b'o' | b'd' | b'h')
    }

    fn number(&mut self) -> Kind {
        let start = self.at;
        self.skip_while(is_digit);
        let size_end = self.at;
        self.skip_while(|byte| byte.is_ascii_whitespace());
        let literal = if self.base_follows() {
            self.based(start, size_end)
        } else {
            self.at = size_end;
            if self.real_follows() {
                self.skip_while(|byte| is_word(byte) || byte == b'.');
                self.error("N004", start, "a real number is outside the structural subset", "write a whole number");
                return Kind::Number(Literal { value: 0, width: None, signed: true });
            }
            number::plain(&self.text[start..size_end])
        };
        Kind::Number(literal.unwrap_or_else(|Refused { message, help }| {
            self.error("N005", start, message, help);
            Literal { value: 0, width: None, signed: true }
        }))
    }

    fn based(&mut self, start: usize, size_end: usize) -> Result<Literal, Refused> {
        let size = Some(&self.text[start..size_end]).filter(|size| !size.is_empty());
        self.at += 1;
        let signed = self.rest().starts_with(['s', 'S']);
        self.at += usize::from(signed);
        let base = self.rest().chars().next().unwrap_or('d');
        self.at += 1;
        self.skip_while(|byte| byte.is_ascii_whitespace());
        let digits = self.at;
        self.skip_while(|byte| byte.is_ascii_alphanumeric() || byte == b'_' || byte == b'?');
        let digits = &self.text[digits..self.at];
        if digits.trim_matches('_').is_empty() {
            let message = format!("no digits after `'{base}`");
            return Err(Refused { message, help: "for example `4'd9` or `8'hFF`".into() });
        }
        number::based(size, signed, base, digits)
    }

    fn real_follows(&self) -> bool {
        let mut rest = self.rest().bytes();
        match rest.next() {
            Some(b'.') => rest.next().is_some_and(|byte| byte.is_ascii_digit()),
            Some(b'e' | b'E') => rest.next().is_some_and(|byte| byte.is_ascii_digit() || byte == b'-'),
            _ => false,
        }
    }
}

fn is_word(byte: u8) -> bool {
    byte.is_ascii_alphanumeric() || byte == b'_' || byte == b'$'
}

fn is_digit(byte: u8) -> bool {
    byte.is_ascii_digit() || byte == b'_'
}
