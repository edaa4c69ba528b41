//! Diagnostics: what is wrong, where, what was expected, how to mend it.

use std::fmt;
use std::ops::Range;
use std::sync::Arc;

use codespan_reporting::diagnostic::{Diagnostic as Shown, Label as ShownLabel};
use codespan_reporting::files::SimpleFiles;
use codespan_reporting::term;

crate::define_id!(
    /// A text that diagnostics point into.
    SourceId
);

/// A range of bytes of one source text.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub struct Span {
    /// Which text.
    pub source: SourceId,
    /// First byte.
    pub start: u32,
    /// One past the last byte.
    pub end: u32,
}

impl Span {
    /// The span from the start of `self` to the end of `other`, which must be of the same text.
    #[must_use]
    pub fn to(self, other: Span) -> Span {
        Span { end: other.end.max(self.end), ..self }
    }

    fn range(self) -> Range<usize> {
        self.start as usize..self.end as usize
    }
}

/// One error. Codes never change their meaning (`docs/diagnostics.md` lists them); the first letter tells the room
/// (`N` netlist, `S` scenario, `W` waveform, `C` command line, `X` export, `E` engine, `H` host, `P` picture, `A`
/// accuracy, `D` drawing, `F` plot file).
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Diagnostic {
    /// For example `N007`.
    pub code: &'static str,
    /// What is wrong, in one line.
    pub message: String,
    /// Places, the first one being the main one.
    pub labels: Vec<(Span, String)>,
    /// What was expected and how to mend it, a line each.
    pub help: Vec<String>,
}

impl Diagnostic {
    /// An error without a place.
    #[must_use]
    pub fn new(code: &'static str, message: impl Into<String>) -> Self {
        Self { code, message: message.into(), labels: Vec::new(), help: Vec::new() }
    }

    /// Adds a place with a word about it; the first one added is the main one.
    #[must_use]
    pub fn at(mut self, span: Span, text: impl Into<String>) -> Self {
        self.labels.push((span, text.into()));
        self
    }

    /// Adds a line of help.
    #[must_use]
    pub fn help(mut self, text: impl Into<String>) -> Self {
        self.help.push(text.into());
        self
    }

    /// Adds "did you mean" when one of `names` is near `wrong`.
    #[must_use]
    pub fn nearest<'a>(self, wrong: &str, names: impl IntoIterator<Item = &'a str>) -> Self {
        match nearest(wrong, names) {
            Some(name) => self.help(format!("did you mean `{name}`?")),
            None => self,
        }
    }
}

/// Names of more bytes are no slip of the pen, and comparing two takes time as the product of their lengths.
const LONGEST_NAME: usize = 200;

/// The name most like `wrong`, when one is near enough to be a slip; none for a name of more than 200 bytes. A name
/// typed without its folder or scope is compared with names without theirs.
pub fn nearest<'a>(wrong: &str, names: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let sane = |name: &str| name.len() <= LONGEST_NAME;
    let names = names.into_iter().filter(|name| sane(wrong) && sane(name));
    let last = |name: &'a str| {
        let name = if wrong.contains('/') { name } else { name.rsplit('/').next().unwrap_or(name) };
        if wrong.contains('.') { name } else { name.rsplit('.').next().unwrap_or(name) }
    };
    let scored = names.map(|name| {
        let whole = strsim::jaro_winkler(wrong, name);
        let part = strsim::jaro_winkler(wrong, last(name));
        // A part of a name is short, so that it is like much else.
        let score = if part > 0.85 { whole.max(part) } else { whole };
        (score, whole, name)
    });
    scored
        .filter(|(score, ..)| *score > 0.75)
        .max_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)).then_with(|| b.2.cmp(a.2)))
        .map(|(.., name)| name)
}

/// Bytes of a line beyond which a message does not show it.
const LONG_LINE: usize = 1000;

/// The texts that spans point into.
#[derive(Clone, Debug, Default)]
pub struct Sources {
    texts: Vec<(String, Arc<str>)>,
}

impl Sources {
    /// Adds a text under the name that messages show, usually its path.
    pub fn add(&mut self, name: impl Into<String>, text: impl Into<Arc<str>>) -> SourceId {
        self.texts.push((name.into(), text.into()));
        SourceId::new(self.texts.len() - 1)
    }

    /// A text and its name.
    #[must_use]
    pub fn get(&self, id: SourceId) -> (&str, &Arc<str>) {
        let (name, text) = &self.texts[id.index()];
        (name, text)
    }

    /// All texts with their names, in the order they were added.
    pub fn iter(&self) -> impl Iterator<Item = (&str, &Arc<str>)> {
        self.texts.iter().map(|(name, text)| (name.as_str(), text))
    }

