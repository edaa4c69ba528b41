//! One stimulus at a time: a long run, from text to the first tick, many interpolators in one netlist.
//!
//! Throughput is in interpolator-ticks. The circuit feeds itself, see `circuits/bench/self_feeding_interpolator.v`.

mod circuits;

use std::hint::black_box;
use std::sync::Arc;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use stepwright::engine::{Engine, EngineKind, Native};

use circuits::{program, ring, single};

/// Interpolator-ticks of one measured run.
const TICKS: u64 = 100_000;

/// A long run, on each engine.
fn single_run(c: &mut Criterion) {
    let mut group = c.benchmark_group("single run");
    group.throughput(Throughput::Elements(TICKS));
    let program = program(&single());
    for kind in EngineKind::all().filter(|kind| *kind != EngineKind::AUTO) {
        let mut engine = kind.build(Arc::clone(&program), u64::MAX).expect("an engine for this machine");
        group.bench_function(kind.name(), |b| b.iter(|| engine.advance(black_box(TICKS), false)));
    }
    group.finish();
}

/// From the circuit's text to its first tick.
fn load(c: &mut Criterion) {
    let mut group = c.benchmark_group("text to first tick");
    let text = single();
    for kind in EngineKind::all().filter(|kind| ["interpreter", "native"].contains(&kind.name())) {
        group.bench_function(kind.name(), |b| {
            b.iter(|| {
                let mut engine = kind.build(program(black_box(&text)), u64::MAX).expect("an engine for this machine");
                engine.advance(1, false)
            });
        });
    }
    group.finish();
}

/// Many interpolators in one netlist: how fast they are compiled, and how fast they run.
fn growth(c: &mut Criterion) {
    for count in [1, 10, 100, 1000] {
        let program = program(&ring(count));
        let mut group = c.benchmark_group("growth");
        group.sample_size(10);
        group.bench_function(BenchmarkId::new("compile", count), |b| {
            b.iter(|| Native::new(black_box(Arc::clone(&program))).expect("native code").name());
        });
        let mut engine = Native::new(program).expect("native code");
        let ticks = TICKS / count as u64;
        group.throughput(Throughput::Elements(ticks * count as u64));
        group.bench_function(BenchmarkId::new("run", count), |b| b.iter(|| engine.advance(black_box(ticks), false)));
        group.finish();
    }
}

criterion_group!(benches, single_run, load, growth);
criterion_main!(benches);
