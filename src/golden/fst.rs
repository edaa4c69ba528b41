//! Reading FST, time by time: the crate that decodes it runs in a thread of its own, which hands the values over in
//! batches and in which a panic on a broken file ends.

use std::io::{BufRead, Seek};
use std::ops::Range;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::mpsc::{Receiver, SyncSender, sync_channel};

use fst_reader::{FstFilter, FstHierarchyEntry, FstReader, FstSignalValue, FstVarType};

use super::declared::{Declared, Declaring, Kind, Signal, SignalId};
use super::fst_blocks::{self, MOST_SIGNALS};
use super::source::Source;
use super::state::State;
use crate::base::{Diagnostic, Report};

/// How many bytes of digits a batch holds before it is handed over.
const BATCH: usize = 1 << 16;

/// How many values, at most.
const BATCH_VALUES: usize = 1 << 12;

/// Some values in the order of time.
#[derive(Default)]
struct Batch {
    /// Time, handle, and where the digits end.
    values: Vec<(u64, usize, usize)>,
    /// Digits; the eight bytes of a real.
    digits: Vec<u8>,
}

/// An FST file of which the declarations have been read.
pub(super) struct FstSource {
    name: String,
    declared: Declared,
    /// The signal of each handle, if it has one.
    handles: Vec<Option<SignalId>>,
    batches: Receiver<Result<Batch, Diagnostic>>,
    batch: Batch,
    next: usize,
    start: u64,
    end: u64,
    time: Option<u64>,
    last: u64,
    changed: bool,
}

impl FstSource {
    /// Reads the declarations; `name` is what messages call the file.
    ///
    /// # Errors
    /// `W012`, `W015`, `W016`, `W019`, `W020`, as [`super::read()`].
    pub fn open(name: &str, mut input: impl BufRead + Seek + Send + 'static) -> Result<Self, Report> {
        let called = name.to_owned();
        fst_blocks::check(&mut input).map_err(|why| broken(name, &why))?;
        let mut opened = guarded(name, || FstReader::open(input).map_err(|error| broken(&called, &error)))?;
        let (declared, handles) = guarded(name, || declared(&called, &mut opened))?;
        let header = opened.get_header();
        let (sender, batches) = sync_channel(4);
        std::thread::spawn(move || {
            if let Err(diagnostic) = guarded(&called, || decode(&called, &mut opened, &sender)) {
                // Nobody may be waiting any more.
                let _ = sender.send(Err(diagnostic));
            }
        });
        let (start, end) = (header.start_time, header.end_time.min(u64::MAX - 1));
        let mut source = Self {
            name: name.to_owned(),
            declared,
            handles,
            batches,
            batch: Batch::default(),
            next: 0,
            start,
            end,
            time: Some(start),
            last: start,
            changed: false,
        };
        // Writers may state 0 for a dump that begins later; as in VCD it begins with its first value.
        source.start = source.peek()?.unwrap_or(start);
        source.time = Some(source.start);
        Ok(source)
    }

    /// The time of the next value, from the next batch if need be.
    fn peek(&mut self) -> Result<Option<u64>, Report> {
        while self.next == self.batch.values.len() {
            match self.batches.recv() {
                Ok(batch) => (self.batch, self.next) = (batch?, 0),
                Err(_) => return Ok(None),
            }
        }
        Ok(Some(self.batch.values[self.next].0))
    }

    /// Puts the next value into the state.
    fn value(&mut self, state: &mut State) -> Result<(), Report> {
        let (_, handle, end) = self.batch.values[self.next];
        let start = self.next.checked_sub(1).map_or(0, |before| self.batch.values[before].2);
        let digits = &self.batch.digits[start..end];
        self.next += 1;
        let Some(id) = self.handles.get(handle).copied().flatten() else { return Ok(()) };
        self.changed = true;
        let set = match self.declared.signals[id.index()].kind {
            Kind::Bits => state.set_digits(id, digits),
            Kind::Real => digits.try_into().ok().and_then(|bytes| state.set_real(id, f64::from_le_bytes(bytes))),
            Kind::Other => Some(()),
        };
        set.ok_or_else(|| broken(&self.name, &"a value that does not fit its signal").into())
    }
}

impl Source for FstSource {
    fn declared(&self) -> &Declared {
        &self.declared
    }

    fn time(&self) -> Option<u64> {
        self.time
    }

    fn advance(&mut self, state: &mut State) -> Result<(), Report> {
        let Some(now) = self.time else { return Ok(()) };
        (self.last, self.changed) = (now, false);
        let mut next = self.peek()?;
        while next == Some(now) {
            self.value(state)?;
            next = self.peek()?;
        }
        if next.is_some_and(|next| next < now || next == u64::MAX) {
            return Err(broken(&self.name, &"its times do not increase").into());
        }
        // The end is told like any time, though nothing may change at it.
        self.time = next.or((self.end > now).then_some(self.end));
        Ok(())
    }

