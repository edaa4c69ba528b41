//! Files that plotters and drawing programs exchange, read: curves out.
//!
//! A reader finds every mistake of a file before it gives up, each with its line and column. What a file has beyond
//! curves, such as pictures made of pixels, is left out with a word about it ([`Plot::notes`]).

mod gcode;
mod pen;
mod svg;

use std::sync::Arc;

pub use kurbo;

use crate::base::{Diagnostic, Report, SourceId, Sources, Span};
use kurbo::BezPath;

/// Most pieces of curves that are read; a page of dense text has some ten thousand.
pub const MOST_PIECES: usize = 1 << 21;
/// Coordinates beyond this, in millimetres, are no drawing.
const FARTHEST: f64 = 1e9;
/// How many mistakes of a file are told.
const MOST_ERRORS: usize = 20;

/// What a file draws.
#[derive(Clone, Debug, Default)]
pub struct Plot {
    /// One for each time the pen is put down, in the order of the file; in millimetres, Y upwards.
    pub curves: Vec<BezPath>,
    /// What was left out or changed, a sentence each, with the place where there is one.
    pub notes: Vec<String>,
}

/// A kind of file.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Kind {
    /// Scalable vector graphics.
    Svg,
    /// RS-274, as machine tools read it.
    GCode,
}

impl Kind {
    /// The kind that a file's ending tells.
    #[must_use]
    pub fn of(ending: &str) -> Option<Self> {
        match ending.to_ascii_lowercase().as_str() {
            "svg" => Some(Self::Svg),
            "gcode" | "nc" | "ngc" | "tap" => Some(Self::GCode),
            _ => None,
        }
    }

    /// The kind that a text looks like, for files under a wrong ending.
    fn looks_like(text: &str) -> Option<Self> {
        let head: String = text.trim_start_matches('\u{feff}').trim_start().chars().take(2).collect();
        match head.to_ascii_uppercase().as_bytes() {
            [b'<', ..] => Some(Self::Svg),
            [b'%' | b'(' | b'N' | b'G', ..] => Some(Self::GCode),
            _ => None,
        }
    }

    fn name(self) -> &'static str {
        match self {
            Self::Svg => "SVG",
            Self::GCode => "G-code",
        }
    }
}

/// Reads a text, which messages call `name`.
///
/// # Errors
/// `F001` it is of another kind, `F002` it is not well formed, `F003` it asks for what is not drawn, `F004` a number that
/// is none or too far away, `F005` more pieces than [`MOST_PIECES`], `F006` more mistakes than are listed; all mistakes
/// at once.
pub fn read(kind: Kind, name: &str, text: &Arc<str>) -> Result<Plot, Report> {
    let mut reading = Reading::new(name, text);
    match Kind::looks_like(text) {
        Some(other) if other != kind => {
            let message = format!("this looks like {}, not like {}", other.name(), kind.name());
            reading.wrong("F001", 0..text.len().min(1), message, "give the file the ending of its kind");
        }
        _ => match kind {
            Kind::Svg => svg::read(&mut reading),
            Kind::GCode => gcode::read(&mut reading),
        },
    }
    reading.end()
}

/// A file that is being read: its text, its curves so far, its mistakes so far.
struct Reading {
    sources: Sources,
    source: SourceId,
    text: Arc<str>,
    wrong: Vec<Diagnostic>,
    untold: usize,
    plot: Plot,
    pieces: usize,
}

impl Reading {
    fn new(name: &str, text: &Arc<str>) -> Self {
        let mut sources = Sources::default();
        let source = sources.add(name, Arc::clone(text));
        let text = Arc::clone(text);
        Self { sources, source, text, wrong: Vec::new(), untold: 0, plot: Plot::default(), pieces: 0 }
    }

    fn span(&self, at: std::ops::Range<usize>) -> Span {
        Span { source: self.source, start: at.start as u32, end: at.end as u32 }
    }

    fn wrong(&mut self, code: &'static str, at: std::ops::Range<usize>, message: impl Into<String>, help: &str) {
        if self.wrong.len() == MOST_ERRORS {
            self.untold += 1;
            return;
        }
        let diagnostic = Diagnostic::new(code, message).at(self.span(at), "here");
        self.wrong.push(if help.is_empty() { diagnostic } else { diagnostic.help(help) });
    }

    fn note(&mut self, at: std::ops::Range<usize>, what: &str) {
        if self.plot.notes.len() < MOST_ERRORS {
            let place = self.sources.place(self.span(at));
            self.plot.notes.push(format!("{place}: {what}"));
        }
    }

    /// Counts pieces of curves; whether there may be more.
    fn count(&mut self, pieces: usize, at: std::ops::Range<usize>) -> bool {
        let before = self.pieces;
        self.pieces = self.pieces.saturating_add(pieces);
        if before <= MOST_PIECES && self.pieces > MOST_PIECES {
            let message = format!("more than {MOST_PIECES} pieces of curves");
            self.wrong("F005", at, message, "draw the file in parts");
        }
        self.pieces <= MOST_PIECES
    }

    fn end(mut self) -> Result<Plot, Report> {
        if self.wrong.is_empty() {
            return Ok(self.plot);
        }
        if self.untold > 0 {
            let message = format!("{} more mistakes are not listed", self.untold);
            self.wrong.push(Diagnostic::new("F006", message));
        }
        Err(Report::new(self.sources, self.wrong))
    }
}
