//! A waveform looked at just before each edge of one of its nets.

use std::ops::Range;

use super::declared::{Declared, SignalId};
use super::how::Edge;
use super::source::Source;
use super::state::State;
use crate::base::{Diagnostic, Report};

/// The samples of another source; the first is time 0, and the unit is the tick.
pub(super) struct Sampled {
    source: Box<dyn Source>,
    declared: Declared,
    net: SignalId,
    is_rising: bool,
    /// What the source has told so far; its touched signals are those that changed since the last sample.
    before: State,
    /// What it tells next, which holds after the edge.
    after: State,
    time: Option<u64>,
    last: u64,
}

impl Sampled {
    /// # Errors
    /// `W021` the net is not there or has more than one bit; those of the source.
    pub fn new(name: &str, source: Box<dyn Source>, edge: &Edge) -> Result<Self, Report> {
        let mut declared = source.declared().clone();
        declared.unit = 1_000_000;
        let found = declared.names.iter().find(|known| known.path == edge.net);
        let Some(net) = found.map(|name| name.signal).filter(|id| declared.signals[id.index()].width == 1) else {
            let message = format!("{name}: it has no net `{}` of one bit to be looked at by", edge.net);
            let known = declared.names.iter().map(|name| name.path.as_str());
            return Err(Diagnostic::new("W021", message).nearest(&edge.net, known).into());
        };
        let state = State::new(&declared);
        let (before, after) = (state.clone(), state);
        let mut sampled =
            Self { source, declared, net, is_rising: edge.is_rising, before, after, time: Some(0), last: 0 };
        sampled.time = sampled.next_edge()?.then_some(0);
        Ok(sampled)
    }

    fn level(&self, state: &State) -> Option<bool> {
        let (bits, unknown) = state.planes(self.net)?;
        (unknown[0] == 0).then(|| bits[0] == 1)
    }

    /// Reads up to the next edge; whether there is one.
    fn next_edge(&mut self) -> Result<bool, Report> {
        loop {
            // What was after the last step is before the next one.
            let Self { before, after, .. } = self;
            for id in after.touched() {
                copy(after, before, id);
            }
            after.settle();
            if self.source.time().is_none() {
                return Ok(false);
            }
            self.source.advance(&mut self.after)?;
            let levels = [self.level(&self.before), self.level(&self.after)];
            if levels == [Some(!self.is_rising), Some(self.is_rising)] {
                return Ok(true);
            }
        }
    }
}

fn copy(from: &State, to: &mut State, id: SignalId) {
    if let Some((bits, unknown)) = from.planes(id) {
        let planes = to.touch(id);
        planes.0.copy_from_slice(bits);
        planes.1.copy_from_slice(unknown);
    }
}

impl Source for Sampled {
    fn declared(&self) -> &Declared {
        &self.declared
    }

    fn time(&self) -> Option<u64> {
        self.time
    }

    fn advance(&mut self, state: &mut State) -> Result<(), Report> {
        let Some(now) = self.time else { return Ok(()) };
        for id in self.before.touched() {
            copy(&self.before, state, id);
        }
        self.before.settle();
        self.last = now + 1;
        self.time = self.next_edge()?.then_some(now + 1);
        Ok(())
    }

    fn span(&self) -> Range<u64> {
        0..self.last
    }

    fn is_closed(&self) -> bool {
        self.source.is_closed()
    }
}
