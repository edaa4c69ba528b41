//! A run from outside: when it stops, when its inputs change, and that sampling does not disturb it.

use std::sync::Arc;

use stepwright::base::Report;
use stepwright::compile::{Observe, Program, compile};
use stepwright::engine::{Engine, EngineKind, Interpreter};
use stepwright::netlist::{self, Library, Netlist};
use stepwright::scenario;
use stepwright::simulation::{self, Outcome, Simulation, Stimulus, StoppedBy, resolve};

/// A trigger that is set by `start` and reset nine ticks later: busy for nine ticks.
const FRAME: &str = "
module frame(input wire clk, input wire start, output wire busy);
    wire late;
    delay_element #(.DELAY(9)) delay_1 (.clk(clk), .pulse_in(start), .pulse_out(late), .active());
    trigger trigger_2 (.clk(clk), .set(start), .reset(late), .q(busy), .q_inverse());
endmodule
";

struct NoModules;

impl Library for NoModules {
    fn find(&self, _: &str) -> Option<(String, Arc<str>)> {
        None
    }
}

fn frame() -> Netlist {
    netlist::load("frame.v", FRAME, None, &NoModules, &[]).expect("a netlist")
}

fn prepared(rest: &str) -> (Netlist, Stimulus, Arc<Program>) {
    let netlist = frame();
    let scenario = scenario::parse("frame.toml", &format!("circuit = \"frame\"\n{rest}")).expect("a scenario");
    let stimulus = resolve(&netlist, &scenario).expect("a stimulus");
    let observe = Observe { until: stimulus.stop.until, pulses: true, ..Observe::OUTPUTS };
    let program = Arc::new(compile(&netlist, &observe));
    (netlist, stimulus, program)
}

/// Runs freely and sampled, on every engine; all must agree. Returns the outcome and the ticks that were sampled.
fn run(rest: &str) -> (Outcome, Vec<u64>) {
    let (_, stimulus, program) = prepared(rest);
    let mut ticks = Vec::new();
    let mut sample = |tick: u64, _: &dyn Engine| ticks.push(tick);
    let mut interpreter = Interpreter::new(Arc::clone(&program));
    let outcome = simulation::run(&mut interpreter, &program, &stimulus, Some(&mut sample));
    for kind in EngineKind::ALL {
        let mut engine = kind.build(Arc::clone(&program), 100).expect("an engine");
        assert_eq!(simulation::run(engine.as_mut(), &program, &stimulus, None), outcome, "{kind}");
    }
    (outcome, ticks)
}

const PULSE: &str = "[[at]]\ntick = 0\nset = { start = 1 }\n[[at]]\ntick = 1\nset = { start = 0 }\n";

#[test]
fn until_is_judged_only_after_the_last_change_of_an_input() {
    // Busy is low at tick 0, where the frame begins; it is high from tick 1 to tick 9.
    let (outcome, ticks) = run(&format!("{PULSE}[stop]\nuntil = \"!busy\"\nlimit = 100\n"));
    assert_eq!(outcome.stopped_by, StoppedBy::Until);
    assert_eq!((outcome.ticks, &outcome.pulses[..]), (11, &[9][..]));
    assert_eq!(ticks, (0..11).collect::<Vec<_>>(), "every tick is sampled once, the last one too");
}

#[test]
fn a_second_frame_is_waited_for() {
    let again = "[[at]]\ntick = 20\nset = { start = 1 }\n[[at]]\ntick = 21\nset = { start = 0 }\n";
    let (outcome, _) = run(&format!("{PULSE}{again}[stop]\nuntil = \"!busy\"\nlimit = 100\n"));
    assert_eq!((outcome.ticks, outcome.pulses[0]), (31, 18));
}

#[test]
fn a_net_that_never_comes_ends_at_the_limit() {
    let (outcome, _) = run("[stop]\nuntil = \"busy\"\nlimit = 50\n");
    assert_eq!((outcome.ticks, outcome.stopped_by), (50, StoppedBy::Limit));
}

#[test]
fn a_limit_before_the_last_change_ends_the_run_there() {
    let (outcome, ticks) =
        run(&format!("{PULSE}[[at]]\ntick = 30\nset = {{ start = 1 }}\n[stop]\nuntil = \"!busy\"\nlimit = 15\n"));
    assert_eq!((outcome.ticks, outcome.stopped_by, ticks.len()), (15, StoppedBy::Limit, 15));
}

#[test]
fn a_number_of_ticks_is_run_exactly() {
    for ticks in [1, 2, 17] {
        let (outcome, sampled) = run(&format!("{PULSE}[stop]\nticks = {ticks}\n"));
        assert_eq!((outcome.ticks, outcome.stopped_by), (ticks, StoppedBy::Ticks));
        assert_eq!(sampled.len() as u64, ticks);
    }
}

#[test]
fn a_change_is_seen_in_its_own_tick() {
    let (netlist, stimulus, _) = prepared("[[at]]\ntick = 5\nset = { start = 1 }\n[stop]\nticks = 8\n");
    let program = Arc::new(compile(&netlist, &Observe::EVERYTHING));
    let start = program.inputs[0].value;
    let mut seen = Vec::new();
    let mut sample = |_: u64, engine: &dyn Engine| seen.push(engine.value(start));
    simulation::run(&mut Interpreter::new(Arc::clone(&program)), &program, &stimulus, Some(&mut sample));
    assert_eq!(seen, [0, 0, 0, 0, 0, 1, 1, 1]);
}

#[test]
fn all_that_is_wrong_with_a_scenario_is_told_at_once() {
    let text = "circuit = \"frame\"\n[inputs]\nstrat = 1\nstart = 2\n[stop]\nuntil = \"bsy\"\nlimit = 5\n";
    let scenario = scenario::parse("frame.toml", text).expect("well formed");
    let codes: Vec<_> = resolve(&frame(), &scenario).expect_err("wrong").iter().map(|error| error.code).collect();
    assert_eq!(codes, ["S010", "S011", "S012"]);
}

#[test]
fn a_simulation_steps_by_hand_and_shows_what_is_inside_the_blocks() -> Result<(), Report> {
    let mut simulation = Simulation::new(&frame());
    simulation.set("start", 1)?;
    simulation.step();
    simulation.set("start", 0)?;
    assert_eq!(simulation.read("trigger_2.q")?, 1);
    assert!(simulation.run_until("late", 20)?);
    assert_eq!(simulation.tick(), 9);
    assert_eq!(simulation.bits("busy")?.len(), 1);
    assert!(simulation.read("bussy").is_err());
    assert!(simulation.set("start", 2).is_err());
    assert!(!simulation.run_until("late", 20)?);
    Ok(())
}

#[test]
fn watched_values_read_together_are_those_read_one_by_one() {
    let program = Arc::new(compile(&frame(), &Observe::EVERYTHING));
    let ids = program.observed();
    for kind in EngineKind::ALL {
        let mut engine = kind.build(Arc::clone(&program), 100).expect("an engine");
        engine.watch(&ids);
        engine.set_input(0, 1);
        for _ in 0..12 {
            engine.advance(1, false);
            let mut words = vec![0; ids.len()];
            engine.read(&mut words);
            assert_eq!(words, ids.iter().map(|&id| engine.value(id)).collect::<Vec<_>>(), "{kind}");
        }
    }
}
