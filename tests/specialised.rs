//! Specialised native code against the interpreter: on everything that is shipped, over a long run, and after a profile
//! that no longer holds.

use std::sync::Arc;

use rayon::prelude::*;
use stepwright::compile::{Observe, Program, compile};
use stepwright::engine::{Engine, Interpreter, Lockstep, Native};
use stepwright::simulation::{Circuit, Design, Session, shipped};

fn everything(design: &Design) -> Arc<Program> {
    Arc::new(compile(design.netlist(), &Observe::EVERYTHING))
}

fn side_by_side(program: &Arc<Program>, native: Native, stride: u64) -> Lockstep {
    Lockstep::new(program, [Box::new(Interpreter::new(Arc::clone(program))), Box::new(native)], stride)
}

/// The profile is that of the first ticks, before the scenario's inputs change.
#[test]
fn every_scenario_runs_alike_on_code_that_was_specialised_on_its_first_ticks() {
    let differences: Vec<_> = shipped::names("toml").collect::<Vec<_>>().into_par_iter().filter_map(differ).collect();
    assert!(differences.is_empty(), "{}", differences.join("\n"));
}

fn differ(name: &str) -> Option<String> {
    let design = Session::open(name).and_then(Session::elaborate).unwrap_or_else(|report| panic!("{report}"));
    let program = everything(&design);
    let mut lockstep = side_by_side(&program, Native::eager(Arc::clone(&program)).expect("native code"), 61);
    let stimulus = design.stimulus();
    stimulus.initial.iter().enumerate().for_each(|(input, &word)| lockstep.set_input(input, word));
    let (last, mut tick) = (stimulus.last_tick().0.min(3_000), 0);
    for change in &stimulus.changes {
        let until = change.tick.min(last);
        lockstep.advance(until - tick, false);
        tick = until;
        lockstep.set_input(change.input, change.word);
    }
    lockstep.advance(last - tick, false);
    lockstep.difference().map(|difference| format!("{name}: {difference}"))
}

#[test]
fn a_long_run_is_specialised_and_ends_as_the_interpreters_does() {
    let circuit = Circuit::shipped("bench/self_feeding_interpolator").expect("shipped");
    let program = everything(&circuit.session().elaborate().expect("a design"));
    let ticks = 200_000;
    let mut native = Native::new(Arc::clone(&program)).expect("native code");
    native.advance(ticks, false);
    let stats = native.stats().expect("specialised by now");
    assert!(stats.ticks > 10_000, "{stats:?}");
    assert!(stats.leaves.len() > 1 && stats.leaves.iter().all(|(work, _)| work.ops < stats.whole.ops), "{stats:?}");
    let shares: f64 = stats.leaves.iter().map(|(_, share)| share).sum();
    assert!((0.9..=1.000_001).contains(&shares), "{stats:?}");
    let mut twin = Interpreter::new(Arc::clone(&program));
    twin.advance(ticks, false);
    for id in program.observed() {
        assert_eq!(native.value(id), twin.value(id), "{id:?}");
    }
}

#[test]
fn code_that_was_specialised_at_rest_is_specialised_anew_when_the_machine_works() {
    let circuit = Circuit::shipped("su1522157/interpolator").expect("shipped");
    let program = everything(&circuit.session().elaborate().expect("a design"));
    let input = |name: &str| program.inputs.iter().position(|port| port.name == name).expect("an input");
    let mut native = Native::eager(Arc::clone(&program)).expect("native code");
    native.advance(1_000, false);
    let at_rest = native.stats().cloned();
    let mut twin = Interpreter::new(Arc::clone(&program));
    twin.advance(1_000, false);
    // With the start held, frame follows frame.
    for engine in [&mut native as &mut dyn Engine, &mut twin] {
        for (name, word) in [("major_32", 127), ("minor_34", 43), ("start_33", 1)] {
            engine.set_input(input(name), word);
        }
        (0..20).for_each(|_| assert_eq!(engine.advance(1_000, false), 1_000));
    }
    let at_work = native.stats().expect("specialised anew");
    assert_ne!(at_rest.map(|stats| stats.leaves), Some(at_work.leaves.clone()));
    assert!(at_work.rests < at_work.ticks / 100, "{at_work:?}");
    for id in program.observed() {
        assert_eq!(native.value(id), twin.value(id), "{id:?}");
    }
}
