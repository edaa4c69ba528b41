//! What a waveform file declares: signals, their names, the unit of time.

use std::collections::{HashMap, HashSet};

use super::planes::words_of;
use crate::base::Diagnostic;

crate::define_id!(
    /// A signal of a file; names that stand for the same one share it.
    SignalId
);

/// The widest vector that is read, in bits.
pub(super) const WIDEST: u32 = 1 << 16;

/// The deepest nesting of scopes that is read.
const DEEPEST: usize = 256;

/// How many words of 64 bits the values of all signals may take at one time: 8 MiB of bits, 8 MiB of unknowns.
pub(super) const MOST_WORDS: usize = 1 << 20;

/// How many bytes all names may take, with their scopes.
const MOST_NAME_BYTES: usize = 64 << 20;

/// What the values of a signal are.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Kind {
    /// Bits, each 0, 1, x or z.
    Bits,
    /// A number of floating point.
    Real,
    /// A text or an event, which is not compared.
    Other,
}

/// A signal: what its values are and how wide.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Signal {
    pub kind: Kind,
    /// In bits; 64 for a real.
    pub width: u32,
}

/// A name of a signal.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Name {
    /// Dotted, without a range.
    pub path: String,
    pub signal: SignalId,
    /// The indices of the most and the least significant bit, where the file tells them.
    pub range: Option<(i64, i64)>,
}

/// All that stands before the values.
#[derive(Clone, Debug)]
pub(super) struct Declared {
    pub signals: Vec<Signal>,
    /// In the order of the file, each path once.
    pub names: Vec<Name>,
    /// Femtoseconds that one unit of time stands for.
    pub unit: u64,
}

impl Declared {
    /// Single bits of these names, for matching names alone.
    pub fn of_names<'n>(names: impl Iterator<Item = &'n str>) -> Self {
        let name = |(at, path): (usize, &str)| Name { path: path.to_owned(), signal: SignalId::new(at), range: None };
        let names: Vec<_> = names.enumerate().map(name).collect();
        Self { signals: vec![Signal { kind: Kind::Bits, width: 1 }; names.len()], names, unit: 1 }
    }
}

/// Puts a [`Declared`] together, whatever the format; messages come without a place.
#[derive(Debug)]
pub(super) struct Declaring {
    declared: Declared,
    scopes: Vec<String>,
    known: HashMap<String, SignalId>,
    told: HashSet<String>,
    words: usize,
    bytes: usize,
}

impl Default for Declaring {
    fn default() -> Self {
        let declared = Declared { signals: Vec::new(), names: Vec::new(), unit: 1_000_000 };
        let (scopes, known, told) = (Vec::new(), HashMap::new(), HashSet::new());
        Self { declared, scopes, known, told, words: 0, bytes: 0 }
    }
}

impl Declaring {
    /// Enters a scope.
    ///
    /// # Errors
    /// `W012` more than 256 of them.
    pub fn scope(&mut self, name: &str) -> Result<(), Diagnostic> {
        if self.scopes.len() >= DEEPEST {
            return Err(Diagnostic::new("W012", format!("scopes are nested more than {DEEPEST} deep")));
        }
        self.scopes.push(name.strip_prefix('\\').unwrap_or(name).to_owned());
        Ok(())
    }

    /// Leaves a scope.
    ///
    /// # Errors
    /// `W012` there is none.
    pub fn upscope(&mut self) -> Result<(), Diagnostic> {
        let left = self.scopes.pop().map(drop);
        left.ok_or_else(|| Diagnostic::new("W012", "this leaves a scope, but none is open").help("remove it"))
    }

    pub fn unit(&mut self, femtoseconds: u64) {
        self.declared.unit = femtoseconds;
    }

    /// Declares a name; `alias` is the signal that it stands for, if it has been declared before.
    ///
    /// # Errors
    /// `W012` not the width of its alias, `W015` too wide, `W016` the name is taken, `W019` too much in all.
    pub fn variable(
        &mut self,
        signal: Signal,
        alias: Option<SignalId>,
        reference: &str,
    ) -> Result<SignalId, Diagnostic> {
        let (local, range) = plain(reference);
        if signal.kind == Kind::Bits && !(1..=WIDEST).contains(&signal.width) {
            let message = format!("`{local}` has {} bits; 1 to {WIDEST} are read", signal.width);
            return Err(Diagnostic::new("W015", message).help("split it into parts, or leave it out of the dump"));
        }
        let id = match alias {
            Some(id) if self.declared.signals[id.index()] == signal => id,
            Some(_) => return Err(Diagnostic::new("W012", format!("`{local}` has not the width of its alias"))),
            None => self.signal(signal)?,
        };
        let mut path = self.scopes.join(".");
        if !path.is_empty() {
            path.push('.');
        }
        path += &local;
        self.name(Name { path, signal: id, range })?;
        Ok(id)
    }

    fn signal(&mut self, signal: Signal) -> Result<SignalId, Diagnostic> {
        self.words += words_of(signal.width);
        if self.words > MOST_WORDS {
            let message = format!("its signals have more than {} bits in all", MOST_WORDS * 64);
            return Err(Diagnostic::new("W019", message).help("trace less"));
        }
        self.declared.signals.push(signal);
        Ok(SignalId::new(self.declared.signals.len() - 1))
    }

    fn name(&mut self, name: Name) -> Result<(), Diagnostic> {
        self.bytes += name.path.len();
        if self.bytes > MOST_NAME_BYTES {
            let message = format!("the names of its signals take more than {} MiB", MOST_NAME_BYTES >> 20);
            return Err(Diagnostic::new("W019", message).help("trace less"));
        }
        match self.known.get(&name.path) {
            // Icarus declares a port again where a task or a bench dumps it twice; the same signal is no harm.
            Some(known) if *known == name.signal => Ok(()),
            Some(_) if !self.told.insert(name.path.clone()) => Ok(()),
            Some(_) => Err(Diagnostic::new("W016", format!("two signals are called `{}`", name.path))),
            None => {
                self.known.insert(name.path.clone(), name.signal);
                self.declared.names.push(name);
                Ok(())
            }
        }
    }

    pub fn finish(self) -> Declared {
        self.declared
    }
}

/// A name without its range and without the backslash of an escaped identifier; a single bit keeps its index.
fn plain(reference: &str) -> (String, Option<(i64, i64)>) {
    let reference = reference.strip_prefix('\\').unwrap_or(reference);
    let Some(at) = reference.rfind('[').filter(|&at| at > 0 && reference.ends_with(']')) else {
        return (reference.trim_end().to_owned(), None);
    };
    let (name, index) = (reference[..at].trim_end(), &reference[at + 1..reference.len() - 1]);
    let number = |text: &str| text.trim().parse::<i64>().ok();
    match index.split_once(':') {
        Some((high, low)) => match (number(high), number(low)) {
            (Some(high), Some(low)) => (name.to_owned(), Some((high, low))),
            _ => (reference.to_owned(), None),
        },
        None => (format!("{name}[{index}]"), None),
    }
}
