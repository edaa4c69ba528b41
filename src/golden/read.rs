//! Reading a VCD file, ours or another tool's, into a waveform.

use std::collections::HashMap;
use std::io::{self, BufRead};

use ::vcd::{Command, IdCode, ParseError, Parser, ReferenceIndex, TimescaleUnit, Value, VarType};

use super::wave::TrackId;
use super::{Track, Waveform};
use crate::base::{Diagnostic, Report, Sources};

/// The widest vector that is read, in bits.
const WIDEST: u32 = 1 << 16;

/// The deepest nesting of scopes that is read.
const DEEPEST: usize = 256;

/// How many errors are told before reading stops.
const MOST_ERRORS: usize = 20;

/// Reads a VCD file; `name` is what messages call it. Reals, strings, events and parameters are passed over.
///
/// # Errors
/// `W010` not a VCD file, `W011` it ends too early, `W012` a command that cannot be understood or has no place there,
/// `W013` time goes back, `W014` a value for an identifier that was not declared, `W015` a vector wider than declared
/// or than 65,536 bits, `W016` two signals of one name, `W017` the input cannot be read. All name the line.
pub fn read(name: &str, input: impl BufRead) -> Result<Waveform, Report> {
    let mut reader = Reader::new(name, Parser::new(input));
    reader.read();
    reader.finish()
}

/// Reads a golden trace: as [`read`], but the file must be whole.
///
/// # Errors
/// Those of [`read`], and `W018` when it does not end with the time that closes every waveform of ours.
pub fn read_golden(name: &str, input: impl BufRead) -> Result<Waveform, Report> {
    let wave = read(name, input)?;
    if wave.is_closed() {
        return Ok(wave);
    }
    let cut = Diagnostic::new("W018", format!("{name}: the file does not end with a closing time, so it was cut off"));
    Err(cut.help("take it back from the history, or write it anew with --bless").into())
}

struct Reader<'a, R> {
    name: &'a str,
    parser: Parser<R>,
    wrong: Vec<Diagnostic>,
    /// Nothing more is read, because all that follows would be wrong in the same way.
    is_over: bool,
    scopes: Vec<String>,
    /// Where an identifier's values go; `None` for kinds that are passed over.
    ids: HashMap<IdCode, Option<TrackId>>,
    names: Vec<(String, TrackId)>,
    tracks: Vec<Track>,
    unit: u64,
    in_header: bool,
    start: Option<u64>,
    time: u64,
    /// Whether something changed at `time`.
    changed: bool,
}

impl<'a, R: BufRead> Reader<'a, R> {
    fn new(name: &'a str, parser: Parser<R>) -> Self {
        Self {
            name,
            parser,
            wrong: Vec::new(),
            is_over: false,
            scopes: Vec::new(),
            ids: HashMap::new(),
            names: Vec::new(),
            tracks: Vec::new(),
            unit: 1_000_000,
            in_header: true,
            start: None,
            time: 0,
            changed: false,
        }
    }

    fn read(&mut self) {
        let mut is_first = true;
        while !self.is_over && self.wrong.len() < MOST_ERRORS {
            match self.parser.next() {
                Some(Ok(command)) => self.command(command),
                Some(Err(error)) => return self.broken(&error, is_first),
                None if self.in_header => return self.complain("W011", "the file ends before `$enddefinitions`"),
                None => return,
            }
            is_first = false;
        }
    }

    fn complain(&mut self, code: &'static str, message: &str) {
        let place = format!("{}, line {}", self.name, self.parser.line());
        self.wrong.push(Diagnostic::new(code, format!("{place}: {message}")));
    }

    fn broken(&mut self, error: &io::Error, is_first: bool) {
        let kind = error.get_ref().and_then(|inner| inner.downcast_ref::<ParseError>());
        match (error.kind(), kind) {
            (io::ErrorKind::UnexpectedEof, _) => self.complain("W011", "the file ends in the middle of a command"),
            (_, Some(_)) if is_first => self.complain("W010", "this is not a VCD file"),
            (_, Some(parse)) => self.complain("W012", &format!("{:?}", parse.kind())),
            _ => self.complain("W017", &format!("cannot be read: {error}")),
        }
    }

    fn command(&mut self, command: Command) {
        match command {
            Command::Comment(_) | Command::Date(_) | Command::Version(_) => {}
            Command::Begin(_) | Command::End(_) => {}
            Command::Timestamp(time) => self.timestamp(time),
            Command::ChangeScalar(id, value) => self.change(id, &[value]),
            Command::ChangeVector(id, value) => self.change(id, &Vec::from(value)),
            Command::ChangeReal(id, _) | Command::ChangeString(id, _) => self.pass_over(id),
            declaration if self.in_header => self.declare(declaration),
            _ => self.complain("W012", "a declaration after `$enddefinitions`"),
        }
    }

