//! Random stimuli: what to do to an engine, one thing after another.

use proptest::prelude::*;
use stepwright::base::word::mask;
use stepwright::compile::Program;
use stepwright::engine::Engine;

/// One thing to do.
#[derive(Clone, Debug)]
pub enum Action {
    /// Set an input (taken modulo their number) to a word (cut to its width).
    Set(usize, u64),
    /// Settle the present tick.
    Settle,
    /// Advance so many ticks, with or without regard to the stop condition.
    Advance(u64, bool),
}

/// Stimuli of up to so many actions.
pub fn stimuli(actions: usize) -> impl Strategy<Value = Vec<Action>> {
    let action = prop_oneof![
        2 => (any::<usize>(), any::<u64>()).prop_map(|(input, word)| Action::Set(input, word)),
        1 => Just(Action::Settle),
        3 => (0..9_u64, any::<bool>()).prop_map(|(ticks, until)| Action::Advance(ticks, until)),
    ];
    prop::collection::vec(action, 1..actions)
}

/// The input and the word that a `Set` means for a program, if it has inputs.
pub fn setting(program: &Program, input: usize, word: u64) -> Option<(usize, u64)> {
    let input = input.checked_rem(program.inputs.len())?;
    Some((input, word & mask(program.inputs[input].width)))
}

/// Does all to an engine, with every change of an input settled before it is looked at.
pub fn drive(program: &Program, engine: &mut dyn Engine, stimulus: &[Action]) {
    for action in stimulus {
        match *action {
            Action::Set(input, word) => {
                if let Some((input, word)) = setting(program, input, word) {
                    engine.set_input(input, word);
                }
            }
            Action::Settle => engine.settle(),
            Action::Advance(ticks, until) => {
                engine.advance(ticks, until);
            }
        }
    }
}
