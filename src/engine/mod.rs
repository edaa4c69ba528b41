//! Engines: they run a program tick by tick, and know nothing of traces.

mod auto;
pub mod batch;
mod choose;
mod format;
mod interpreter;
#[cfg(feature = "lanes")]
mod lanes;
mod lockstep;
#[cfg(feature = "native")]
mod native;
mod pulses;
mod stats;

pub use choose::{EngineKind, all, not_built_in};
pub use format::{Build, EngineFormat};
pub use interpreter::Interpreter;
#[cfg(feature = "lanes")]
pub use lanes::{LanesEngine, Path as LanesPath};
pub use lockstep::{Difference, Lockstep};
#[cfg(feature = "native")]
pub use native::Native;
pub use pulses::Pulses;
pub use stats::{Stats, Work};

use crate::base::ValueId;

/// Runs one stimulus of one program.
///
/// An engine always stands *at* a tick, with every value settled and no state committed: that is the sample point.
/// A new engine stands at tick 0 with all inputs 0.
pub trait Engine {
    /// Its name on the command line.
    fn name(&self) -> &'static str;

    /// Sets input `Op::Input(input)` from the present tick on; takes effect with the next [`Engine::settle`]
    /// or [`Engine::advance`]. `word` must fit the input's width.
    fn set_input(&mut self, input: usize, word: u64);

    /// Settles the present tick again after its inputs have changed.
    fn settle(&mut self);

    /// Up to `ticks` times: commits state and settles the next tick. Stops early after a tick in which the
    /// program's `stop` is 1, if `until_stop`. Returns how many ticks it advanced.
    ///
    /// The present tick is settled first if an input has changed since.
    fn advance(&mut self, ticks: u64, until_stop: bool) -> u64;

    /// An observed value ([`crate::compile::Program::observed`]) as last settled.
    fn value(&self, id: ValueId) -> u64;

    /// The pulses of the outputs that the program counts, in their order, from tick 0 to the present one.
    fn pulses(&self) -> Vec<Pulses>;

    /// Chooses the observed values that [`Engine::read`] reads from now on.
    fn watch(&mut self, ids: &[ValueId]);

    /// Reads the watched values in their order. One call for all that a trace wants of a tick, because a call for each
    /// would cost more than the tick.
    fn read(&self, words: &mut [u64]);

    /// What specialised code runs, where there is any.
    fn stats(&self) -> Option<&Stats> {
        None
    }
}
