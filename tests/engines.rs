//! All engines agree, on random graphs of ops, with a plain reading of the ops and with each other.

use std::sync::Arc;

use proptest::prelude::*;
use proptest::test_runner::TestCaseError;
use stepwright::compile::{Observe, Program, compile, compile_graph};
use stepwright::engine::{Engine, Interpreter, Lockstep, Native, all};
use stepwright::netlist::load;
use stepwright::simulation::shipped::Shelf;

use crate::generate::circuits::{drafts, write};
use crate::generate::graphs::{grow, recipes};
use crate::generate::listing::listing;
use crate::generate::plain::Plain;
use crate::generate::replicas::{replicas, replicate};
use crate::generate::stimulus::{Action, drive, setting, stimuli};

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn compiled_graphs_mean_what_the_ops_say(recipe in recipes(40), stimulus in stimuli(12)) {
        let grown = grow(&recipe);
        let program = Arc::new(compile_graph(grown.clone()));
        let mut plain = Plain::new(&grown.graph, grown.inputs.len());
        let mut engine = Interpreter::new(Arc::clone(&program));
        for action in &stimulus {
            run_plainly(&mut plain, &grown, action);
            drive(&program, &mut engine, std::slice::from_ref(action));
            if !matches!(action, Action::Set(..)) {
                same_signals(&plain, &grown, &engine, &program)?;
            }
        }
    }

    #[test]
    fn engines_agree_with_the_interpreter_tick_by_tick(recipe in recipes(60), stimulus in stimuli(12), stride in 1..5_u64) {
        let program = Arc::new(compile_graph(grow(&recipe)));
        for engine in all(&program) {
            agree(&program, engine, &stimulus, stride)?;
        }
    }

    #[test]
    fn shared_code_of_repeated_modules_agrees_with_the_interpreter(
        replicas in replicas(20..70), stimulus in stimuli(12), stride in 1..5_u64
    ) {
        let program = Arc::new(compile_graph(replicate(&replicas)));
        let native = Native::shared(Arc::clone(&program)).expect("native code");
        agree(&program, Box::new(native), &stimulus, stride)?;
    }

    #[test]
    fn specialised_code_agrees_with_the_interpreter_whatever_its_profile_was(
        recipe in recipes(60), stimulus in stimuli(20), stride in 1..9_u64
    ) {
        // The profile is that of the first ticks, before inputs change.
        let program = Arc::new(compile_graph(grow(&recipe)));
        let native = Native::eager(Arc::clone(&program)).expect("native code");
        agree(&program, Box::new(native), &stimulus, stride)?;
    }

    #[test]
    fn engines_agree_on_random_circuit_files(draft in drafts(12), stimulus in stimuli(12), stride in 1..5_u64) {
        let text = write(&draft);
        let shelf = Shelf { near: "random" };
        let netlist = load("random.v", &text, None, &shelf, &[]);
        let netlist = netlist.map_err(|report| TestCaseError::fail(format!("{}\n{text}", report.render(false))))?;
        let program = Arc::new(compile(&netlist, &Observe::EVERYTHING));
        let eager: Box<dyn Engine> = Box::new(Native::eager(Arc::clone(&program)).expect("native code"));
        for engine in all(&program).into_iter().chain([eager]) {
            let agreed = agree(&program, engine, &stimulus, stride);
            agreed.map_err(|difference| TestCaseError::fail(format!("{difference}\n{text}")))?;
        }
    }
}

/// Runs an engine against the interpreter.
fn agree(
    program: &Arc<Program>,
    engine: Box<dyn Engine>,
    stimulus: &[Action],
    stride: u64,
) -> Result<(), TestCaseError> {
    let twin = Box::new(Interpreter::new(Arc::clone(program)));
    let mut lockstep = Lockstep::new(program, [twin, engine], stride);
    drive(program, &mut lockstep, stimulus);
    let Some(difference) = lockstep.difference() else { return Ok(()) };
    Err(TestCaseError::fail(format!("{difference}\nstimulus: {stimulus:?}\n{}", listing(&program.graph))))
}

fn run_plainly(plain: &mut Plain<'_>, program: &Program, action: &Action) {
    match *action {
        Action::Set(input, word) => {
            if let Some((input, word)) = setting(program, input, word) {
                plain.inputs[input] = word;
            }
        }
        Action::Settle => plain.settle(),
        Action::Advance(ticks, until) => {
            plain.settle();
            for _ in 0..ticks {
                plain.commit();
                plain.settle();
                if until && program.stop.is_some_and(|stop| plain.value(stop) != 0) {
                    break;
                }
            }
        }
    }
}

fn same_signals(
    plain: &Plain<'_>,
    grown: &Program,
    engine: &Interpreter,
    program: &Program,
) -> Result<(), TestCaseError> {
    for (before, after) in grown.signals.iter().zip(&program.signals) {
        let (expected, got) = (plain.value(before.value), engine.value(after.value));
        prop_assert_eq!(got, expected, "{}\n{}", before.name(), listing(&grown.graph));
    }
    Ok(())
}
