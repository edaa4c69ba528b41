//! A chain of one-bit registers that a pulse walks through, one register a tick.

use crate::base::ValueId;
use crate::base::word::MAX_WIDTH;
use crate::blocks::Builder;

/// A chain, held in as few words as can be.
pub(super) struct Chain(Vec<ValueId>);

impl Chain {
    /// A chain of `length` registers behind `input`.
    pub(super) fn build(b: &mut Builder, mut input: ValueId, length: u32) -> Self {
        let mut words = Vec::new();
        let mut rest = length;
        while rest > 0 {
            let width = rest.min(MAX_WIDTH);
            let word = b.hold(width, 0);
            let next = if width == 1 {
                input
            } else {
                let moving = b.slice(word.q, 0, width - 1);
                b.concat(moving, input)
            };
            let word = b.load(word, next, None, None);
            input = b.sign(word);
            words.push(word);
            rest -= width;
        }
        Self(words)
    }

    /// The input `ticks` ticks ago; at least 1 and at most the chain's length.
    pub(super) fn after(&self, b: &mut Builder, ticks: u32) -> ValueId {
        b.pick(self.0[(ticks - 1) as usize / MAX_WIDTH as usize], (ticks - 1) % MAX_WIDTH)
    }

    /// Whether a pulse is anywhere in the chain.
    pub(super) fn holds_a_pulse(&self, b: &mut Builder) -> ValueId {
        let words: Vec<_> = self.0.iter().map(|&word| b.reduce_or(word)).collect();
        b.any(&words)
    }
}
