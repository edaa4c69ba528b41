//! What is wrong with a VCD file, by line.

use super::tokens::Broken;
use crate::base::{Diagnostic, Report, Sources};

/// How many errors are told before reading stops.
const MOST_ERRORS: usize = 20;

/// What is wrong with a file, by line.
pub(super) struct Wrong {
    name: String,
    pub all: Vec<Diagnostic>,
}

impl Wrong {
    pub fn new(name: &str) -> Self {
        Self { name: name.to_owned(), all: Vec::new() }
    }

    /// Adds a message with its place.
    pub fn at(&mut self, line: u64, mut diagnostic: Diagnostic) {
        diagnostic.message = format!("{}, line {line}: {}", self.name, diagnostic.message);
        self.all.push(diagnostic);
    }

    /// Adds why there are no more words.
    pub fn broken(&mut self, line: u64, broken: Broken) {
        self.at(
            line,
            match broken {
                Broken::Long => Diagnostic::new("W012", "a word of more than 256 KiB: this is no VCD from here on"),
                Broken::Cut => Diagnostic::new("W011", "the file ends in the middle of a command")
                    .help("it was cut off: write it again, or end its last line"),
                Broken::Unreadable(error) => Diagnostic::new("W017", format!("cannot be read: {error}")),
            },
        );
    }

    pub fn is_too_much(&self) -> bool {
        self.all.len() >= MOST_ERRORS
    }

    /// # Errors
    /// All that is wrong, if anything is.
    pub fn verdict(&mut self) -> Result<(), Report> {
        let all = std::mem::take(&mut self.all);
        if all.is_empty() { Ok(()) } else { Err(Report::new(Sources::default(), all)) }
    }
}

/// The beginning of a word, for a message.
pub(super) fn shown(word: &[u8]) -> String {
    let text: String = String::from_utf8_lossy(&word[..word.len().min(40)]).escape_debug().collect();
    if word.len() > 40 { text + "..." } else { text }
}