    /// Whether the lines of a span are too long to be shown.
    fn is_unwieldy(&self, span: Span) -> bool {
        let text = self.get(span.source).1.as_bytes();
        let range = span.range();
        let (before, after) = (&text[..range.start.min(text.len())], &text[range.end.min(text.len())..]);
        let is_long = |length: Option<usize>, rest: usize| length.unwrap_or(rest) > LONG_LINE;
        range.len() > LONG_LINE
            || is_long(before.iter().rev().take(LONG_LINE + 1).position(|&b| b == b'\n'), before.len())
            || is_long(after.iter().take(LONG_LINE + 1).position(|&b| b == b'\n'), after.len())
    }

    /// `file:line:column` of the start of a span, counted from 1.
    #[must_use]
    pub fn place(&self, span: Span) -> String {
        let (name, text) = self.get(span.source);
        let before = &text.as_bytes()[..(span.start as usize).min(text.len())];
        let line = before.iter().filter(|&&b| b == b'\n').count() + 1;
        let column = before.iter().rev().take_while(|&&b| b != b'\n').count() + 1;
        format!("{name}:{line}:{column}")
    }
}

/// All that is wrong with an input: one or more diagnostics and the texts they point into.
#[derive(Clone, Debug)]
pub struct Report {
    /// The texts.
    pub sources: Arc<Sources>,
    /// The errors in order of place.
    pub diagnostics: Vec<Diagnostic>,
}

impl Report {
    /// A report of `diagnostics`, sorted by place.
    #[must_use]
    pub fn new(sources: Sources, mut diagnostics: Vec<Diagnostic>) -> Self {
        diagnostics.sort_by_key(|d| d.labels.first().map(|(span, _)| *span));
        diagnostics.dedup();
        Self { sources: Arc::new(sources), diagnostics }
    }

    /// The text a person reads; with ANSI colours when `color`.
    #[must_use]
    pub fn render(&self, color: bool) -> String {
        let mut files = SimpleFiles::new();
        for (name, text) in &self.sources.texts {
            files.add(name.as_str(), text.as_ref());
        }
        let config = term::Config::default();
        let mut text = String::new();
        for diagnostic in &self.diagnostics {
            if diagnostic.labels.iter().any(|(span, _)| self.sources.is_unwieldy(*span)) {
                text.push_str(&self.plain(diagnostic));
                continue;
            }
            let shown = shown(diagnostic);
            let written = if color {
                let mut buffer = term::termcolor::Ansi::new(Vec::new());
                let result = term::emit_to_write_style(&mut buffer, &config, &files, &shown);
                text.push_str(&String::from_utf8_lossy(buffer.get_ref()));
                result
            } else {
                term::emit_to_string(&mut text, &config, &files, &shown)
            };
            // A span outside its text would be our own mistake; the message is still worth showing.
            if written.is_err() {
                text.push_str(&self.plain(diagnostic));
            }
        }
        text
    }

    /// A diagnostic without the lines of its texts.
    fn plain(&self, diagnostic: &Diagnostic) -> String {
        let mut text = format!("error[{}]: {}\n", diagnostic.code, diagnostic.message);
        for (span, label) in &diagnostic.labels {
            text.push_str(&format!("  --> {}: {label}\n", self.sources.place(*span)));
        }
        for line in &diagnostic.help {
            text.push_str(&format!("  = help: {line}\n"));
        }
        text + "\n"
    }
}

fn shown(diagnostic: &Diagnostic) -> Shown<usize> {
    let labels = diagnostic.labels.iter().enumerate().map(|(i, (span, text))| {
        let make = if i == 0 { ShownLabel::primary } else { ShownLabel::secondary };
        make(span.source.index(), span.range()).with_message(text)
    });
    Shown::error()
        .with_code(diagnostic.code)
        .with_message(&diagnostic.message)
        .with_labels(labels.collect())
        .with_notes(diagnostic.help.iter().map(|line| format!("help: {line}")).collect())
}

impl From<Diagnostic> for Report {
    fn from(diagnostic: Diagnostic) -> Self {
        Self::new(Sources::default(), vec![diagnostic])
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.render(false))
    }
}

impl std::error::Error for Report {}

#[cfg(test)]
mod tests {
    use super::nearest;

    #[test]
    fn a_name_without_its_folder_is_compared_without_folders() {
        let names = ["integrator", "su1522157/interpolator", "bench/self_feeding_interpolator"];
        assert_eq!(nearest("interpolator", names), Some("su1522157/interpolator"));
        assert_eq!(nearest("interpolatr", names), Some("su1522157/interpolator"));
        assert_eq!(nearest("integratr", names), Some("integrator"));
        assert_eq!(nearest("busi", ["a.busy", "busy"]), Some("busy"), "the name itself before its namesake");
        assert_eq!(nearest("zork", ["multiplexer_21.z"]), None, "one letter is no likeness");
    }
}
