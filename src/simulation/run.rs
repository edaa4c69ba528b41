//! A run: a circuit that stands at a tick, and whoever looks at it.

use std::ops::Range;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use bitvec::{order::Lsb0, vec::BitVec, view::BitView};

use super::pace::Pace;
use super::{Design, EngineKind, Outcome, Output};
use crate::base::{Diagnostic, Port, Report, Signal, Stimulus, StopRule, StoppedBy, ValueId, word};
use crate::compile::Program;
use crate::engine::{Engine, Stats};
use crate::scenario::Number;
use crate::trace::{Frame, Observer, Select};

/// An input of a run, found by name once.
#[derive(Clone, Copy, Debug)]
pub struct Input(usize);

impl Input {
    /// The input of a name among the ports of a program.
    pub(super) fn find(ports: &[Port], name: &str) -> Result<Self, Report> {
        let found = ports.iter().position(|port| port.name == name);
        found.map(Self).ok_or_else(|| {
            let names = ports.iter().map(|port| port.name.as_str());
            Diagnostic::new("S010", format!("the circuit has no input `{name}`")).nearest(name, names).into()
        })
    }

    /// Its place among the inputs.
    #[must_use]
    pub fn place(self) -> usize {
        self.0
    }
}

/// A net, port or named value inside a block, found by name once.
#[derive(Clone, Copy, Debug)]
pub struct Net {
    value: ValueId,
    width: u32,
    signed: bool,
    fraction: Option<u32>,
}

/// A circuit that stands at a tick, with every net settled and readable.
///
/// ```
/// use stepwright::simulation::Circuit;
///
/// let mut run = Circuit::shipped("su1522157/interpolator")?.session().parameter("MINUS_ZERO", 1).start()?;
/// let (start, busy) = (run.input("start_33")?, run.net("busy")?);
/// for (name, value) in [("major_32", 7), ("minor_34", 3)] {
///     let input = run.input(name)?;
///     run.set(input, value)?;
/// }
/// run.set(start, 1)?;
/// run.step(1);
/// run.set(start, 0)?;
/// assert_eq!((run.tick(), run.read(busy)), (1, 1));
/// # Ok::<(), stepwright::base::Report>(())
/// ```
pub struct Run<'o> {
    program: Arc<Program>,
    engine: Box<dyn Engine>,
    stimulus: Stimulus,
    /// The first tick in which the stop condition is judged.
    judged_from: u64,
    /// How many of the stimulus's changes have happened.
    changed: usize,
    tick: u64,
    watchers: Vec<Watcher<'o>>,
    /// What all watchers look at, one after the other.
    values: Vec<ValueId>,
    words: Vec<u64>,
    before: Vec<u64>,
    /// The first error of a watcher; the run does not go on.
    failed: Option<Report>,
    cancel: Option<&'o AtomicBool>,
    pace: Pace,
}

struct Watcher<'o> {
    observer: Box<dyn Observer + 'o>,
    place: Range<usize>,
    has_begun: bool,
}

impl Design {
    /// A run at tick 0 in which the signals of `observed` can be read by name, besides the outputs.
    ///
    /// # Errors
    /// `W002` when a glob matches no signal, `E001` when there is no such engine here.
    pub fn start(&self, observed: &Select) -> Result<Run<'static>, Report> {
        let program = self.compile(&|name| observed.matches(name));
        if !observed.is_all() && observed.of(&program.signals).is_err() {
            observed.of(&self.all_signals())?;
        }
        Run::new(self, program)
    }

    /// A run at tick 0 that these look at, and in which just what they look at can be read by name, besides the
    /// outputs.
    ///
    /// # Errors
    /// Those of [`Observer::begin`]; `E001` when there is no such engine here.
    pub fn start_with<'o>(&self, observers: Vec<Box<dyn Observer + 'o>>) -> Result<Run<'o>, Report> {
        let mut run = Run::new(self, self.compile(&|name| observers.iter().any(|observer| observer.wants(name))))?;
        for mut observer in observers {
            match observer.begin(&run.program.signals) {
                Ok(values) => run.add(observer, &values),
                // A name that is near to a wrong one may be any signal's.
                Err(report) => return Err(observer.begin(&self.all_signals()).err().unwrap_or(report)),
            }
        }
        Ok(run)
    }
}

impl<'o> Run<'o> {
    fn new(design: &Design, program: Arc<Program>) -> Result<Self, Report> {
        Self::of(program, design.stimulus().clone(), design.engine())
    }

