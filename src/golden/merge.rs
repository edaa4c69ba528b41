//! Two sources read side by side, and what differs between them, in memory that does not grow with time.

use std::ops::Range;

use super::cone::{Cone, Cones};
use super::declared::{Kind, SignalId};
use super::how::{How, Signals, Unknown};
use super::pairs::{Pairs, Parts};
use super::source::Source;
use super::state::State;
use super::track::Value;
use crate::base::Report;

/// How often and when a pair differs.
#[derive(Clone, Copy, Default, Debug)]
pub(super) struct Tally {
    since: Option<u64>,
    /// The first tick at which it differs.
    pub first: Option<u64>,
    /// At how many ticks it does.
    pub ticks: u64,
}

/// What is behind a difference.
#[derive(Clone, Default, Debug)]
pub(super) struct Behind {
    /// Which of the cones of its class: one in which nothing is wrong, if there is one.
    pub cone: usize,
    /// The classes in it that were wrong with the difference or, through state, before it.
    pub wrong: Vec<usize>,
}

/// What came of reading both.
#[derive(Debug)]
pub(super) struct Merged {
    /// For each class of [`Pairs`].
    pub tallies: Vec<Tally>,
    /// For each class, if causes were asked for, what is behind the first tick at which it differs.
    pub behind: Vec<Behind>,
    /// The ticks that were compared.
    pub span: Range<u64>,
    /// The ticks that each tells about.
    pub spans: [Range<u64>; 2],
    /// A time that does not fit into 64 bits of the finer unit: from there on nothing was compared.
    pub beyond: bool,
}

/// A source, its values, and its times in the finer unit.
struct Side<'a> {
    source: &'a mut dyn Source,
    state: State,
    factor: u64,
    /// The classes that a signal has to do with.
    classes: Vec<Vec<u32>>,
    beyond: bool,
}

impl<'a> Side<'a> {
    fn new(source: &'a mut dyn Source, unit: u64, pairs: &Pairs, side: usize) -> Self {
        let mut classes = vec![Vec::new(); source.declared().signals.len()];
        for (class, parts) in pairs.classes.iter().enumerate() {
            match &parts[side] {
                Parts::Whole(id) => classes[id.index()].push(class as u32),
                Parts::Bits(bits) => bits.iter().for_each(|id| classes[id.index()].push(class as u32)),
            }
        }
        let (state, factor) = (State::new(source.declared()), source.declared().unit / unit);
        Self { source, state, factor, classes, beyond: false }
    }

    /// The next time; none from one on that does not fit.
    fn time(&mut self) -> Option<u64> {
        let time = self.source.time()?.checked_mul(self.factor).filter(|&time| time < u64::MAX);
        self.beyond |= time.is_none();
        time
    }

    /// Takes the next values, and tells which classes they may change.
    fn advance(&mut self, judge: &mut Judge<'_, '_, '_>) -> Result<(), Report> {
        self.source.advance(&mut self.state)?;
        for id in self.state.touched() {
            self.classes[id.index()].iter().for_each(|&class| judge.touch(class));
        }
        self.state.settle();
        Ok(())
    }

    fn span(&self) -> Range<u64> {
        let span = self.source.span();
        span.start.saturating_mul(self.factor)..span.end.saturating_mul(self.factor)
    }
}

/// Reads both sources to their ends; with a window, or where only shared ticks count, as far as needed. With cones it
/// finds what is behind the first difference of every class.
///
/// # Errors
/// Those of the sources.
pub(super) fn merge(
    expected: &mut dyn Source,
    got: &mut dyn Source,
    pairs: &Pairs,
    how: &How,
    cones: Option<&mut Cones<'_>>,
) -> Result<Merged, Report> {
    let unit = expected.declared().unit.min(got.declared().unit);
    let mut sides = [Side::new(expected, unit, pairs, 0), Side::new(got, unit, pairs, 1)];
    let mut judge = Judge::new(pairs, how, cones);
    for side in &mut sides {
        side.advance(&mut judge)?;
    }
    let window = how.window.clone().unwrap_or(0..u64::MAX);
    let start = sides.iter().map(|side| side.span().start).fold(window.start, u64::max);
    let (mut reached, mut end) = (start, window.end);
    loop {
        let times = [sides[0].time(), sides[1].time()];
        for (side, time) in sides.iter().zip(times) {
            // When one is at its end, nothing can be compared behind it.
            end = match time {
                None if side.beyond => end.min(reached.saturating_add(1)),
                None => end.min(side.span().end),
                Some(_) => end,
            };
        }
        let next = times.into_iter().flatten().min();
        if reached < end && next.is_none_or(|next| next > start) {
            judge.look(&sides, reached);
        }
        let is_enough = how.signals == Signals::Shared || how.window.is_some();
        let Some(next) = next.filter(|&next| next < end || !is_enough) else { break };
        reached = reached.max(next);
        for (side, time) in sides.iter_mut().zip(times) {
            if time == Some(next) {
                side.advance(&mut judge)?;
            }
        }
    }
    let span = start..end.max(start);
    judge.close(span.end);
    let beyond = sides.iter().any(|side| side.beyond);
    Ok(Merged { tallies: judge.tallies, behind: judge.behind, span, spans: [sides[0].span(), sides[1].span()], beyond })
}

