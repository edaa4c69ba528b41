//! Reading VCD, ours or another tool's, time by time.

use std::io::Read;
use std::ops::Range;

use super::codes::Codes;
use super::declared::{Declared, Kind, SignalId};
use super::header::Header;
use super::source::Source;
use super::state::State;
use super::tokens::{Broken, Tokens};
use super::wrong::{Wrong, shown};
use crate::base::{Diagnostic, Report};

/// A VCD file of which the declarations have been read.
pub(super) struct VcdSource<R> {
    tokens: Tokens<R>,
    wrong: Wrong,
    declared: Declared,
    codes: Codes,
    /// The digits of a vector, while its code is read.
    digits: Vec<u8>,
    start: Option<u64>,
    /// The time whose values come next; values before the first time hold from 0.
    time: Option<u64>,
    /// The last time, and whether something changed at it.
    last: u64,
    changed: bool,
}

impl<R: Read> VcdSource<R> {
    /// Reads the declarations; `name` is what messages call the file.
    ///
    /// # Errors
    /// `W010` to `W012`, `W015` to `W017`, `W019`, as [`super::read()`].
    pub fn open(name: &str, input: R) -> Result<Self, Report> {
        let (tokens, declared, codes) = Header::read(name, input)?;
        let wrong = Wrong::new(name);
        let (digits, start, time) = (Vec::new(), None, Some(0));
        Ok(Self { tokens, wrong, declared, codes, digits, start, time, last: 0, changed: false })
    }

    fn complain(&mut self, code: &'static str, message: &str, help: &str) {
        self.wrong.at(self.tokens.line(), Diagnostic::new(code, message).help(help));
    }

    /// Reads up to the next time that differs; `None` at the end.
    fn values(&mut self, state: &mut State) -> Option<u64> {
        while !self.wrong.is_too_much() {
            let word = match self.tokens.next() {
                Ok(Some(word)) => word,
                Ok(None) => return None,
                Err(broken) => {
                    self.wrong.broken(self.tokens.line(), broken);
                    return None;
                }
            };
            match word[0] {
                b'#' => match time_of(&word[1..]) {
                    Some(time) if time < self.last => {
                        let message = format!("time goes back from {} to {time}", self.last);
                        self.complain("W013", &message, "times must not decrease");
                    }
                    Some(time) => {
                        self.start.get_or_insert(time);
                        if time != self.last {
                            return Some(time);
                        }
                    }
                    None => self.strange_time(),
                },
                b'b' | b'B' => {
                    self.digits.clear();
                    self.digits.extend_from_slice(&word[1..]);
                    self.with_code(|source, id| source.vector(state, id));
                }
                b'r' | b'R' => {
                    let value = std::str::from_utf8(&word[1..]).ok().and_then(|text| text.parse().ok());
                    self.with_code(|source, id| match value {
                        Some(value) if source.kind(id) == Kind::Real => state.set_real(id, value).is_some(),
                        _ => false,
                    });
                }
                b's' | b'S' => self.with_code(|source, id| source.kind(id) == Kind::Other),
                b'$' => {
                    let command = String::from_utf8_lossy(word).into_owned();
                    self.command(&command);
                }
                symbol => {
                    let id = self.codes.find(&word[1..]);
                    match id {
                        Some(id) if super::state::digit_of(symbol).is_some() => {
                            self.digits.clear();
                            self.digits.push(symbol);
                            self.change(id, |source, id| source.vector(state, id));
                        }
                        _ => {
                            let word = shown(word);
                            self.strange(symbol, &word);
                        }
                    }
                }
            }
        }
        None
    }

    fn kind(&self, id: SignalId) -> Kind {
        self.declared.signals[id.index()].kind
    }

    /// Sets a vector or scalar from its digits; an event is passed over.
    fn vector(&mut self, state: &mut State, id: SignalId) -> bool {
        self.kind(id) == Kind::Other || state.set_digits(id, &self.digits).is_some()
    }

    fn with_code(&mut self, set: impl FnOnce(&mut Self, SignalId) -> bool) {
        match self.tokens.next() {
            Ok(Some(code)) => match self.codes.find(code) {
                Some(id) => self.change(id, set),
                None => {
                    let code = shown(code);
                    self.undeclared(&code);
                }
            },
            Ok(None) => self.wrong.broken(self.tokens.line(), Broken::Cut),
            Err(broken) => self.wrong.broken(self.tokens.line(), broken),
        }
    }