    pub(super) fn of(program: Arc<Program>, stimulus: Stimulus, engine: EngineKind) -> Result<Self, Report> {
        let mut engine = engine.build(Arc::clone(&program), stimulus.last_tick().0.saturating_add(1))?;
        for (input, &word) in stimulus.initial.iter().enumerate() {
            engine.set_input(input, word);
        }
        let mut run = Self {
            program,
            engine,
            judged_from: stimulus.first_judged_tick(),
            stimulus,
            changed: 0,
            tick: 0,
            watchers: Vec::new(),
            values: Vec::new(),
            words: Vec::new(),
            before: Vec::new(),
            failed: None,
            cancel: None,
            pace: Pace::default(),
        };
        run.change();
        run.engine.settle();
        Ok(run)
    }

    /// Breaks the run off, soon, when `cancel` becomes true.
    #[must_use]
    pub fn cancelled_by(self, cancel: &'o AtomicBool) -> Self {
        Self { cancel: Some(cancel), ..self }
    }

    /// Lets `observer` look at every tick from the present one on. It finds all signals that the run was started with.
    ///
    /// # Errors
    /// Those of [`Observer::begin`].
    pub fn record(&mut self, observer: impl Observer + 'o) -> Result<(), Report> {
        let mut observer = Box::new(observer);
        let values = observer.begin(&self.program.signals)?;
        self.add(observer, &values);
        Ok(())
    }

    pub(super) fn add(&mut self, observer: Box<dyn Observer + 'o>, values: &[ValueId]) {
        let first = self.values.len();
        self.values.extend_from_slice(values);
        self.engine.watch(&self.values);
        self.words.resize(self.values.len(), 0);
        self.before.resize(self.values.len(), 0);
        self.watchers.push(Watcher { observer, place: first..self.values.len(), has_begun: false });
    }

    /// The present tick.
    #[must_use]
    pub fn tick(&self) -> u64 {
        self.tick
    }