    fn declare(&mut self, command: Command) {
        match command {
            Command::Timescale(count, unit) => self.timescale(count, unit),
            Command::ScopeDef(_, _) if self.scopes.len() >= DEEPEST => {
                self.complain("W012", &format!("scopes are nested more than {DEEPEST} deep"));
                self.is_over = true;
            }
            Command::ScopeDef(_, name) => self.scopes.push(name),
            Command::Upscope => {
                if self.scopes.pop().is_none() {
                    self.complain("W012", "`$upscope` without a scope");
                }
            }
            Command::VarDef(kind, width, id, name, index) => self.variable(kind, width, id, &name, index),
            Command::Enddefinitions => self.in_header = false,
            _ => self.complain("W012", "an unknown command"),
        }
    }

    fn timescale(&mut self, count: u32, unit: TimescaleUnit) {
        let power = match unit {
            TimescaleUnit::S => 15,
            TimescaleUnit::MS => 12,
            TimescaleUnit::US => 9,
            TimescaleUnit::NS => 6,
            TimescaleUnit::PS => 3,
            _ => 0,
        };
        match count {
            1 | 10 | 100 => self.unit = u64::from(count) * 10u64.pow(power),
            _ => self.complain("W012", "a timescale is 1, 10 or 100 of a unit"),
        }
    }

    fn variable(&mut self, kind: VarType, width: u32, id: IdCode, name: &str, index: Option<ReferenceIndex>) {
        if matches!(kind, VarType::Real | VarType::String | VarType::Event | VarType::Parameter) {
            self.ids.entry(id).or_insert(None);
            return;
        }
        if !(1..=WIDEST).contains(&width) {
            return self.complain("W015", &format!("`{name}` has {width} bits; 1 to {WIDEST} are read"));
        }
        let track = match self.ids.get(&id).copied().flatten() {
            Some(track) if self.tracks[track.index()].width() == width => track,
            Some(_) => return self.complain("W012", &format!("`{name}` has not the width of its alias")),
            None => {
                self.tracks.push(Track::new(width));
                TrackId::new(self.tracks.len() - 1)
            }
        };
        self.ids.insert(id, Some(track));
        let path =
            self.scopes.iter().map(String::as_str).chain([plain(name, index).as_str()]).collect::<Vec<_>>().join(".");
        self.names.push((path, track));
    }

    fn timestamp(&mut self, time: u64) {
        if self.in_header {
            return self.complain("W012", "a time before `$enddefinitions`");
        }
        if time < self.time {
            return self.complain("W013", &format!("time goes back from {} to {time}", self.time));
        }
        self.changed &= time == self.time;
        self.start.get_or_insert(time);
        self.time = time;
    }

    fn change(&mut self, id: IdCode, value: &[Value]) {
        self.changed = true;
        // Values before the first time hold from time 0.
        self.start.get_or_insert(0);
        let Some(track) = self.ids.get(&id).copied() else {
            return self.complain("W014", &format!("a value for `{id}`, which was not declared"));
        };
        let Some(track) = track.map(TrackId::index) else { return };
        let width = self.tracks[track].width() as usize;
        if value.len() > width {
            return self.complain("W015", &format!("{} bits for `{id}`, which has {width}", value.len()));
        }
        // A vector that is cut short is widened: x with x, z with z, others with 0 (IEEE 1364-2005, 18.2.1).
        let rest = match value.first() {
            Some(&leading @ (Value::X | Value::Z)) => leading,
            _ => Value::V0,
        };
        let bits = value.iter().rev().copied().chain(std::iter::repeat(rest));
        self.tracks[track].set(self.time, bits.take(width).map(planes));
    }

    fn pass_over(&mut self, id: IdCode) {
        match self.ids.get(&id) {
            Some(_) => self.changed = true,
            None => self.complain("W014", &format!("a value for `{id}`, which was not declared")),
        }
    }

    fn finish(mut self) -> Result<Waveform, Report> {
        let start = self.start.unwrap_or(0);
        let end = if self.changed { self.time.saturating_add(1) } else { self.time };
        let mut wave = Waveform::new(self.tracks, start..end.max(start), self.unit, !self.changed);
        for (name, track) in self.names {
            let known = wave.track_id(&name);
            // Icarus declares a port again where a task or a bench dumps it twice; the same identifier is no harm.
            if known.is_some_and(|known| known != track) {
                let message = format!("{}: two signals are called `{name}`", self.name);
                self.wrong.push(Diagnostic::new("W016", message));
            }
            wave.name(name, track);
        }
        self.wrong.dedup();
        if self.wrong.is_empty() { Ok(wave) } else { Err(Report::new(Sources::default(), self.wrong)) }
    }
}

fn planes(value: Value) -> (bool, bool) {
    (matches!(value, Value::V1 | Value::Z), matches!(value, Value::X | Value::Z))
}

/// A name without its range and without the backslash of an escaped identifier; a single bit keeps its index.
fn plain(name: &str, index: Option<ReferenceIndex>) -> String {
    let name = name.strip_prefix('\\').unwrap_or(name);
    let is_range = |text: &str| matches!(text.parse(), Ok(ReferenceIndex::Range(..)));
    let name = match name.rfind('[') {
        Some(at) if at > 0 && is_range(&name[at..]) => &name[..at],
        _ => name,
    };
    match index {
        Some(ReferenceIndex::BitSelect(bit)) => format!("{name}[{bit}]"),
        _ => name.to_owned(),
    }
}

#[cfg(test)]
#[path = "read_tests.rs"]
mod tests;