    fn change(&mut self, id: SignalId, set: impl FnOnce(&mut Self, SignalId) -> bool) {
        self.changed = true;
        if !self.codes.is_parameter(id) {
            self.start.get_or_insert(0);
        }
        if !set(self, id) {
            let name = self.declared.names.iter().find(|name| name.signal == id).map_or("?", |name| &name.path);
            let message = match self.kind(id) {
                Kind::Bits if self.digits.len() > self.declared.signals[id.index()].width as usize => {
                    let width = self.declared.signals[id.index()].width;
                    format!("{} bits for `{name}`, which has {width}", self.digits.len())
                }
                Kind::Bits => format!("a value for `{name}` that is not made of 0, 1, x and z"),
                Kind::Real => format!("a value for `{name}` that is no number"),
                Kind::Other => format!("a value for `{name}` that is no text"),
            };
            self.complain("W015", &message, "the value must be of the kind and width that the file declares");
        }
    }

    fn undeclared(&mut self, code: &str) {
        let message = format!("a value for `{code}`, which was not declared");
        self.complain("W014", &message, "every code needs a `$var` before `$enddefinitions`");
    }

    fn strange(&mut self, symbol: u8, word: &str) {
        match super::state::digit_of(symbol) {
            Some(_) if word.len() > 1 => self.undeclared(&word[1..]),
            Some(_) => self.complain(
                "W012",
                &format!("`{word}` is a value without the code of its signal"),
                "the code follows at once, as in `1!`",
            ),
            None => self.complain(
                "W012",
                &format!("`{word}` is neither a time nor a value"),
                "a time is `#5`, a value `1!`, `b101 !` or `r0.5 !`",
            ),
        }
    }

    fn strange_time(&mut self) {
        let help = format!("a time is a whole number below {}", u64::MAX);
        self.complain("W012", "a time that cannot be understood", &help);
    }

    fn command(&mut self, command: &str) {
        match command {
            "$dumpvars" | "$dumpall" | "$dumpon" | "$dumpoff" | "$end" => {}
            "$comment" => loop {
                match self.tokens.next() {
                    Ok(Some(b"$end")) => return,
                    Ok(Some(_)) => {}
                    Ok(None) => return self.wrong.broken(self.tokens.line(), Broken::Cut),
                    Err(broken) => return self.wrong.broken(self.tokens.line(), broken),
                }
            },
            "$var" | "$scope" | "$upscope" | "$timescale" | "$enddefinitions" => {
                let message = format!("a declaration after `$enddefinitions`: `{command}`");
                self.complain("W012", &message, "declarations come before the first value");
            }
            _ => {
                let message = format!("`{}` is an unknown command", shown(command.as_bytes()));
                self.complain("W012", &message, "known here: $dumpvars, $dumpall, $dumpon, $dumpoff, $comment, $end");
            }
        }
    }
}

/// A time; the last one that 64 bits can hold has no time after it and is refused.
fn time_of(digits: &[u8]) -> Option<u64> {
    if digits.is_empty() || !digits.iter().all(u8::is_ascii_digit) {
        return None;
    }
    let step = |time: u64, digit: &u8| time.checked_mul(10)?.checked_add(u64::from(digit - b'0'));
    digits.iter().try_fold(0, step).filter(|&time| time < u64::MAX)
}

impl<R: Read> Source for VcdSource<R> {
    fn declared(&self) -> &Declared {
        &self.declared
    }

    fn time(&self) -> Option<u64> {
        self.time
    }

    fn advance(&mut self, state: &mut State) -> Result<(), Report> {
        self.changed = false;
        let next = self.values(state);
        self.time = next;
        if let Some(next) = next {
            self.last = next;
            return Ok(());
        }
        self.wrong.verdict()
    }

    fn span(&self) -> Range<u64> {
        let start = self.start.unwrap_or(0);
        let end = if self.changed { self.last + 1 } else { self.last };
        start..end.max(start)
    }

    fn is_closed(&self) -> bool {
        !self.changed
    }
}

#[cfg(test)]
#[path = "vcd_tests.rs"]
mod tests;