    /// The engine that runs it.
    #[must_use]
    pub fn engine(&self) -> &'static str {
        self.engine.name()
    }

    /// What the engine's specialised code runs, where there is any.
    #[must_use]
    pub fn stats(&self) -> Option<&Stats> {
        self.engine.stats()
    }

    /// The signals that can be read by name.
    #[must_use]
    pub fn signals(&self) -> &[Signal] {
        &self.program.signals
    }

    /// The input of a name.
    ///
    /// # Errors
    /// `S010` the circuit has no such input.
    pub fn input(&self, name: &str) -> Result<Input, Report> {
        Input::find(&self.program.inputs, name)
    }

    /// The net, port or named value inside a block, of a dotted name below the top module.
    ///
    /// # Errors
    /// `S012` there is no such net, or the run was started without sight of it.
    pub fn net(&self, name: &str) -> Result<Net, Report> {
        let is_signal = |signal: &&Signal| signal.path[1..].iter().map(String::as_str).eq(name.split('.'));
        let signal = self.program.signals.iter().find(is_signal);
        let signal = signal.map(|s| Net { value: s.value, width: s.width, signed: s.signed, fraction: s.fraction });
        let port = || self.program.outputs.iter().find(|port| port.name == name);
        let port = || port().map(|p| Net { value: p.value, width: p.width, signed: p.signed, fraction: p.fraction });
        signal.or_else(port).ok_or_else(|| {
            let names: Vec<_> = self.program.signals.iter().map(Signal::name).collect();
            let diagnostic = Diagnostic::new("S012", format!("there is no net `{name}`"));
            diagnostic.nearest(name, names.iter().map(String::as_str)).into()
        })
    }

    /// Sets an input from this tick on; a real number on a fixed-point port through [`Number::Real`].
    ///
    /// # Errors
    /// `S011` the number does not fit.
    pub fn set(&mut self, input: Input, value: impl Into<Number>) -> Result<(), Report> {
        let Port { name, width, signed, fraction, .. } = &self.program.inputs[input.0];
        let word = value.into().encode(*width, *signed, *fraction);
        let word = word.map_err(|error| Diagnostic::new("S011", format!("input `{name}`: {error}")))?;
        self.engine.set_input(input.0, word);
        self.engine.settle();
        Ok(())
    }

    /// Width in bits, whether signed, and fraction bits of a net.
    pub(super) fn shape(&self, net: Net) -> (u32, bool, Option<u32>) {
        (net.width, net.signed, net.fraction)
    }

    /// The number on a net, signed where it is.
    #[must_use]
    pub fn read(&self, net: Net) -> i128 {
        word::decode(self.word(net), net.width, net.signed)
    }

    /// The word on a net.
    #[must_use]
    pub fn word(&self, net: Net) -> u64 {
        self.engine.value(net.value)
    }

    /// The bits on a net, least significant first: contents of registers and delay chains.
    #[must_use]
    pub fn bits(&self, net: Net) -> BitVec<u64, Lsb0> {
        self.word(net).view_bits::<Lsb0>()[..net.width as usize].to_bitvec()
    }

    /// Goes on by so many ticks, inputs changing as the scenario says. An error of whoever looks is kept for
    /// [`Run::finish`].
    pub fn step(&mut self, ticks: u64) {
        self.go(self.tick.saturating_add(ticks), false);
    }

    /// Steps until a net is not 0, at least once and at most `limit` times; whether it came.
    pub fn until(&mut self, net: Net, limit: u64) -> bool {
        (0..limit).any(|_| {
            self.step(1);
            self.word(net) != 0
        })
    }

    /// Runs to where the scenario stops, and ends all recordings with that tick.
    ///
    /// # Errors
    /// The first error of whoever looked on.
    pub fn finish(&mut self) -> Result<Outcome, Report> {
        let (last, mut stopped_by) = self.stimulus.last_tick();
        let waits = matches!(self.stimulus.stop, StopRule::Until { .. });
        self.go(self.judged_from.min(last), false);
        if !(waits && self.stops_now()) {
            self.go(last, waits);
        }
        if waits && self.stops_now() {
            stopped_by = StoppedBy::Until;
        } else if self.is_cancelled() && self.tick < last {
            stopped_by = StoppedBy::Interrupt;
        }
        self.end_recording()?;
        Ok(self.outcome(stopped_by))
    }

    /// Ends all recordings with the present tick. Without any, nothing happens.
    ///
    /// # Errors
    /// The first error of whoever looked on.
    pub fn end_recording(&mut self) -> Result<(), Report> {
        self.observe();
        for mut watcher in std::mem::take(&mut self.watchers) {
            if self.failed.is_none() {
                self.failed = watcher.observer.end().err();
            }
        }
        self.values.clear();
        self.failed.take().map_or(Ok(()), Err)
    }

    /// On to tick `to`, or with `until_stop` to the tick in which the scenario stops.
    fn go(&mut self, to: u64, until_stop: bool) {
        while self.tick < to && !self.is_cancelled() {
            self.observe();
            if self.failed.is_some() {
                return;
            }
            let next_change = self.stimulus.changes.get(self.changed).map_or(to, |change| change.tick.min(to));
            let free = if self.watchers.is_empty() { next_change - self.tick } else { 1 };
            let most = if self.cancel.is_some() && free > 1 { self.pace.next() } else { u64::MAX };
            self.tick += self.engine.advance(free.min(most), until_stop);
            self.change();
            if until_stop && self.stops_now() {
                break;
            }
        }
    }

    /// Lets the changes of this tick happen.
    fn change(&mut self) {
        let due = self.stimulus.changes[self.changed..].iter().take_while(|change| change.tick <= self.tick);
        let due = due.copied().collect::<Vec<_>>();
        if due.is_empty() {
            return;
        }
        for change in &due {
            self.engine.set_input(change.input, change.word);
        }
        self.changed += due.len();
        self.engine.settle();
    }

    /// Shows the present tick to whoever looks.
    fn observe(&mut self) {
        if self.watchers.is_empty() || self.failed.is_some() {
            return;
        }
        std::mem::swap(&mut self.words, &mut self.before);
        self.engine.read(&mut self.words);
        for watcher in &mut self.watchers {
            let has_begun = std::mem::replace(&mut watcher.has_begun, true);
            let before = has_begun.then(|| &self.before[watcher.place.clone()]);
            let frame = Frame { tick: self.tick, words: &self.words[watcher.place.clone()], before };
            if let Err(report) = watcher.observer.tick(frame) {
                self.failed = Some(report);
                return;
            }
        }
    }

    fn is_cancelled(&self) -> bool {
        self.cancel.is_some_and(|cancel| cancel.load(Ordering::Relaxed))
    }

    fn stops_now(&self) -> bool {
        self.tick >= self.judged_from && self.program.stop.is_some_and(|stop| self.engine.value(stop) != 0)
    }

    fn outcome(&self, stopped_by: StoppedBy) -> Outcome {
        let pulses = self.program.pulses.iter().copied().zip(self.engine.pulses()).collect::<Vec<_>>();
        let outputs = self.program.outputs.iter().enumerate().map(|(i, port)| Output {
            port: port.clone(),
            word: self.engine.value(port.value),
            pulses: pulses.iter().find(|(output, _)| *output == i).map(|(_, pulses)| *pulses),
        });
        Outcome { ticks: self.tick + 1, stopped_by, outputs: outputs.collect() }
    }
}
