//! Batches against the plain run of each stimulus on the interpreter.

use std::ops::ControlFlow;
use std::sync::Arc;

use proptest::prelude::*;

use super::*;
use crate::base::word::mask;
use crate::base::{Change, Graph, Op, Register, RegisterId, Stimulus, StopRule, StoppedBy, ValueId};
use crate::compile::Program;
use crate::engine::lanes::Path;
use crate::engine::lanes::tests::{graph, program};
use crate::engine::{Engine, Interpreter};

/// A row that owns its words.
#[derive(Clone, PartialEq, Eq, Debug)]
struct Kept {
    inputs: Vec<u64>,
    ticks: u64,
    stopped_by: StoppedBy,
    outputs: Vec<u64>,
    pulses: Vec<u64>,
}

/// One stimulus tick by tick, in the plainest words. Leaves the engine in the last tick.
fn run_plainly(
    engine: &mut Interpreter,
    program: &Program,
    stimulus: &Stimulus,
    inputs: &[u64],
    mut at_tick: impl FnMut(&Interpreter),
) -> (u64, StoppedBy) {
    inputs.iter().enumerate().for_each(|(input, &word)| engine.set_input(input, word));
    let (most, otherwise) = match stimulus.stop {
        StopRule::Ticks(ticks) => (ticks, StoppedBy::Ticks),
        StopRule::Until { limit } => (limit, StoppedBy::Limit),
    };
    let last_change = stimulus.changes.iter().map(|change| change.tick).max().unwrap_or(0);
    for tick in 0..most {
        if tick > 0 {
            engine.advance(1, false);
        }
        for change in stimulus.changes.iter().filter(|change| change.tick == tick) {
            engine.set_input(change.input, change.word);
        }
        engine.settle();
        at_tick(engine);
        let is_judged = otherwise == StoppedBy::Limit && tick >= last_change.max(1);
        if is_judged && program.stop.is_some_and(|stop| engine.value(stop) != 0) {
            return (tick + 1, StoppedBy::Until);
        }
    }
    (most, otherwise)
}

fn plain_row(program: &Arc<Program>, stimulus: &Stimulus, inputs: &[u64]) -> (Kept, Vec<Vec<u64>>) {
    let mut engine = Interpreter::new(Arc::clone(program));
    let mut waveform = Vec::new();
    let (ticks, stopped_by) = run_plainly(&mut engine, program, stimulus, inputs, |engine| {
        waveform.push(program.signals.iter().map(|signal| engine.value(signal.value)).collect());
    });
    let outputs = program.outputs.iter().map(|port| engine.value(port.value)).collect();
    let pulses = engine.pulses().iter().map(|pulses| pulses.rising).collect();
    (Kept { inputs: inputs.to_vec(), ticks, stopped_by, outputs, pulses }, waveform)
}

fn batch_rows(program: &Program, stimulus: &Stimulus, stimuli: &[Vec<u64>], options: Options<'_>) -> Vec<Kept> {
    let mut all = stimuli.iter();
    let feed = |words: &mut [u64]| all.next().map(|stimulus| words.copy_from_slice(stimulus)).is_some();
    let mut rows = Vec::new();
    let sink = |row: Row<'_>| {
        assert_eq!(row.index, rows.len() as u64, "rows come in order");
        let (outputs, pulses) = (row.outputs.to_vec(), row.pulses.to_vec());
        rows.push(Kept { inputs: row.inputs.to_vec(), ticks: row.ticks, stopped_by: row.stopped_by, outputs, pulses });
        ControlFlow::Continue(())
    };
    let done = run_batch(program, stimulus, feed, sink, options).expect("threads start");
    assert_eq!((done.rows, done.complete), (stimuli.len() as u64, true));
    rows
}

/// Counts down from its input and stops at 0: runs of every length. Its pulse output is high at every odd count.
fn countdown() -> Arc<Program> {
    let mut graph = Graph::default();
    let from = graph.push(Op::Input(0), 12);
    let load = graph.push(Op::Input(1), 1);
    let count = graph.push(Op::Register(RegisterId::new(0)), 12);
    let one = graph.push(Op::Const(1), 12);
    let less = graph.push(Op::Sub(count, one), 12);
    let next = graph.push(Op::Mux(load, from, less), 12);
    graph.registers.push(Register { width: 12, init: 0, next, enable: None, clear: None });
    let busy = graph.push(Op::ReduceOr(count), 1);
    let stop = graph.push(Op::Not(busy), 1);
    graph.push(Op::Slice(count, 0), 1);
    let mut program = program(graph, Some(stop));
    // The last node is the output: high at every odd count.
    program.pulses = vec![0];
    Arc::new(program)
}

fn start_pulse(limit: u64) -> Stimulus {
    let change = |tick, word| Change { tick, input: 1, word };
    let changes = vec![change(0, 1), change(1, 0)];
    Stimulus { initial: vec![0; 2], changes, stop: StopRule::Until { limit } }
}

