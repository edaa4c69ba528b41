//! A waveform: named signals and their values over time.

use std::collections::HashMap;
use std::ops::Range;

use super::Track;

crate::define_id!(
    /// A track of a waveform; aliases share one.
    TrackId
);

/// Signals by dotted path, and what they were when.
#[derive(Clone, Debug, Default)]
pub struct Waveform {
    /// Names in the order of the file.
    names: Vec<String>,
    signals: HashMap<String, TrackId>,
    tracks: Vec<Track>,
    span: Range<u64>,
    /// Femtoseconds that one unit of time stands for.
    unit: u64,
    is_closed: bool,
}

impl Waveform {
    pub(super) fn new(tracks: Vec<Track>, span: Range<u64>, unit: u64, is_closed: bool) -> Self {
        Self { tracks, span, unit, is_closed, ..Self::default() }
    }

    /// Names a track, unless the name is taken.
    pub(super) fn name(&mut self, name: String, track: TrackId) {
        if !self.signals.contains_key(&name) {
            self.names.push(name.clone());
            self.signals.insert(name, track);
        }
    }

    /// The signals' names in the order of the file.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.names.iter().map(String::as_str)
    }

    /// A signal's values.
    #[must_use]
    pub fn track(&self, name: &str) -> Option<&Track> {
        self.signals.get(name).map(|id| &self.tracks[id.index()])
    }

    pub(super) fn track_id(&self, name: &str) -> Option<TrackId> {
        self.signals.get(name).copied()
    }

    /// The times that the waveform tells about.
    #[must_use]
    pub fn span(&self) -> Range<u64> {
        self.span.clone()
    }

    /// Femtoseconds that one unit of time stands for; 1,000,000 in a waveform of ours, whose unit is the tick.
    #[must_use]
    pub fn unit(&self) -> u64 {
        self.unit
    }

    /// Whether the file ends with a time at which nothing changes, as ours do: one that was cut off between two
    /// lines mostly does not.
    #[must_use]
    pub fn is_closed(&self) -> bool {
        self.is_closed
    }

    /// The outermost scope, when there is just one.
    #[must_use]
    pub fn top(&self) -> Option<&str> {
        let mut scopes = self.names().map(|name| name.split_once('.').map(|(top, _)| top));
        let top = scopes.next()??;
        scopes.all(|other| other == Some(top)).then_some(top)
    }

    /// The signals below a scope such as `bench.dut`, named from there.
    #[must_use]
    pub fn below(&self, scope: &str) -> Self {
        self.renamed(|name| name.strip_prefix(scope)?.strip_prefix('.').map(str::to_owned))
    }

    /// The same signals under other names; without those for which there is no name, or one that is taken.
    #[must_use]
    pub fn renamed(&self, rename: impl Fn(&str) -> Option<String>) -> Self {
        let mut wave = Self { names: Vec::new(), signals: HashMap::new(), ..self.clone() };
        for old in &self.names {
            if let Some(new) = rename(old) {
                wave.name(new, self.signals[old]);
            }
        }
        wave
    }

    /// The values at `first`, `first + period`, ..., as ticks 0, 1, ...: the waveform of a bench that clocks the
    /// circuit every `period` (at least 1) units of time, seen at the sample points. The unit becomes the tick.
    #[must_use]
    pub fn sampled(&self, first: u64, period: u64) -> Self {
        let period = period.max(1);
        // A change is seen at the first sample point that is not before it.
        let tick = |time: u64| time.saturating_sub(first).div_ceil(period);
        let tracks = self.tracks.iter().map(|track| track.retimed(tick)).collect();
        let span = tick(self.span.start)..tick(self.span.end);
        Self { tracks, span, unit: 1_000_000, ..self.clone() }
    }

    /// The same waveform in a finer unit; `unit` must divide the present one.
    pub(super) fn in_unit(&self, unit: u64) -> Self {
        let factor = self.unit / unit;
        let tracks = self.tracks.iter().map(|track| track.retimed(|time| time.saturating_mul(factor))).collect();
        let span = self.span.start.saturating_mul(factor)..self.span.end.saturating_mul(factor);
        Self { tracks, span, unit, ..self.clone() }
    }
}
