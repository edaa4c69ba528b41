//! A waveform as it is read, time by time: what formats have in common.

use std::ops::Range;

use super::declared::Declared;
use super::state::State;
use crate::base::Report;

/// A waveform that is read once, from its beginning to its end.
pub(super) trait Source {
    /// What the file declares.
    fn declared(&self) -> &Declared;

    /// The time of the values that come next; `None` at the end.
    fn time(&self) -> Option<u64>;

    /// Puts all values of that time into `state`, and finds the next one.
    ///
    /// # Errors
    /// What is wrong with the file, no later than at its end.
    fn advance(&mut self, state: &mut State) -> Result<(), Report>;

    /// The times that have been told about so far.
    fn span(&self) -> Range<u64>;

    /// Whether the last time read was one at which nothing changed.
    fn is_closed(&self) -> bool;
}
