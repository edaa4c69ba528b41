//! The declarations of a VCD file.

use std::io::Read;

use super::codes::Codes;
use super::declared::{Declared, Declaring, Kind, Signal};
use super::tokens::{Broken, Tokens};
use super::wrong::{Wrong, shown};
use crate::base::{Diagnostic, Report};

/// Reads what stands before the values.
pub(super) struct Header<R> {
    tokens: Tokens<R>,
    wrong: Wrong,
    declaring: Declaring,
    codes: Codes,
}

impl<R: Read> Header<R> {
    /// The declarations, and where the values begin.
    ///
    /// # Errors
    /// As [`super::read()`].
    pub fn read(name: &str, input: R) -> Result<(Tokens<R>, Declared, Codes), Report> {
        let mut header = Self {
            tokens: Tokens::new(input),
            wrong: Wrong::new(name),
            declaring: Declaring::default(),
            codes: Codes::default(),
        };
        let mut is_first = true;
        while header.command(is_first) && !header.wrong.is_too_much() {
            is_first = false;
        }
        header.wrong.verdict()?;
        Ok((header.tokens, header.declaring.finish(), header.codes))
    }

    fn complain(&mut self, diagnostic: Diagnostic) {
        self.wrong.at(self.tokens.line(), diagnostic);
    }

    /// Reads one command; whether another one follows.
    fn command(&mut self, is_first: bool) -> bool {
        let command = match self.tokens.next() {
            Ok(Some(word)) => word.to_vec(),
            Ok(None) => {
                let help = "it was cut off, or it is no VCD file";
                self.complain(Diagnostic::new("W011", "the file ends before `$enddefinitions`").help(help));
                return false;
            }
            Err(_) if is_first => return self.foreign(),
            Err(broken) => {
                self.wrong.broken(self.tokens.line(), broken);
                return false;
            }
        };
        if command[0] != b'$' {
            if is_first {
                return self.foreign();
            }
            let message = match command[0] {
                b'#' => "a time before `$enddefinitions`".to_owned(),
                _ => format!("`{}` is no declaration", shown(&command)),
            };
            self.complain(Diagnostic::new("W012", message).help("declarations are `$timescale`, `$scope`, `$var`"));
            // Without declarations every value that follows would be wrong in the same way.
            return false;
        }
        let Some(words) = self.words() else { return false };
        if let Err(diagnostic) = self.declare(&command, &words) {
            let is_over = diagnostic.code == "W019" || diagnostic.message.contains("nested");
            self.complain(diagnostic);
            return !is_over;
        }
        command != b"$enddefinitions"
    }

    fn foreign(&mut self) -> bool {
        let help = "a VCD file begins with a command such as `$date`; an FST file is read, too";
        self.complain(Diagnostic::new("W010", "this is not a VCD file").help(help));
        false
    }

    /// The words up to `$end`; of a comment only the first ones.
    fn words(&mut self) -> Option<Vec<String>> {
        let mut words = Vec::new();
        loop {
            match self.tokens.next() {
                Ok(Some(b"$end")) => return Some(words),
                // A declaration has fewer.
                Ok(Some(word)) if words.len() < 16 => words.push(String::from_utf8_lossy(word).into_owned()),
                Ok(Some(_)) => {}
                Ok(None) => {
                    self.wrong.broken(self.tokens.line(), Broken::Cut);
                    return None;
                }
                Err(broken) => {
                    self.wrong.broken(self.tokens.line(), broken);
                    return None;
                }
            }
        }
    }

    fn declare(&mut self, command: &[u8], words: &[String]) -> Result<(), Diagnostic> {
        match (command, words) {
            (b"$date" | b"$version" | b"$comment" | b"$attrbegin" | b"$attrend" | b"$enddefinitions", _) => Ok(()),
            (b"$timescale", _) => self.timescale(&words.concat()),
            (b"$scope", [_, name]) => self.declaring.scope(name),
            (b"$scope", _) => Err(Diagnostic::new("W012", "a `$scope` without kind and name")
                .help("write it as in `$scope module top $end`")),
            (b"$upscope", _) => self.declaring.upscope(),
            (b"$var", [kind, width, code, reference @ ..]) if !reference.is_empty() => {
                self.variable(kind, width, code, &reference.concat())
            }
            (b"$var", _) => Err(Diagnostic::new("W012", "a `$var` that lacks kind, width, code or name")
                .help("write it as in `$var wire 8 ! data [7:0] $end`")),
            _ => {
                let message = format!("`{}` is an unknown command", shown(command));
                Err(Diagnostic::new("W012", message).help("known here: $timescale, $scope, $upscope, $var, $comment"))
            }
        }
    }

    fn timescale(&mut self, text: &str) -> Result<(), Diagnostic> {
        let at = text.find(|c: char| !c.is_ascii_digit()).unwrap_or(text.len());
        let count = [1, 10, 100].into_iter().find(|count: &u64| count.to_string() == text[..at]);
        let units = [("s", 15), ("ms", 12), ("us", 9), ("ns", 6), ("ps", 3), ("fs", 0)];
        let power = units.iter().find(|(unit, _)| *unit == &text[at..]).map(|(_, power)| *power);
        let (Some(count), Some(power)) = (count, power) else {
            let message = format!("`{}` is no timescale", shown(text.as_bytes()));
            return Err(Diagnostic::new("W012", message).help("it is 1, 10 or 100 of s, ms, us, ns, ps or fs"));
        };
        self.declaring.unit(count * 10u64.pow(power));
        Ok(())
    }

    fn variable(&mut self, kind: &str, width: &str, code: &str, reference: &str) -> Result<(), Diagnostic> {
        let signal = match kind {
            "real" | "realtime" | "real_parameter" | "shortreal" => Signal { kind: Kind::Real, width: 64 },
            "string" | "event" => Signal { kind: Kind::Other, width: 0 },
            _ => {
                let width = width.parse().map_err(|_| {
                    let message = format!("the width `{}` of `{reference}` is no number", shown(width.as_bytes()));
                    Diagnostic::new("W012", message).help("it is a number of bits")
                })?;
                Signal { kind: Kind::Bits, width }
            }
        };
        let id = self.declaring.variable(signal, self.codes.find(code.as_bytes()), reference)?;
        self.codes.insert(code.as_bytes(), id, kind == "parameter" || kind == "real_parameter");
        Ok(())
    }
}
