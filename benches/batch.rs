//! Many frames of the SU 1522157 interpolator at once, by path and number of threads. Throughput is in circuit-ticks.

use std::ops::ControlFlow;
use std::time::Duration;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use stepwright::base::{Change, Stimulus, StopRule};
use stepwright::compile::{Observe, Program, Until, compile};
use stepwright::engine::LanesPath;
use stepwright::engine::batch::{Done, Options, Row, run_batch};
use stepwright::simulation::Circuit;

const FRAMES: u64 = 400_000;

/// The interpolator until it is no longer busy, its pulses counted.
fn interpolator() -> Program {
    let circuit = Circuit::shipped("su1522157/interpolator").expect("a shipped circuit");
    let netlist = circuit.elaborate(&[]).unwrap_or_else(|report| panic!("{report}"));
    let net = netlist.top_net("busy").expect("an output");
    let until = Some(Until { net, high: false });
    compile(&netlist, &Observe { until, pulses: true, ..Observe::OUTPUTS })
}

/// Draws every frame: both operands 0 to 255 from a shift register, the greater one first.
fn frames(program: &Program) -> impl FnMut(&mut [u64]) -> bool + Send + use<> {
    let input = |name: &str| program.inputs.iter().position(|port| port.name == name).expect("an input");
    let (major, minor, x_is_major) = (input("major_32"), input("minor_34"), input("x_is_major_35"));
    let (mut left, mut register) = (FRAMES, 0xACE1_u64);
    move |words| {
        for _ in 0..16 {
            let bit = (register ^ register >> 2 ^ register >> 3 ^ register >> 5) & 1;
            register = register >> 1 | bit << 15;
        }
        let (a, b) = (register & 255, register >> 8 & 255);
        (words[major], words[minor], words[x_is_major]) = (a.max(b), a.min(b), u64::from(a > b));
        left = left.saturating_sub(1);
        left > 0
    }
}

fn run(program: &Program, path: LanesPath, threads: usize) -> Done {
    let start = program.inputs.iter().position(|port| port.name == "start_33").expect("an input");
    let change = |tick, word| Change { tick, input: start, word };
    let initial = vec![0; program.inputs.len()];
    let stop = StopRule::Until { limit: 100_000 };
    let stimulus = Stimulus { initial, changes: vec![change(0, 1), change(1, 0)], stop };
    let sink = |row: Row<'_>| {
        std::hint::black_box(row);
        ControlFlow::Continue(())
    };
    let options = Options { threads, path, ..Options::default() };
    run_batch(program, &stimulus, frames(program), sink, options).expect("threads start")
}

fn batch(criterion: &mut Criterion) {
    let program = interpolator();
    let ticks = run(&program, LanesPath::best(), 1).ticks;
    let mut group = criterion.benchmark_group("batch");
    group.throughput(Throughput::Elements(ticks)).sample_size(10).measurement_time(Duration::from_secs(3));
    for path in LanesPath::all() {
        for threads in [1, 2] {
            let id = BenchmarkId::new(format!("{path:?}"), threads);
            group.bench_function(id, |bencher| bencher.iter(|| run(&program, path, threads)));
        }
    }
    group.finish();
}

criterion_group!(benches, batch);
criterion_main!(benches);
