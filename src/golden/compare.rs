//! Comparing two waveforms by meaning, down to the first tick at which they differ.

use std::ops::Range;

use super::Waveform;
use super::how::{How, Signals};
use super::input::Input;
use super::merge::{Merged, merge};
use super::pairs::{Pairs, Parts};
use super::read::cut;
use super::sample::Sampled;
use super::source::Source;
use super::track::Value;
use crate::base::Report;

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
    /// Whether the lists above are differences: not where only shared signals are asked for.
    pub needs_all: bool,
    /// Texts and events of both, and signals that are a number in one and bits in the other: they were not compared.
    pub uncompared: Vec<String>,
    /// Whether the times of one do not fit into 64 bits of the other's finer unit, so that not all were compared.
    pub beyond: bool,
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

    fn new(pairs: Pairs, merged: &Merged, how: &How) -> Self {
        let [missing, extra] = pairs.only;
        let [mine, theirs] = merged.spans.clone();
        let needs_all = how.signals == Signals::All;
        let is_cut = needs_all && how.window.is_none() && !merged.beyond && mine != theirs;
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
    let merged = merge(&mut expected.replay(), &mut got.replay(), &pairs, &how);
    let merged = merged.unwrap_or_else(|_| unreachable!("a waveform in memory has been read"));
    let divergence = divergence(&pairs, &merged, [expected, got]);
    Comparison { divergence, ..Comparison::new(pairs, &merged, &how) }
}

/// Two files compared.
#[derive(Clone, Debug)]
pub struct Diff {
    /// What was found.
    pub comparison: Comparison,
    /// If their values differ, what the expected and the got waveform say from some ticks before the first difference
    /// to some ticks after it, in the unit of the comparison: enough for [`super::causes`].
    pub around: Option<[Waveform; 2]>,
}

/// Compares two files of any size in memory that does not grow with their length; if their values differ, both are
/// read once more around the first difference.
///
/// # Errors
/// Those of [`super::read()`], and `W021` when there is no net to look at them by.
pub fn diff(expected: &Input, got: &Input, how: &How) -> Result<Diff, Report> {
    Ok(diffed([expected, got], how)?.0)
}

/// Compares a golden trace with a run as [`diff`] does, nothing forgiven.
///
/// # Errors
/// Those of [`diff`], and `W018` when the golden trace does not end with the time that closes every waveform of ours.
pub fn check(golden: &Input, run: &Input) -> Result<Diff, Report> {
    match diffed([golden, run], &How::default())? {
        (diff, true) => Ok(diff),
        (_, false) => Err(cut(golden.name()).into()),
    }
}

/// The comparison, and whether the expected file ends with a closing time.
fn diffed(inputs: [&Input; 2], how: &How) -> Result<(Diff, bool), Report> {
    let [mut expected, mut got] = [opened(inputs[0], how, 0)?, opened(inputs[1], how, 1)?];
    let pairs = Pairs::new(expected.declared(), got.declared(), how);
    let merged = merge(expected.as_mut(), got.as_mut(), &pairs, how)?;
    let is_closed = expected.is_closed();
    let units = [expected.declared().unit, got.declared().unit];
    // Readers hold buffers and threads.
    drop((expected, got));
    let Some(tick) = merged.first() else {
        return Ok((Diff { comparison: Comparison::new(pairs, &merged, how), around: None }, is_closed));
    };
    let window = around(tick, &merged.span);
    let read = |side: usize| {
        let factor = units[side] / units[0].min(units[1]);
        // One tick more, because registers answer to the tick before.
        let coarse = window.start.saturating_sub(1) / factor..window.end.div_ceil(factor);
        let mut source = opened(inputs[side], how, side)?;
        Waveform::gather(inputs[side].name(), source.as_mut(), &coarse).map(|wave| wave.finer(factor))
    };
    let waves = [read(0)?, read(1)?];
    let divergence = divergence(&pairs, &merged, [&waves[0], &waves[1]]);
    let comparison = Comparison { divergence, ..Comparison::new(pairs, &merged, how) };
    Ok((Diff { comparison, around: Some(waves) }, is_closed))
}

fn opened(input: &Input, how: &How, side: usize) -> Result<Box<dyn Source>, Report> {
    let source = input.open()?;
    match &how.at[side] {
        Some(edge) => Ok(Box::new(Sampled::new(input.name(), source, edge)?)),
        None => Ok(source),
    }
}

impl Merged {
    fn first(&self) -> Option<u64> {
        self.tallies.iter().filter_map(|tally| tally.first).min()
    }
}

fn around(tick: u64, span: &Range<u64>) -> Range<u64> {
    tick.saturating_sub(AROUND).max(span.start)..tick.saturating_add(AROUND + 1).min(span.end)
}

/// The first difference, with values out of waveforms that hold the ticks around it.
fn divergence(pairs: &Pairs, merged: &Merged, waves: [&Waveform; 2]) -> Option<Divergence> {
    let tick = merged.first()?;
    let unit = waves[0].unit().min(waves[1].unit());
    let around = around(tick, &merged.span);
    let values = |parts: &Parts, wave: &Waveform| {
        let at = |tick: u64| parts.put_together(|id| wave.track_of(id).at(tick / (wave.unit() / unit)));
        let shown = |value: Option<Value>| value.map_or_else(|| "-".to_owned(), |value| value.to_string());
        around.clone().map(|tick| shown(at(tick))).collect()
    };
    let differing = pairs.all.iter().filter(|pair| merged.tallies[pair.class].first == Some(tick));
    let nets = differing.map(|pair| {
        let [expected, got] = &pairs.classes[pair.class];
        let (expected, got) = (values(expected, waves[0]), values(got, waves[1]));
        Differing { name: pair.name.clone(), width: pair.width, expected, got }
    });
    Some(Divergence { tick, nets: nets.collect(), around: around.clone() })
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
