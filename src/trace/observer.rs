//! Observers: what looks at a run tick by tick.

use crate::base::{Report, Signal, ValueId};

/// Looks at a run at the sample point of every tick, from the tick in which it was put to it.
///
/// What is observable is decided before a circuit is compiled; so an observer first tells by name what it
/// [wants](Observer::wants), then finds it among the signals, and is shown their words at every tick.
pub trait Observer {
    /// Whether it looks at the signal of this dotted name below the top module.
    fn wants(&self, name: &str) -> bool;

    /// Finds what it looks at among all signals of the run that can be seen. Returns the values whose words it is to be
    /// shown, in its own order.
    ///
    /// # Errors
    /// When a signal that it needs is not among them, or it cannot begin.
    fn begin(&mut self, signals: &[Signal]) -> Result<Vec<ValueId>, Report>;

    /// Looks at a tick.
    ///
    /// # Errors
    /// When what it makes cannot be written. The run ends then.
    fn tick(&mut self, frame: Frame<'_>) -> Result<(), Report>;

    /// Finishes what it makes: the run is over.
    ///
    /// # Errors
    /// When that cannot be written.
    fn end(&mut self) -> Result<(), Report>;
}

/// The words that an observer looks at, in one tick.
#[derive(Clone, Copy, Debug)]
pub struct Frame<'a> {
    /// The tick.
    pub tick: u64,
    /// The words, in the order of the values from [`Observer::begin`].
    pub words: &'a [u64],
    /// Those of the tick before, unless this is the first one it sees.
    pub before: Option<&'a [u64]>,
}

impl<T: Observer + ?Sized> Observer for &mut T {
    fn wants(&self, name: &str) -> bool {
        (**self).wants(name)
    }

    fn begin(&mut self, signals: &[Signal]) -> Result<Vec<ValueId>, Report> {
        (**self).begin(signals)
    }

    fn tick(&mut self, frame: Frame<'_>) -> Result<(), Report> {
        (**self).tick(frame)
    }

    fn end(&mut self) -> Result<(), Report> {
        (**self).end()
    }
}
