//! Random traces: signals in scopes, some of them aliases, and their words at every tick.

use std::io::Cursor;

use stepwright::base::word::mask;
use stepwright::base::{Signal, ValueId};
use stepwright::trace::{FORMATS, Frame, Observer, Wave};

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
        self.written("vcd")
    }

    /// The trace as FST.
    pub fn fst(&self) -> Vec<u8> {
        self.written("fst")
    }

    fn written(&self, ending: &str) -> Vec<u8> {
        let format = FORMATS.iter().find(|format| format.ending == ending).expect("a format");
        let mut file = Vec::new();
        let mut wave = Wave::new(format, Box::new(Cursor::new(&mut file)));
        let values = wave.begin(&self.signals).expect("a header");
        let words: Vec<Vec<u64>> =
            self.words.iter().map(|words| values.iter().map(|value| words[value.index()]).collect()).collect();
        for (step, (tick, words_now)) in (self.first..).zip(&words).enumerate() {
            let before = step.checked_sub(1).map(|before| words[before].as_slice());
            wave.tick(Frame { tick, words: words_now, before }).expect("a tick");
        }
        wave.end().expect("an end");
        drop(wave);
        file
    }
}