    fn span(&self) -> Range<u64> {
        let end = if self.changed { self.last + 1 } else { self.last };
        self.start.min(end)..end
    }

    fn is_closed(&self) -> bool {
        !self.changed
    }
}

fn broken(name: &str, why: &dyn std::fmt::Display) -> Diagnostic {
    Diagnostic::new("W020", format!("{name}: this FST file is broken: {why}"))
        .help("write it again; if another tool reads it, convert it with fst2vcd")
}

/// The one place at which a panic of the decoder ends.
fn guarded<T>(name: &str, work: impl FnOnce() -> Result<T, Diagnostic>) -> Result<T, Diagnostic> {
    catch_unwind(AssertUnwindSafe(work)).unwrap_or_else(|_| Err(broken(name, &"it cannot be decoded")))
}

type Handles = Vec<Option<SignalId>>;

fn declared<R: BufRead + Seek>(name: &str, reader: &mut FstReader<R>) -> Result<(Declared, Handles), Diagnostic> {
    let mut declaring = Declaring::default();
    let exponent = i32::from(reader.get_header().timescale_exponent);
    let power = u32::try_from(exponent + 15).ok().filter(|&power| power <= 17);
    declaring.unit(10u64.pow(power.ok_or_else(|| broken(name, &"its timescale is not one of 1 fs to 100 s"))?));
    let (mut handles, mut wrong) = (Handles::new(), None);
    let read = reader.read_hierarchy(|entry| {
        if wrong.is_none() {
            wrong = declare(&mut declaring, &mut handles, entry).err();
        }
    });
    if let Some(mut diagnostic) = wrong {
        diagnostic.message = format!("{name}: {}", diagnostic.message);
        return Err(diagnostic);
    }
    read.map_err(|error| broken(name, &error))?;
    Ok((declaring.finish(), handles))
}

fn declare(declaring: &mut Declaring, handles: &mut Handles, entry: FstHierarchyEntry) -> Result<(), Diagnostic> {
    match entry {
        FstHierarchyEntry::Scope { name, .. } => declaring.scope(&name),
        FstHierarchyEntry::UpScope => declaring.upscope(),
        FstHierarchyEntry::Var { tpe, name, length, handle, .. } => {
            let signal = match tpe {
                FstVarType::Event | FstVarType::GenericString => Signal { kind: Kind::Other, width: 0 },
                _ if tpe.is_real() => Signal { kind: Kind::Real, width: 64 },
                _ => Signal { kind: Kind::Bits, width: length },
            };
            let alias = handles.get(handle.get_index()).copied().flatten();
            let id = declaring.variable(signal, alias, &name)?;
            if handle.get_index() as u64 >= MOST_SIGNALS {
                return Err(Diagnostic::new("W020", format!("`{name}` stands for a signal that no file has room for")));
            }
            handles.resize(handles.len().max(handle.get_index() + 1), None);
            handles[handle.get_index()] = Some(id);
            Ok(())
        }
        _ => Ok(()),
    }
}

/// Decodes all values; ends early when nobody waits for them any more.
fn decode<R: BufRead + Seek>(
    name: &str,
    reader: &mut FstReader<R>,
    sender: &SyncSender<Result<Batch, Diagnostic>>,
) -> Result<(), Diagnostic> {
    let (mut batch, start) = (Batch::default(), reader.get_header().start_time);
    // Values that hold before the first time of the file; writers that have none fill them with x, which says nothing.
    let mut is_blank = true;
    let read = reader.read_signals(&FstFilter::all(), |time, handle, value| {
        if is_blank && time > start {
            batch = Batch::default();
        }
        is_blank &=
            time == start && matches!(value, FstSignalValue::String(digits) if digits.iter().all(|&d| d == b'x'));
        match value {
            FstSignalValue::String(digits) => batch.digits.extend_from_slice(digits),
            FstSignalValue::Real(value) => batch.digits.extend_from_slice(&value.to_le_bytes()),
        }
        batch.values.push((time, handle.get_index(), batch.digits.len()));
        if is_blank {
            return Ok(());
        }
        if batch.digits.len() < BATCH && batch.values.len() < BATCH_VALUES {
            return Ok(());
        }
        sender.send(Ok(std::mem::take(&mut batch))).map_err(drop)
    });
    match read {
        Ok(()) => {
            let _ = sender.send(Ok(batch));
            Ok(())
        }
        Err(fst_reader::ReadSignalsError::CallbackError(())) => Ok(()),
        Err(fst_reader::ReadSignalsError::ReadError(error)) => Err(broken(name, &error)),
    }
}

#[cfg(test)]
#[path = "fst_tests.rs"]
mod tests;
