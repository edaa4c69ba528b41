//! A waveform in memory: named signals and their values over time.

use std::collections::HashMap;
use std::ops::Range;

use super::Track;
use super::declared::{Declared, Name, SignalId};
use super::source::Source;
use super::state::State;
use crate::base::{Diagnostic, Report};

/// How many bytes of values are kept.
const MOST_BYTES: usize = 256 << 20;

/// Signals by dotted path, and what they were when.
#[derive(Clone, Debug)]
pub struct Waveform {
    declared: Declared,
    by_name: HashMap<String, SignalId>,
    tracks: Vec<Track>,
    span: Range<u64>,
    is_closed: bool,
}

impl Waveform {
    /// Reads the values of a source within `window`: each signal's first value there is the one it has at its start.
    ///
    /// # Errors
    /// Those of the source, and `W019` when the values take more than 256 MiB.
    pub(super) fn gather(name: &str, source: &mut dyn Source, window: &Range<u64>) -> Result<Self, Report> {
        let declared = source.declared().clone();
        let mut state = State::new(&declared);
        let mut tracks: Vec<_> = declared.signals.iter().map(|signal| Track::new(signal.kind, signal.width)).collect();
        let mut bytes = 0;
        while let Some(time) = source.time().filter(|&time| time < window.end) {
            source.advance(&mut state)?;
            if source.time().is_some_and(|next| next <= window.start) {
                // What is touched stays so until the window begins.
                continue;
            }
            for id in state.touched() {
                let Some((bits, unknown)) = state.planes(id).filter(|(bits, _)| !bits.is_empty()) else { continue };
                let track = &mut tracks[id.index()];
                bytes -= track.bytes();
                track.push(time.max(window.start), bits, unknown);
                bytes += track.bytes();
            }
            state.settle();
            if bytes > MOST_BYTES {
                let message = format!("{name}: its values take more than {} MiB of memory", MOST_BYTES >> 20);
                return Err(Diagnostic::new("W019", message).help("trace less, or fewer ticks").into());
            }
        }
        let told = source.span();
        let start = told.start.max(window.start);
        let span = start..told.end.min(window.end).max(start);
        Ok(Self { by_name: index(&declared.names), declared, tracks, span, is_closed: source.is_closed() })
    }

    pub(super) fn declared(&self) -> &Declared {
        &self.declared
    }

    /// The signals' names in the order of the file.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.declared.names.iter().map(|name| name.path.as_str())
    }

    /// A signal's values; `None` also for texts and events, whose values are not kept.
    #[must_use]
    pub fn track(&self, name: &str) -> Option<&Track> {
        let track = self.by_name.get(name).map(|&id| self.track_of(id));
        track.filter(|track| track.width() > 0)
    }

    pub(super) fn track_of(&self, id: SignalId) -> &Track {
        &self.tracks[id.index()]
    }

    /// The times that the waveform tells about.
    #[must_use]
    pub fn span(&self) -> Range<u64> {
        self.span.clone()
    }

    /// Femtoseconds that one unit of time stands for; 1,000,000 in a waveform of ours, whose unit is the tick.
    #[must_use]
    pub fn unit(&self) -> u64 {
        self.declared.unit
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
        let mut taken = HashMap::new();
        let mut names = Vec::new();
        for old in &self.declared.names {
            if let Some(path) = rename(&old.path).filter(|path| !taken.contains_key(path)) {
                taken.insert(path.clone(), old.signal);
                names.push(Name { path, ..old.clone() });
            }
        }
        Self { declared: Declared { names, ..self.declared.clone() }, by_name: taken, ..self.clone() }
    }

    /// The values at `first`, `first + period`, ..., as ticks 0, 1, ...: the waveform of a bench that clocks the
    /// circuit every `period` (at least 1) units of time, seen at the sample points. The unit becomes the tick.
    #[must_use]
    pub fn sampled(&self, first: u64, period: u64) -> Self {
        let period = period.max(1);
        // A change is seen at the first sample point that is not before it.
        self.retimed(1_000_000, |time| time.saturating_sub(first).div_ceil(period))
    }

    /// The same waveform in a finer unit, `factor` of which make the present one.
    pub(super) fn finer(&self, factor: u64) -> Self {
        self.retimed(self.unit() / factor, |time| time.saturating_mul(factor))
    }

    fn retimed(&self, unit: u64, map: impl Fn(u64) -> u64) -> Self {
        let tracks = self.tracks.iter().map(|track| track.retimed(&map)).collect();
        let span = map(self.span.start)..map(self.span.end);
        Self { declared: Declared { unit, ..self.declared.clone() }, tracks, span, ..self.clone() }
    }

    /// The same waveform as something that is read time by time.
    pub(super) fn replay(&self) -> Replay<'_> {
        let mut changes = Vec::new();
        for (index, track) in self.tracks.iter().enumerate() {
            changes.extend(track.times().iter().enumerate().map(|(change, &time)| (time, index, change)));
        }
        changes.sort_unstable();
        Replay { wave: self, changes, next: 0, is_done: false }
    }
}

fn index(names: &[Name]) -> HashMap<String, SignalId> {
    names.iter().map(|name| (name.path.clone(), name.signal)).collect()
}

/// A waveform in memory that is read once more.
pub(super) struct Replay<'a> {
    wave: &'a Waveform,
    /// Time, signal, and which of its changes.
    changes: Vec<(u64, usize, usize)>,
    next: usize,
    /// Whether the start of the span has been told, which may have no changes.
    is_done: bool,
}

impl Source for Replay<'_> {
    fn declared(&self) -> &Declared {
        &self.wave.declared
    }

    fn time(&self) -> Option<u64> {
        match self.changes.get(self.next) {
            Some((time, ..)) => Some(*time),
            None => (!self.is_done).then_some(self.wave.span.end),
        }
    }

    fn advance(&mut self, state: &mut State) -> Result<(), Report> {
        let Some(&(now, ..)) = self.changes.get(self.next) else {
            self.is_done = true;
            return Ok(());
        };
        while let Some(&(_, index, change)) = self.changes.get(self.next).filter(|(time, ..)| *time == now) {
            let (bits, unknown) = state.touch(SignalId::new(index));
            self.wave.tracks[index].write(change, bits, unknown);
            self.next += 1;
        }
        Ok(())
    }

    fn span(&self) -> Range<u64> {
        self.wave.span()
    }

    fn is_closed(&self) -> bool {
        self.wave.is_closed
    }
}
