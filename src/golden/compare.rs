//! Comparing two waveforms by meaning, down to the first tick at which they differ.

use std::collections::HashMap;
use std::ops::Range;

use super::{Track, Waveform};

/// How many ticks before and after a divergence are shown.
const AROUND: u64 = 5;

/// Which signals two waveforms must both have.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Signals {
    /// All of them: a golden trace and its run. Both must tell about the same ticks.
    All,
    /// Those that both have are compared, as far as both go: ours and an outside simulator's.
    Shared,
}

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
    /// The ticks that each tells about, when these differ.
    pub spans: Option<(Range<u64>, Range<u64>)>,
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
    /// Whether there is no difference, and something was compared.
    #[must_use]
    pub fn is_equal(&self) -> bool {
        let same_signals = self.missing.is_empty() && self.extra.is_empty() && self.widths.is_empty();
        self.nets > 0 && same_signals && self.spans.is_none() && self.divergence.is_none()
    }
}

/// Compares two waveforms over the ticks that both tell about. Times of different units are brought to the finer one.
#[must_use]
pub fn compare(expected: &Waveform, got: &Waveform, signals: Signals) -> Comparison {
    let unit = expected.unit().min(got.unit());
    if expected.unit() != got.unit() {
        return compare(&expected.in_unit(unit), &got.in_unit(unit), signals);
    }
    let all = signals == Signals::All;
    let (mine, theirs) = (expected.span(), got.span());
    let span = mine.start.max(theirs.start)..mine.end.min(theirs.end);
    let only_in = |a: &Waveform, b: &Waveform| -> Vec<String> {
        let names = a.names().filter(|name| all && b.track(name).is_none());
        names.map(str::to_owned).collect()
    };
    let mut comparison = Comparison {
        missing: only_in(expected, got),
        extra: only_in(got, expected),
        spans: (all && mine != theirs).then_some((mine, theirs)),
        ..Comparison::default()
    };
    let pairs = shared(expected, got, &mut comparison);
    comparison.nets = pairs.len();
    comparison.divergence = divergence(&pairs, &span);
    comparison.span = span;
    comparison
}

/// A signal of both waveforms.
struct Pair<'a> {
    name: &'a str,
    expected: &'a Track,
    got: &'a Track,
    /// Aliases in both waveforms have the same.
    class: usize,
}

/// The signals of both, in the order of the expected waveform; those whose widths differ are noted instead.
fn shared<'a>(expected: &'a Waveform, got: &'a Waveform, comparison: &mut Comparison) -> Vec<Pair<'a>> {
    let (mut pairs, mut classes) = (Vec::new(), HashMap::new());
    for name in expected.names() {
        let (Some(mine), Some(theirs)) = (expected.track(name), got.track(name)) else { continue };
        if mine.width() == theirs.width() {
            let next = classes.len();
            let class = *classes.entry((expected.track_id(name), got.track_id(name))).or_insert(next);
            pairs.push(Pair { name, expected: mine, got: theirs, class });
        } else {
            comparison.widths.push((name.to_owned(), mine.width(), theirs.width()));
        }
    }
    pairs
}

fn divergence(pairs: &[Pair<'_>], span: &Range<u64>) -> Option<Divergence> {
    let mut firsts: Vec<Option<u64>> = Vec::new();
    for pair in pairs.iter() {
        if pair.class == firsts.len() {
            let first = pair.expected.differences(pair.got, span.clone()).next();
            firsts.push(first.map(|difference| difference.start));
        }
    }
    let tick = firsts.iter().copied().flatten().min()?;
    let around = tick.saturating_sub(AROUND).max(span.start)..tick.saturating_add(AROUND + 1).min(span.end);
    let values = |track: &Track| {
        let value = |tick| track.at(tick).map_or_else(|| "-".to_owned(), |value| value.to_string());
        around.clone().map(value).collect()
    };
    let differing = pairs.iter().filter(|pair| firsts[pair.class] == Some(tick));
    let nets = differing.map(|pair| Differing {
        name: pair.name.to_owned(),
        width: pair.expected.width(),
        expected: values(pair.expected),
        got: values(pair.got),
    });
    Some(Divergence { tick, nets: nets.collect(), around: around.clone() })
}

#[cfg(test)]
#[path = "compare_tests.rs"]
mod tests;
