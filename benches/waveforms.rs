//! How fast traces are written: 53 signals that make about 100 bytes of VCD a tick, as the interpolator's do.
//!
//! Numbers are ticks a second; `crate_vcd` is the `vcd` crate alone, for comparison.

use std::io::{self, Cursor, Write};

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use stepwright::base::word::mask;
use stepwright::base::{Signal, ValueId};
use stepwright::trace::{Change, Frame, FstWriter, Plan, Sampler, VcdWriter, Window};

const TICKS: u64 = 100_000;

/// An output that only counts.
#[derive(Default)]
struct Nowhere(u64);

impl Write for Nowhere {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0 += bytes.len() as u64;
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// Widths and how often, one tick in so many, each signal changes.
fn mixture() -> Vec<(u32, u64)> {
    let pulses = (0..37).map(|i| (1, 2 + i % 7));
    let words = [(4, 1), (8, 2), (12, 2), (12, 4), (12, 4), (12, 8), (13, 4), (14, 4)];
    let wide = [(16, 4), (16, 4), (16, 4), (16, 16), (17, 8), (18, 16), (24, 64), (32, 512)];
    pulses.chain(words).chain(wide).collect()
}

fn signals() -> Vec<Signal> {
    let signal = |(i, (width, _)): (usize, (u32, u64))| Signal {
        path: vec!["interpolator".into(), format!("block_{}", i / 4), format!("net_{i}")],
        width,
        signed: false,
        fraction: None,
        value: ValueId::new(i),
    };
    mixture().into_iter().enumerate().map(signal).collect()
}

/// The words of each tick, computed beforehand so that only the writing is measured.
fn history() -> Vec<Vec<u64>> {
    let mut seed = 1u64;
    let mut random = move || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        seed >> 20
    };
    let mixture = mixture();
    let mut words = vec![0; mixture.len()];
    let mut step = || {
        for (word, (width, pause)) in words.iter_mut().zip(&mixture) {
            if random() % pause == 0 {
                *word = if *width == 1 { *word ^ 1 } else { random() & mask(*width) };
            }
        }
        words.clone()
    };
    (0..4096).map(|_| step()).collect()
}

fn run(plan: &Plan, history: &[Vec<u64>], mut each: impl FnMut(u64, &[Change])) {
    let mut sampler = Sampler::new(plan, Window::ALL);
    let mut before = None;
    for tick in 0..TICKS {
        let words = history[tick as usize % history.len()].as_slice();
        if let Some(changes) = sampler.sample(Frame { tick, words, before }) {
            each(tick, changes);
        }
        before = Some(words);
    }
}

fn by_the_crate(plan: &Plan, history: &[Vec<u64>]) {
    let mut writer = vcd::Writer::new(Nowhere::default());
    run(plan, history, |tick, changes| {
        writer.timestamp(tick).expect("a time");
        for change in changes {
            let (id, width) = (vcd::IdCode::from(change.slot.index() as u64), plan.slots()[change.slot.index()].width);
            let bit = |at: u32| vcd::Value::from(change.word >> at & 1 == 1);
            match width {
                1 => writer.change_scalar(id, bit(0)).expect("a change"),
                _ => writer.change_vector(id, (0..width).rev().map(bit)).expect("a change"),
            }
        }
    });
}

fn waveforms(criterion: &mut Criterion) {
    let (signals, history) = (signals(), history());
    let plan = Plan::new(&signals);
    let mut group = criterion.benchmark_group("waveforms");
    group.throughput(Throughput::Elements(TICKS)).sample_size(10);
    group.bench_function("scan", |b| {
        b.iter(|| {
            let mut count = 0;
            run(&plan, &history, |_, changes| count += changes.len());
            count
        });
    });
    group.bench_function("vcd", |b| {
        b.iter(|| {
            let mut writer = VcdWriter::new(Nowhere::default(), &plan).expect("a header");
            run(&plan, &history, |tick, changes| writer.tick(tick, changes).expect("a tick"));
            let bytes = writer.finish().expect("an end").0 / TICKS;
            assert!((80..120).contains(&bytes), "{bytes} bytes a tick");
        });
    });
    group.bench_function("crate_vcd", |b| b.iter(|| by_the_crate(&plan, &history)));
    group.bench_function("fst", |b| {
        b.iter(|| {
            let mut writer = FstWriter::new(Cursor::new(Vec::new()), &plan).expect("a header");
            run(&plan, &history, |tick, changes| writer.tick(tick, changes).expect("a tick"));
            writer.finish().expect("an end");
        });
    });
    group.finish();
}

criterion_group!(benches, waveforms);
criterion_main!(benches);
