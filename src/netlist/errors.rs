//! The errors found so far: all of an input are collected, each place once, up to a limit.

use std::collections::HashSet;

use super::limits;
use crate::base::{Diagnostic, Span};

/// The code of an error that only follows from one that has been told; it is never shown.
pub(super) const FOLLOWS: &str = "N000";

/// Codes of errors at a place, whatever else is said about that place follows from them.
const OF_PLACES: [&str; 3] = [FOLLOWS, "N002", "N005"];

/// Diagnostics in order of discovery.
#[derive(Default, Debug)]
pub(super) struct Errors {
    list: Vec<Diagnostic>,
    /// What has been told: turns of a loop and instances of a module make the same mistake at the same place.
    told: HashSet<(&'static str, Option<Span>)>,
    /// How many have been found, repetitions included.
    pub(super) count: usize,
}

impl Errors {
    /// Notes one more.
    pub(super) fn push(&mut self, diagnostic: Diagnostic) {
        self.count += 1;
        let place = diagnostic.labels.first().map(|(span, _)| *span);
        let follows = diagnostic.code == FOLLOWS || OF_PLACES.iter().any(|code| self.told.contains(&(code, place)));
        let again = place.is_some() && !self.told.insert((diagnostic.code, place));
        if follows || again || self.list.len() > limits::ERRORS {
            return;
        }
        if self.list.len() == limits::ERRORS {
            let message = format!("more than {} errors; only the first are shown", limits::ERRORS);
            self.list.push(Diagnostic::new("N006", message));
        } else {
            self.list.push(diagnostic);
        }
    }

    /// Whether looking for more is in vain.
    pub(super) fn is_full(&self) -> bool {
        self.list.len() > limits::ERRORS || self.count > 20 * limits::ERRORS
    }

    pub(super) fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    pub(super) fn into_list(self) -> Vec<Diagnostic> {
        self.list
    }
}