/// What differs at present, and what differed so far.
struct Judge<'a, 'c, 'd> {
    pairs: &'a Pairs,
    how: &'a How,
    cones: Option<&'c mut Cones<'d>>,
    tallies: Vec<Tally>,
    behind: Vec<Behind>,
    /// Classes of which a value may have changed since the last look, each once.
    touched: Vec<u32>,
    is_touched: Vec<bool>,
}

impl<'a, 'c, 'd> Judge<'a, 'c, 'd> {
    fn new(pairs: &'a Pairs, how: &'a How, cones: Option<&'c mut Cones<'d>>) -> Self {
        let count = pairs.classes.len();
        let (tallies, behind) = (vec![Tally::default(); count], vec![Behind::default(); count]);
        Self { pairs, how, cones, tallies, behind, touched: (0..count as u32).collect(), is_touched: vec![true; count] }
    }

    fn touch(&mut self, class: u32) {
        if !std::mem::replace(&mut self.is_touched[class as usize], true) {
            self.touched.push(class);
        }
    }

    /// Compares what has changed; the values are those from `now` on.
    fn look(&mut self, sides: &[Side<'_>; 2], now: u64) {
        let mut new = Vec::new();
        for class in std::mem::take(&mut self.touched) {
            let class = class as usize;
            self.is_touched[class] = false;
            let tally = &mut self.tallies[class];
            if self.how.is_same(&self.pairs.classes[class], [&sides[0].state, &sides[1].state]) {
                tally.commit(now, self.how.late);
            } else if tally.since.is_none() {
                tally.since = Some(now);
                new.extend(tally.first.is_none().then_some(class));
            }
        }
        let Some(cones) = &mut self.cones else { return };
        let tallies = &self.tallies;
        for class in new {
            let cones = cones.of(class);
            let behind = cones.iter().enumerate().map(|(cone, Cone { by, .. })| {
                let wrong = by.iter().filter(|(behind, delayed)| tallies[*behind].is_wrong(*delayed, now));
                Behind { cone, wrong: wrong.map(|(behind, _)| *behind).collect() }
            });
            self.behind[class] = behind.min_by_key(|behind| behind.wrong.len()).unwrap_or_default();
        }
    }

    fn close(&mut self, end: u64) {
        self.tallies.iter_mut().for_each(|tally| tally.commit(end, self.how.late));
    }
}

impl Tally {
    /// Whether it differs; with `before`, whether it has differed.
    fn is_wrong(&self, before: bool, now: u64) -> bool {
        match self.since {
            Some(since) if !before || since < now => true,
            _ => before && self.first.is_some(),
        }
    }

    /// Ends a difference; one of no more than `late` ticks is forgiven.
    fn commit(&mut self, end: u64, late: u64) {
        if let Some(since) = self.since.take()
            && end.saturating_sub(since) > late
        {
            self.first.get_or_insert(since);
            self.ticks += end - since;
        }
    }
}

impl How {
    fn is_same(&self, parts: &[Parts; 2], states: [&State; 2]) -> bool {
        if let ([Parts::Whole(a), Parts::Whole(b)], Unknown::Strict) = (parts, self.unknown)
            && (self.near == 0.0 || states[0].planes(*a) == states[1].planes(*b))
        {
            return states[0].planes(*a) == states[1].planes(*b);
        }
        let [a, b] = [parts[0].value(states[0]), parts[1].value(states[1])];
        match self.unknown {
            Unknown::Strict => {}
            Unknown::Wild if a.is_none() || b.is_none() => return true,
            Unknown::Wild => {}
            Unknown::Zero => {
                let zero = || Value::new(parts[0].kind(states[0]), parts[0].width(states[0]));
                let [a, b] = [a.unwrap_or_else(zero), b.unwrap_or_else(zero)].map(|value| value.with_zeros());
                return a.is_near(&b, self.near);
            }
        }
        match (a, b) {
            (Some(a), Some(b)) if self.unknown == Unknown::Wild => a.without(&b).is_near(&b.without(&a), self.near),
            (Some(a), Some(b)) => a.is_near(&b, self.near),
            (a, b) => a.is_none() && b.is_none(),
        }
    }
}

impl Parts {
    fn kind(&self, state: &State) -> Kind {
        match self {
            Parts::Whole(id) => state.signal(*id).kind,
            Parts::Bits(_) => Kind::Bits,
        }
    }

    fn width(&self, state: &State) -> u32 {
        match self {
            Parts::Whole(id) => state.signal(*id).width,
            Parts::Bits(bits) => bits.len() as u32,
        }
    }

    /// The value; `None` before the first one of any part.
    fn value(&self, state: &State) -> Option<Value> {
        self.put_together(|id| {
            let (bits, unknown) = state.planes(id)?;
            Some(Value::of(state.signal(id).kind, state.signal(id).width, bits, unknown))
        })
    }

    /// The value out of those of its signals.
    pub(super) fn put_together(&self, value: impl Fn(SignalId) -> Option<Value>) -> Option<Value> {
        match self {
            Parts::Whole(id) => value(*id),
            Parts::Bits(bits) => {
                let mut whole = Value::new(Kind::Bits, bits.len() as u32);
                for (at, id) in (0..).zip(bits) {
                    whole.set_bit(at, value(*id)?.bit(0));
                }
                Some(whole)
            }
        }
    }
}
