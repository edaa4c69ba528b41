//! The rising edges of some lines, one by one.

use super::{Frame, Observer};
use crate::base::{Diagnostic, Edge, Report, Signal, ValueId};

/// Keeps every rising edge of some lines of one bit; a line that is high when it is first seen has one there.
#[derive(Clone, Debug, Default)]
pub struct Edges {
    lines: Vec<String>,
    edges: Vec<Edge>,
}

impl Edges {
    /// Of the lines of these dotted names below the top module.
    #[must_use]
    pub fn of<S: Into<String>>(lines: impl IntoIterator<Item = S>) -> Self {
        Self { lines: lines.into_iter().map(Into::into).collect(), edges: Vec::new() }
    }

    /// The edges, tick by tick; each line is known by its place among the names.
    #[must_use]
    pub fn edges(&self) -> &[Edge] {
        &self.edges
    }
}

impl Observer for Edges {
    fn wants(&self, name: &str) -> bool {
        self.lines.iter().any(|line| line == name)
    }

    /// # Errors
    /// `S012` for a name that is no signal of the circuit.
    fn begin(&mut self, signals: &[Signal]) -> Result<Vec<ValueId>, Report> {
        let find = |name: &String| {
            let found = signals.iter().find(|signal| signal.name() == *name).map(|signal| signal.value);
            found.ok_or_else(|| Report::from(Diagnostic::new("S012", format!("there is no net `{name}`"))))
        };
        self.lines.iter().map(find).collect()
    }

    fn tick(&mut self, frame: Frame<'_>) -> Result<(), Report> {
        for (pulse, &word) in frame.words.iter().enumerate() {
            if word != 0 && frame.before.is_none_or(|before| before[pulse] == 0) {
                // A run of 2^32 ticks has no room for its edges anyway.
                let tick = u32::try_from(frame.tick).unwrap_or(u32::MAX);
                self.edges.push(Edge { tick, pulse: pulse as u32 });
            }
        }
        Ok(())
    }

    fn end(&mut self) -> Result<(), Report> {
        Ok(())
    }
}
