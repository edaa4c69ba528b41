//! One stimulus on any engine: what a batch means, in the plainest words.

use super::{End, Plan, StoppedBy};
use crate::compile::Program;
use crate::engine::Engine;

/// Runs one stimulus on a new engine, calls `at_tick` at every tick from 0 to the last one, and leaves the engine at the
/// tick where the run stopped. Returns that tick and what stopped it.
pub fn run_one(
    engine: &mut dyn Engine,
    program: &Program,
    plan: &Plan,
    inputs: &[u64],
    mut at_tick: impl FnMut(u64, &dyn Engine),
) -> (u64, StoppedBy) {
    inputs.iter().enumerate().for_each(|(input, &word)| engine.set_input(input, word));
    let first_judged = plan.first_judged_tick();
    let (last, stopped_there) = plan.last_tick();
    let mut changes = plan.changes.iter().peekable();
    for tick in 0.. {
        if tick > 0 {
            engine.advance(1, false);
        }
        while let Some(change) = changes.next_if(|change| change.tick <= tick) {
            engine.set_input(change.input, change.word);
        }
        engine.settle();
        at_tick(tick, engine);
        let is_judged = matches!(plan.end, End::Until { .. }) && tick >= first_judged;
        if is_judged && program.stop.is_some_and(|stop| engine.value(stop) != 0) {
            return (tick, StoppedBy::Until);
        }
        if tick == last {
            break;
        }
    }
    (last, stopped_there)
}
