//! A line of a glyph file: its words with their places.

use crate::base::{Diagnostic, SourceId, Span};

/// A word and where it stands.
#[derive(Clone, Copy)]
pub(super) struct Word<'t> {
    pub(super) text: &'t str,
    pub(super) span: Span,
}

/// The words of each line that has some, comments left out.
pub(super) fn lines(source: SourceId, text: &str) -> impl Iterator<Item = Vec<Word<'_>>> {
    let code = |line: &'_ str| line.find("//").unwrap_or(line.len());
    let words = move |line| words(source, text, line);
    text.lines().map(move |line| &line[..code(line)]).map(words).filter(|words| !words.is_empty())
}

fn words<'t>(source: SourceId, text: &str, line: &'t str) -> Vec<Word<'t>> {
    let word = |part: &'t str| {
        // Both stand in the same text.
        let start = part.as_ptr() as usize - text.as_ptr() as usize;
        Word { text: part, span: Span { source, start: start as u32, end: (start + part.len()) as u32 } }
    };
    line.split_whitespace().map(word).collect()
}

/// The greatest distance of a point from the origin on either axis, so that every coefficient fits 16 bits.
const FARTHEST: i32 = 16_000;

impl Word<'_> {
    pub(super) fn wrong(&self, code: &'static str, message: impl Into<String>, label: &str) -> Diagnostic {
        Diagnostic::new(code, message).at(self.span, label)
    }

    /// A coordinate.
    pub(super) fn number(&self) -> Result<i32, Diagnostic> {
        let number = self.text.parse::<i32>();
        let fits = number.ok().filter(|number| (-FARTHEST..=FARTHEST).contains(number));
        fits.ok_or_else(|| {
            let wrong = self.wrong("G002", format!("`{}` is no coordinate", self.text), "here");
            wrong.help(format!("coordinates are whole numbers from -{FARTHEST} to {FARTHEST}"))
        })
    }

    /// The code of a character.
    pub(super) fn code(&self) -> Result<u8, Diagnostic> {
        let digits = self.text.len() == 2 && self.text.bytes().all(|byte| byte.is_ascii_hexdigit());
        let code = u8::from_str_radix(self.text, 16).ok().filter(|_| digits);
        code.ok_or_else(|| {
            let wrong = self.wrong("G003", format!("`{}` is no code of a character", self.text), "here");
            wrong.help("a code is two hexadecimal digits, and its character follows: `glyph 41 A`")
        })
    }
}
