//! Random traces: signals in scopes, some of them aliases, and their words at every tick.

use std::io::Cursor;

use stepwright::base::word::mask;
use stepwright::base::{Signal, ValueId};
use stepwright::trace::{FstWriter, Plan, Sampler, VcdWriter, Window};

use super::random::Random;

/// A trace and what it must be read back as.
pub struct Trace {
    /// Signals; their value ids index the words.
    pub signals: Vec<Signal>,
    /// Words tick by tick, from `first` on.
    pub words: Vec<Vec<u64>>,
    /// The first tick.
    pub first: u64,
}

impl Trace {
    /// `count` values under twice as many names, over `ticks` ticks.
    pub fn random(seed: u64, count: usize, ticks: usize, first: u64) -> Self {
        let mut random = Random(seed);
        let widths: Vec<u32> =
            (0..count).map(|_| if random.below(2) == 0 { 1 } else { 1 + random.below(64) as u32 }).collect();
        let signals = (0..count * 2).map(|i| {
            let value = if i < count { i } else { random.below(count as u64) as usize };
            let scope = ["", "counter_14", "counter_14.cell_2", "gen[3].summer_1"][random.below(4) as usize];
            let path = ["top"].into_iter().chain(scope.split('.').filter(|part| !part.is_empty()));
            let path = path.map(str::to_owned).chain([format!("net_{i}")]).collect();
            let signed = random.below(2) == 0;
            let fraction = [None, Some(0), Some(3)][random.below(3) as usize];
            Signal { path, width: widths[value], signed, fraction, value: ValueId::new(value) }
        });
        let signals = signals.collect();
        let mut words = vec![0; count];
        let words = (0..ticks).map(|_| {
            for (word, width) in words.iter_mut().zip(&widths) {
                if random.below(3) == 0 {
                    *word = random.word() & mask(*width);
                }
            }
            words.clone()
        });
        Self { words: words.collect(), signals, first }
    }

    /// Each tick with its words.
    pub fn ticks(&self) -> impl Iterator<Item = (u64, &Vec<u64>)> {
        (self.first..).zip(&self.words)
    }

    /// A signal's bits at a tick, as text.
    pub fn bits(&self, signal: &Signal, words: &[u64]) -> String {
        format!("{:0width$b}", words[signal.value.index()], width = signal.width as usize)
    }

    /// The trace as VCD.
    pub fn vcd(&self) -> Vec<u8> {
        let plan = Plan::new(&self.signals);
        let mut writer = VcdWriter::new(Vec::new(), &plan).expect("a header");
        let mut sampler = Sampler::new(&plan, Window::ALL);
        for (tick, words) in self.ticks() {
            let changes = sampler.sample(tick, |id| words[id.index()]).expect("inside the window");
            writer.tick(tick, changes).expect("a tick");
        }
        writer.finish().expect("an end")
    }

    /// The trace as FST.
    pub fn fst(&self) -> Vec<u8> {
        let plan = Plan::new(&self.signals);
        let mut writer = FstWriter::new(Cursor::new(Vec::new()), &plan).expect("a header");
        let mut sampler = Sampler::new(&plan, Window::ALL);
        for (tick, words) in self.ticks() {
            let changes = sampler.sample(tick, |id| words[id.index()]).expect("inside the window");
            writer.tick(tick, changes).expect("a tick");
        }
        writer.finish().expect("an end").into_inner()
    }
}
