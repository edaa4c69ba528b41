//! Comparing two waveforms by meaning, down to the first tick at which they differ.

use std::ops::Range;

use super::Waveform;
use super::how::{How, Signals};
use super::merge::{Merged, merge};
use super::pairs::{Pair, Pairs, Parts};
use super::track::Value;

/// A signal whose values differ.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Changed {
    /// Its dotted name.
    pub name: String,
    /// The first tick at which it differs.
    pub first: u64,
    /// At how many ticks it does.
    pub ticks: u64,
}

/// How many ticks before and after a divergence are shown.
const AROUND: u64 = 5;

/// What a comparison found; shown, it is a report for a person.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Comparison {
    /// How many signals were compared.
    pub nets: usize,
    /// The ticks that were compared.
    pub span: Range<u64>,
    /// Signals that only the expected waveform has.
    pub missing: Vec<String>,
    /// Signals that only the other one has.
    pub extra: Vec<String>,
    /// Signals whose width differs: name, expected and got bits.
    pub widths: Vec<(String, u32, u32)>,
    /// Whether signals that only one has are differences.
    pub needs_all: bool,
    /// Texts and events of both, and signals that are a number in one and bits in the other: they were not compared.
    pub uncompared: Vec<String>,
    /// Whether the times of one do not fit into 64 bits of the other's finer unit, so that not all were compared.
    pub beyond: bool,
    /// Femtoseconds that a tick stands for here: 1,000,000 with waveforms of ours.
    pub unit: u64,
    /// The ticks that each tells about, when these differ.
    pub spans: Option<(Range<u64>, Range<u64>)>,
    /// Every signal that differs, the earliest first.
    pub changed: Vec<Changed>,
    /// Where the values first differ.
    pub divergence: Option<Divergence>,
}

/// The first tick at which two waveforms differ.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Divergence {
    /// That tick.
    pub tick: u64,
    /// Every signal that differs at it.
    pub nets: Vec<Differing>,
    /// The ticks around it that are shown.
    pub around: Range<u64>,
}

/// A signal that differs.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Differing {
    /// Its dotted name.
    pub name: String,
    /// Width in bits.
    pub width: u32,
    /// Its values around the divergence, one for each tick of [`Divergence::around`]; `-` where there is none.
    pub expected: Vec<String>,
    /// The other waveform's.
    pub got: Vec<String>,
}

impl Comparison {
    /// Whether there is no difference, something was compared, and nothing was left out.
    #[must_use]
    pub fn is_equal(&self) -> bool {
        let same_names = !self.needs_all || self.missing.is_empty() && self.extra.is_empty();
        let whole = self.uncompared.is_empty() && !self.beyond;
        let same = same_names && self.widths.is_empty() && self.spans.is_none() && self.divergence.is_none();
        self.nets > 0 && self.span.start < self.span.end && whole && same
    }

    pub(super) fn new(pairs: Pairs, merged: &Merged, how: &How, units: [u64; 2]) -> Self {
        let [missing, extra] = pairs.only;
        let [mine, theirs] = merged.spans.clone();
        let needs_all = how.signals == Signals::All;
        let unit = units[0].min(units[1]);
        let is_other_clock = units[0] != units[1] || how.at.iter().any(Option::is_some);
        let slack = match how.signals {
            Signals::All => 0,
            Signals::Common => {
                if is_other_clock {
                    units[0].max(units[1]) / unit
                } else {
                    0
                }
            }
            Signals::Shared => u64::MAX,
        };
        let apart = mine.start.abs_diff(theirs.start).max(mine.end.abs_diff(theirs.end));
        let is_cut = how.window.is_none() && !merged.beyond && apart > slack;
        let tallied = pairs.all.iter().map(|pair| (pair, merged.tallies[pair.class]));
        let differing = tallied.filter_map(|(pair, tally)| {
            tally.first.map(|first| Changed { name: pair.name.clone(), first, ticks: tally.ticks })
        });
        let mut changed: Vec<_> = differing.collect();
        changed.sort_by_key(|changed| changed.first);
        Self {
            nets: pairs.all.len(),
            span: merged.span.clone(),
            missing,
            extra,
            widths: pairs.widths,
            needs_all,
            uncompared: pairs.uncompared,
            beyond: merged.beyond,
            unit,
            spans: is_cut.then_some((mine, theirs)),
            changed,
            divergence: None,
        }
    }
}

/// Compares two waveforms over the ticks that both tell about. Times of different units are brought to the finer one.
#[must_use]
pub fn compare(expected: &Waveform, got: &Waveform, signals: Signals) -> Comparison {
    let how = How { signals, ..How::default() };
    let pairs = Pairs::new(expected.declared(), got.declared(), &how);
    let merged = merge(&mut expected.replay(), &mut got.replay(), &pairs, &how, None);
    let merged = merged.unwrap_or_else(|_| unreachable!("a waveform in memory has been read"));
    let divergence = divergence(&pairs, &merged, [expected, got]);
    Comparison { divergence, ..Comparison::new(pairs, &merged, &how, [expected.unit(), got.unit()]) }
}

impl Merged {
    /// The first tick at which anything differs.
    pub(super) fn first(&self) -> Option<u64> {
        self.tallies.iter().filter_map(|tally| tally.first).min()
    }
}

/// The ticks that are shown around one.
pub(super) fn around(tick: u64, span: &Range<u64>) -> Range<u64> {
    tick.saturating_sub(AROUND).max(span.start)..tick.saturating_add(AROUND + 1).min(span.end)
}

/// The first difference, with values out of waveforms that hold the ticks around it.
pub(super) fn divergence(pairs: &Pairs, merged: &Merged, waves: [&Waveform; 2]) -> Option<Divergence> {
    let tick = merged.first()?;
    let differing = pairs.all.iter().filter(|pair| merged.tallies[pair.class].first == Some(tick));
    Some(shown(pairs, differing, tick, &merged.span, waves))
}

/// Signals at the ticks around one, out of waveforms that hold them.
pub(super) fn shown<'p>(
    pairs: &Pairs,
    nets: impl Iterator<Item = &'p Pair>,
    tick: u64,
    span: &Range<u64>,
    waves: [&Waveform; 2],
) -> Divergence {
    let unit = waves[0].unit().min(waves[1].unit());
    let around = around(tick, span);
    let values = |parts: &Parts, wave: &Waveform| {
        let at = |tick: u64| parts.put_together(|id| wave.track_of(id).at(tick / (wave.unit() / unit)));
        let shown = |value: Option<Value>| value.map_or_else(|| "-".to_owned(), |value| value.to_string());
        around.clone().map(|tick| shown(at(tick))).collect()
    };
    let nets = nets.map(|pair| {
        let [expected, got] = &pairs.classes[pair.class];
        let (expected, got) = (values(expected, waves[0]), values(got, waves[1]));
        Differing { name: pair.name.clone(), width: pair.width, expected, got }
    });
    Divergence { tick, nets: nets.collect(), around: around.clone() }
}

#[cfg(test)]
#[path = "compare_tests.rs"]
mod tests;

#[cfg(test)]
#[path = "false_equality_tests.rs"]
mod false_equality;

#[cfg(test)]
#[path = "matching_tests.rs"]
mod matching;
