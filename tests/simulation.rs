//! A run from outside: when it stops, when its inputs change, and that sampling does not disturb it.

use std::sync::Arc;

use stepwright::base::{Report, Signal, ValueId};
use stepwright::compile::{Observe, compile};
use stepwright::simulation::{Circuit, EngineKind, Outcome, Session, StoppedBy};
use stepwright::trace::{Coordinate, Frame, Observer, Path, Select, VCD, Wave};

/// A trigger that is set by `start` and reset nine ticks later: busy for nine ticks.
const FRAME: &str = "
module frame(input wire clk, input wire start, output wire busy);
    wire late;
    delay_element #(.DELAY(9)) delay_1 (.clk(clk), .pulse_in(start), .pulse_out(late), .active());
    trigger trigger_2 (.clk(clk), .set(start), .reset(late), .q(busy), .q_inverse());
endmodule
";

fn frame(rest: &str) -> Session {
    let text = format!("circuit = \"frame\"\n{rest}");
    Circuit::text("frame.v", FRAME).scenario("frame.toml", &text).expect("a scenario")
}

/// Keeps the word of one signal at every tick.
struct Words(&'static str, Vec<(u64, u64)>);

impl Observer for Words {
    fn wants(&self, name: &str) -> bool {
        name == self.0
    }

    fn begin(&mut self, signals: &[Signal]) -> Result<Vec<ValueId>, Report> {
        Ok(signals.iter().filter(|signal| signal.name() == self.0).map(|signal| signal.value).collect())
    }

    fn tick(&mut self, frame: Frame<'_>) -> Result<(), Report> {
        self.1.push((frame.tick, frame.words[0]));
        Ok(())
    }

    fn end(&mut self) -> Result<(), Report> {
        Ok(())
    }
}

/// Runs freely and observed, on every engine; all must agree. Returns the outcome and `start` at every tick.
fn run(rest: &str) -> (Outcome, Vec<(u64, u64)>) {
    let mut words = Words("start", Vec::new());
    let design = frame(rest).engine(EngineKind::INTERPRETER).elaborate().expect("a design");
    let outcome = design.start_with(vec![Box::new(&mut words)]).expect("a run").finish().expect("nothing is written");
    for kind in EngineKind::all() {
        let design = frame(rest).engine(kind).elaborate().expect("a design");
        let freely = design.start_with(Vec::new()).expect("an engine").finish();
        assert_eq!(freely.expect("nothing is written"), outcome, "{kind}");
    }
    (outcome, words.1)
}

fn high(outcome: &Outcome) -> u64 {
    outcome.outputs[0].pulses.expect("one bit").high
}

const PULSE: &str = "[[at]]\ntick = 0\nset = { start = 1 }\n[[at]]\ntick = 1\nset = { start = 0 }\n";

#[test]
fn until_is_judged_only_after_the_last_change_of_an_input() {
    // Busy is low at tick 0, where the frame begins; it is high from tick 1 to tick 9.
    let (outcome, seen) = run(&format!("{PULSE}[stop]\nuntil = \"!busy\"\nlimit = 100\n"));
    assert_eq!(outcome.stopped_by, StoppedBy::Until);
    assert_eq!((outcome.ticks, outcome.pulses("busy"), high(&outcome)), (11, Some(1), 9));
    let ticks: Vec<_> = seen.iter().map(|(tick, _)| *tick).collect();
    assert_eq!(ticks, (0..11).collect::<Vec<_>>(), "every tick is seen once, the last one too");
}

#[test]
fn a_second_frame_is_waited_for() {
    let again = "[[at]]\ntick = 20\nset = { start = 1 }\n[[at]]\ntick = 21\nset = { start = 0 }\n";
    let (outcome, _) = run(&format!("{PULSE}{again}[stop]\nuntil = \"!busy\"\nlimit = 100\n"));
    assert_eq!((outcome.ticks, outcome.pulses("busy"), high(&outcome)), (31, Some(2), 18));
}

#[test]
fn a_net_that_never_comes_ends_at_the_limit() {
    let (outcome, _) = run("[stop]\nuntil = \"busy\"\nlimit = 50\n");
    assert_eq!((outcome.ticks, outcome.stopped_by), (50, StoppedBy::Limit));
}

#[test]
fn a_limit_before_the_last_change_ends_the_run_there() {
    let (outcome, seen) =
        run(&format!("{PULSE}[[at]]\ntick = 30\nset = {{ start = 1 }}\n[stop]\nuntil = \"!busy\"\nlimit = 15\n"));
    assert_eq!((outcome.ticks, outcome.stopped_by, seen.len()), (15, StoppedBy::Limit, 15));
}

#[test]
fn a_number_of_ticks_is_run_exactly() {
    for ticks in [1, 2, 17] {
        let (outcome, seen) = run(&format!("{PULSE}[stop]\nticks = {ticks}\n"));
        assert_eq!((outcome.ticks, outcome.stopped_by), (ticks, StoppedBy::Ticks));
        assert_eq!(seen.len() as u64, ticks);
    }
}

#[test]
fn a_change_is_seen_in_its_own_tick() {
    let (_, seen) = run("[[at]]\ntick = 5\nset = { start = 1 }\n[stop]\nticks = 8\n");
    assert_eq!(seen.iter().map(|(_, word)| *word).collect::<Vec<_>>(), [0, 0, 0, 0, 0, 1, 1, 1]);
}

#[test]
fn all_that_is_wrong_with_a_scenario_is_told_at_once() {
    let session = frame("[inputs]\nstrat = 1\nstart = 2\n[stop]\nuntil = \"bsy\"\nlimit = 5\n");
    let report = session.elaborate().expect_err("wrong");
    assert_eq!(report.diagnostics.iter().map(|error| error.code).collect::<Vec<_>>(), ["S010", "S011", "S012"]);
}

#[test]
fn the_clock_cannot_be_waited_for() {
    for until in ["clk", "!clk"] {
        let report = frame("").until(until).elaborate().expect_err("the clock");
        assert!(report.to_string().contains("ticks = N"), "{report}");
    }
    let report = frame("").until("cls").elaborate().expect_err("no net");
    assert!(!report.to_string().contains("`clk`"), "the clock is not proposed: {report}");
}

#[test]
fn a_run_is_stepped_by_hand_and_shows_what_is_inside_the_blocks() -> Result<(), Report> {
    let mut run = Circuit::text("frame.v", FRAME).session().start()?;
    let (start, late, busy) = (run.input("start")?, run.net("late")?, run.net("busy")?);
    let inside = run.net("trigger_2.q")?;
    run.set(start, 1)?;
    run.step(1);
    run.set(start, 0)?;
    assert_eq!(run.read(inside), 1);
    assert!(run.until(late, 20));
    assert_eq!(run.tick(), 9);
    assert_eq!(run.bits(busy).len(), 1);
    assert!(run.net("bussy").is_err());
    assert!(run.set(start, 2).is_err());
    assert!(!run.until(late, 20));
    Ok(())
}

#[test]
fn what_is_changed_by_hand_wins_over_the_scenario_and_drops_what_held_only_for_it() {
    let rest = "title = \"A frame\"\n[stop]\nticks = 7\n[expect]\nticks = 7\n";
    let kept = frame(rest);
    assert_eq!((kept.scenario().title.as_str(), kept.scenario().expect.ticks), ("A frame", Some(7)));
    let changed = frame(rest).input("start", 1).ticks(3);
    assert_eq!((changed.scenario().title.as_str(), changed.scenario().expect.ticks), ("", None));
    assert_eq!(changed.start().expect("a run").finish().expect("an outcome").ticks, 3);
}

#[test]
fn expectations_may_name_any_net_and_say_what_is_wrong() {
    let rest = |outputs: &str| {
        let stop = "[stop]\nuntil = \"late\"\nlimit = 100\n[expect]\nticks = 11\n";
        format!("{PULSE}{stop}outputs = {{ {outputs} }}\npulses = {{ busy = 1 }}\n")
    };
    let report = frame(&rest("nowhere = 3")).elaborate().expect_err("no such net").to_string();
    assert!(report.contains("S012") && report.contains("frame.toml:13:13"), "{report}");
    let design = frame(&rest("\"trigger_2.q\" = 1, late = 0")).elaborate().expect("a design");
    let mut run = design.start_with(Vec::new()).expect("a run");
    let outcome = run.finish().expect("an outcome");
    let failed = run.failed_expectations(&design.scenario().expect, &outcome);
    assert_eq!(failed, ["expected ticks 11, got 10", "expected late 0, got 1"]);
}

#[test]
fn observers_may_come_and_go_while_a_circuit_runs() -> Result<(), Report> {
    let mut vcd = Vec::new();
    let mut path = Path::new(["busy", "start"].map(|name| Coordinate::Signal(name.to_owned())), None);
    let mut run = frame(PULSE).start()?;
    run.step(2);
    run.record(Wave::new(VCD, Box::new(std::io::Cursor::new(&mut vcd))).of(Select::new(["busy"])?))?;
    run.step(8);
    run.record(&mut path)?;
    run.step(2);
    run.end_recording()?;
    run.step(5);
    assert_eq!(run.tick(), 17);
    drop(run);
    let text = String::from_utf8(vcd).expect("text");
    assert!(text.ends_with("#2\n$dumpvars\n1!\n$end\n#10\n0!\n#13\n"), "{text}");
    assert_eq!(path.strokes(), [[[0.0, 0.0]]]);
    Ok(())
}

#[test]
fn an_observer_that_fails_ends_the_run_with_its_error() {
    struct Full;
    impl Observer for Full {
        fn wants(&self, _: &str) -> bool {
            true
        }
        fn begin(&mut self, _: &[Signal]) -> Result<Vec<ValueId>, Report> {
            Ok(Vec::new())
        }
        fn tick(&mut self, frame: Frame<'_>) -> Result<(), Report> {
            let full = || stepwright::base::Diagnostic::new("C003", "the disk is full").into();
            if frame.tick == 3 { Err(full()) } else { Ok(()) }
        }
        fn end(&mut self) -> Result<(), Report> {
            panic!("nothing is left to finish")
        }
    }
    let mut run = frame("[stop]\nticks = 100\n").start().expect("a run");
    run.record(Full).expect("begins");
    assert!(run.finish().expect_err("full").to_string().contains("the disk is full"));
    assert_eq!(run.tick(), 3);
}

#[test]
fn watched_values_read_together_are_those_read_one_by_one() {
    let program = Arc::new(compile(frame("").elaborate().expect("a design").netlist(), &Observe::EVERYTHING));
    let ids = program.observed();
    for kind in EngineKind::all() {
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

#[test]
fn a_batch_gives_each_edge_that_it_counts_whatever_engine_runs_it() {
    let rows = |engine| {
        let design = Session::open("su1522157/interpolator").expect("shipped").engine(engine);
        let design = design.elaborate().expect("it is right");
        let batch = design.batch().with_edges();
        let minor = batch.input("minor_34").expect("an input").place();
        let mut minors = 0..=16;
        let mut rows = Vec::new();
        let feed = |words: &mut [u64]| minors.next().map(|word| words[minor] = word).is_some();
        let sink = |row: stepwright::simulation::Row<'_>| {
            let counts: Vec<_> = (0..row.pulses.len() as u32)
                .map(|pulse| row.edges.iter().filter(|edge| edge.pulse == pulse).count() as u64)
                .collect();
            assert_eq!(counts, row.pulses);
            assert!(row.edges.is_sorted() && row.edges.iter().all(|edge| u64::from(edge.tick) < row.ticks));
            rows.push(row.edges.to_vec());
            std::ops::ControlFlow::Continue(())
        };
        batch.run(feed, sink).expect("it runs");
        rows
    };
    let lanes = rows("lanes".parse().expect("an engine"));
    assert_eq!(lanes.len(), 17);
    // `busy` rises in the tick after the start.
    assert!(lanes.iter().all(|edges| edges[0].tick == 1), "{lanes:?}");
    assert_eq!(lanes, rows(EngineKind::INTERPRETER));
    assert_eq!(lanes, rows("native".parse().expect("an engine")));
}

/// Memories in a row, each addressed by the word of the one before: as many lanes as a machine has would need 600 MB.
fn a_row_of_memories() -> String {
    let memories: String = (1..=300)
        .map(|i| {
            format!(
                "wire [7:0] w{i}; presettable_memory #(.ADDRESS_WIDTH(12)) memory_{i} (.clk(clk), \
                 .address({{4'd0, w{}}}), .write(w), .write_address(12'd7), .write_word(8'd9), .word(w{i}));\n",
                i - 1
            )
        })
        .collect();
    format!(
        "module row (input wire clk, input wire w, input wire [7:0] a, output wire [7:0] q);\n\
         wire [7:0] w0 = a;\n{memories}assign q = w300;\nendmodule\n"
    )
}

#[test]
fn a_batch_of_what_is_too_large_for_lanes_runs_one_stimulus_after_another() {
    let text = a_row_of_memories();
    let rows = |engine| {
        let design =
            Circuit::text("row.v", text.as_str()).session().ticks(3).engine(engine).elaborate().expect("it is right");
        let (mut stimuli, mut rows) = (0..3, Vec::new());
        let feed = |words: &mut [u64]| stimuli.next().map(|word| words[1] = word).is_some();
        let done = design.batch().run(feed, |row| {
            rows.push(row.outputs.to_vec());
            std::ops::ControlFlow::Continue(())
        });
        done.map(|_| rows)
    };
    let refused = rows("lanes".parse().expect("an engine")).expect_err("it is too large");
    assert_eq!(refused.diagnostics[0].code, "E005");
    let auto = rows(EngineKind::AUTO).expect("it runs");
    assert_eq!(auto, rows(EngineKind::INTERPRETER).expect("it runs"));
    // Both ends of the trapezoid are delays of 120 ticks, and so is all behind its 82 words: such a word leads to itself.
    assert_eq!(auto[0], [120]);
}
