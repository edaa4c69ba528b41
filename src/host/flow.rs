//! The flow chart of FIG. 19 as a state machine: its state is the operation that was done last.

use super::{Carry, Case, CaseTwo, Chain, Curve, Entry, Note, Point, Refusal, Section, Step};

/// A direction that turns by less, in degrees, goes on straight; one that turns by as little less than a half turn goes
/// straight back. Rounding in `f64` turns by some 1e-12.
const STRAIGHT: f64 = 1e-6;

/// A chain on its way through FIG. 19: gives each operation when it is done, and ends after 602.
#[derive(Clone, Debug)]
pub struct Flow<'c> {
    chain: &'c Chain,
    last: Option<Step>,
    /// How many entries have been read, and how many points.
    entries: usize,
    points: usize,
    p0: Point,
    s0: f64,
    /// The number of P0 among the points.
    number: usize,
    /// The direction in which the section before has arrived.
    arrived: Option<[f64; 2]>,
}

impl<'c> Flow<'c> {
    pub(super) fn of(chain: &'c Chain) -> Self {
        Self { chain, last: None, entries: 0, points: 1, p0: chain.p0, s0: chain.s0, number: 1, arrived: None }
    }

    /// The arrows of the figure.
    fn after(&mut self, last: Option<Step>) -> Option<Step> {
        Some(match last {
            None => Step::Initialise,
            Some(Step::Initialise) => Step::Read { p0: self.p0, s0: self.s0, entry: self.read() },
            Some(Step::Read { entry, .. } | Step::Count(entry)) => self.begin(entry),
            Some(Step::Compute(two)) => Step::Test(two),
            Some(Step::Test(two)) if two.is_good() => Step::Parameters(two),
            Some(Step::Test(two)) => self.cancel(two.refusal()),
            Some(Step::Parameters(two)) => self.format(2, two.curve(), two.p1),
            Some(Step::Format(Ok(section))) => self.send(section),
            Some(Step::Format(Err(refusal)) | Step::CaseOne { curve: Err(refusal), .. }) => self.cancel(refusal),
            Some(Step::Send { section, .. }) => Step::Display(section),
            Some(Step::Display(section)) => self.carry(section),
            Some(Step::Carry(_) | Step::Cancel(_)) => Step::Accept(self.read()),
            Some(Step::Accept(entry)) => Step::Count(entry),
            Some(Step::ReadSlope { p1, s1 }) => {
                Step::CaseOne { p1, curve: Case::I { s0: self.s0, s1 }.curve(self.p0, p1) }
            }
            Some(Step::CaseOne { p1, curve: Ok(curve) }) => self.format(1, curve, p1),
            Some(Step::End) => return None,
        })
    }

    fn read(&mut self) -> Option<Entry> {
        let entry = self.chain.entries.get(self.entries).copied()?;
        self.entries += 1;
        self.points += entry.points();
        Some(entry)
    }

    /// The ways out of 600.
    fn begin(&self, entry: Option<Entry>) -> Step {
        match entry {
            Some(Entry::Two { p3, p1 }) => Step::Compute(CaseTwo::of(self.p0, p1, p3, self.s0)),
            Some(Entry::One { p1, s1 }) => Step::ReadSlope { p1, s1 },
            None => Step::End,
        }
    }

    fn format(&self, case: u8, curve: Curve, to: Point) -> Step {
        let [j, k, l, m] = curve.jklm;
        let s1 = match self.chain.carry {
            Carry::EndSlope => l / j,
            Carry::AsPrinted => m / k,
        };
        Step::Format(curve.words().map(|stroke| Section { case, s0: self.s0, curve, stroke, to, s1 }))
    }

    fn send(&mut self, section: Section) -> Step {
        let note = self.arrived.and_then(|arrived| self.turn(arrived, section.curve.leaves()));
        self.arrived = Some(section.curve.arrives());
        Step::Send { section, note }
    }

    /// What is to be told when the direction turns at P0.
    fn turn(&self, arrived: [f64; 2], leaves: [f64; 2]) -> Option<Note> {
        let [[ax, ay], [bx, by]] = [arrived, leaves];
        let degrees = (ax * by - ay * bx).atan2(ax * bx + ay * by).abs().to_degrees();
        let point = self.number;
        match degrees {
            ..STRAIGHT => None,
            _ if degrees > 180.0 - STRAIGHT => Some(Note::Cusp { point }),
            _ => Some(Note::Corner { point, degrees }),
        }
    }

    fn carry(&mut self, section: Section) -> Step {
        (self.p0, self.s0, self.number) = (section.to, section.s1, self.points);
        Step::Carry(section)
    }

    /// 610 takes back what was read last.
    fn cancel(&self, refusal: Refusal) -> Step {
        let read = self.chain.entries[self.entries - 1].points();
        Step::Cancel(Note::Cancelled { points: self.points + 1 - read..=self.points, refusal })
    }
}

impl Iterator for Flow<'_> {
    type Item = Step;

    fn next(&mut self) -> Option<Step> {
        let last = self.last.take();
        self.last = self.after(last);
        self.last.clone()
    }
}