fn uneven(count: u64) -> Vec<Vec<u64>> {
    (0..count)
        .map(|i| vec![i.wrapping_mul(0x9E37_79B9_7F4A_7C15) >> 33 & if i % 7 == 0 { 4095 } else { 63 }, 0])
        .collect()
}

#[test]
fn runs_of_uneven_length_come_back_in_order_whatever_the_threads_and_the_path() {
    let (program, stimulus, stimuli) = (countdown(), start_pulse(3000), uneven(5000));
    // A count of n is loaded at the end of tick 0, is n in tick 1 and 0 in tick n + 1, the last of n + 2 ticks.
    let expected = |stimulus: &Vec<u64>| (stimulus[0] + 2).min(3000);
    for path in Path::all() {
        for threads in [1, 2, 3] {
            let rows = batch_rows(&program, &stimulus, &stimuli, Options { threads, path, ..Options::default() });
            for (row, stimulus) in rows.iter().zip(&stimuli) {
                let by = if stimulus[0] + 2 <= 3000 { StoppedBy::Until } else { StoppedBy::Limit };
                assert_eq!((&row.inputs, row.ticks, row.stopped_by), (stimulus, expected(stimulus), by));
            }
        }
    }
}

#[test]
fn every_row_equals_the_plain_run_of_its_stimulus() {
    let (program, stimuli) = (countdown(), uneven(600));
    for stimulus in
        [start_pulse(100), start_pulse(2), start_pulse(1), Stimulus { stop: StopRule::Ticks(37), ..start_pulse(1) }]
    {
        let plain: Vec<_> = stimuli.iter().map(|words| plain_row(&program, &stimulus, words).0).collect();
        for path in Path::all() {
            let rows = batch_rows(&program, &stimulus, &stimuli, Options { threads: 1, path, ..Options::default() });
            assert_eq!(rows, plain, "{path:?}");
        }
    }
}

#[test]
fn the_waveform_of_a_watched_stimulus_is_that_of_a_single_run() {
    let (program, stimulus, stimuli) = (countdown(), start_pulse(3000), uneven(2000));
    for index in [0, 7, 1999] {
        let mut waveform = Vec::new();
        let mut sample = |tick: u64, words: &[u64]| {
            assert_eq!(tick, waveform.len() as u64);
            waveform.push(words.to_vec());
        };
        let watch = Some(Watch { index, sample: &mut sample });
        batch_rows(&program, &stimulus, &stimuli, Options { watch, ..Options::default() });
        assert_eq!(waveform, plain_row(&program, &stimulus, &stimuli[index as usize]).1);
    }
}

#[test]
fn a_sink_that_breaks_off_gets_no_further_row() {
    let (program, stimulus, stimuli) = (countdown(), start_pulse(3000), uneven(5000));
    let mut all = stimuli.iter();
    let feed = |words: &mut [u64]| all.next().map(|stimulus| words.copy_from_slice(stimulus)).is_some();
    let mut rows = 0;
    let sink = |_: Row<'_>| {
        rows += 1;
        if rows == 1000 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    let done = run_batch(&program, &stimulus, feed, sink, Options { threads: 2, ..Options::default() }).expect("runs");
    assert_eq!((done.rows, done.complete, rows), (1000, false, 1000));
}

#[test]
fn a_batch_without_stimuli_is_complete_at_once() {
    assert_eq!(batch_rows(&countdown(), &start_pulse(10), &[], Options::default()), []);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn batches_of_random_programs_equal_plain_runs(
        choices in proptest::collection::vec(any::<u64>(), 300),
        stimuli in proptest::collection::vec(any::<[u64; 3]>(), 1..700),
        mut changes in proptest::collection::vec((0u64..40, 0usize..3, any::<u64>()), 0..5),
        limit in 1u64..60,
        is_until in any::<bool>(),
    ) {
        let mut made = graph(&choices, 20);
        let last = ValueId::new(made.nodes.len() - 1);
        let stop = made.push(Op::ReduceXor(last), 1);
        let program = Arc::new(program(made, Some(stop)));
        let fitted = |input: usize, word: u64| word & mask(program.inputs[input].width);
        changes.sort_by_key(|change| change.0);
        let stimulus = Stimulus {
            initial: vec![0; 3],
            changes: changes.iter().map(|&(tick, input, word)| Change { tick, input, word: fitted(input, word) }).collect(),
            stop: if is_until { StopRule::Until { limit } } else { StopRule::Ticks(limit) },
        };
        let stimuli: Vec<Vec<u64>> =
            stimuli.iter().map(|words| (0..3).map(|input| fitted(input, words[input])).collect()).collect();
        let plain: Vec<_> = stimuli.iter().map(|words| plain_row(&program, &stimulus, words).0).collect();
        for path in Path::all() {
            let rows = batch_rows(&program, &stimulus, &stimuli, Options { threads: 2, path, ..Options::default() });
            prop_assert_eq!(&rows, &plain, "{:?}", path);
        }
    }
}
