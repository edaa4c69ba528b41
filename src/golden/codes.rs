//! Which signal an identifier code of a VCD file stands for.

use std::collections::HashMap;

use super::declared::SignalId;

/// Codes that come in a row, as nearly all tools write them, are looked up in a table of at most this many places.
const LONGEST_TABLE: usize = 1 << 20;

/// Signals by their codes.
#[derive(Clone, Debug, Default)]
pub(super) struct Codes {
    /// By the code as a number.
    table: Vec<Option<SignalId>>,
    /// The others.
    rest: HashMap<Vec<u8>, SignalId>,
    /// Signals that are parameters: their values tell nothing about when the waveform begins.
    parameters: Vec<bool>,
}

impl Codes {
    pub fn insert(&mut self, code: &[u8], id: SignalId, is_parameter: bool) {
        match number(code) {
            Some(place) => {
                self.table.resize(self.table.len().max(place + 1), None);
                self.table[place] = Some(id);
            }
            None => drop(self.rest.insert(code.to_vec(), id)),
        }
        self.parameters.resize(self.parameters.len().max(id.index() + 1), false);
        self.parameters[id.index()] = is_parameter;
    }

    pub fn find(&self, code: &[u8]) -> Option<SignalId> {
        match number(code) {
            Some(place) => self.table.get(place).copied().flatten(),
            None => self.rest.get(code).copied(),
        }
    }

    pub fn is_parameter(&self, id: SignalId) -> bool {
        self.parameters[id.index()]
    }
}

/// A short code as a number: its characters are digits from `!` to `~`, so that no two codes have the same.
fn number(code: &[u8]) -> Option<usize> {
    if code.is_empty() || code.len() > 3 || !code.iter().all(u8::is_ascii_graphic) {
        return None;
    }
    let place = code.iter().rev().fold(0, |place, &c| place * 94 + usize::from(c - b' '));
    (place < LONGEST_TABLE).then_some(place)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_code_finds_its_own_signal() {
        let ends = [b'!', b'"', b'~', b'a'];
        let mut all: Vec<Vec<u8>> = ends.iter().map(|&a| vec![a]).collect();
        for length in 1..6 {
            let longer = |code: &Vec<u8>| ends.map(|end| [code.as_slice(), &[end]].concat());
            all.extend(all.iter().filter(|code| code.len() == length).flat_map(longer).collect::<Vec<_>>());
        }
        let mut codes = Codes::default();
        for (index, code) in all.iter().enumerate() {
            codes.insert(code, SignalId::new(index), index % 3 == 0);
        }
        for (index, code) in all.iter().enumerate() {
            assert_eq!(codes.find(code), Some(SignalId::new(index)));
            assert_eq!(codes.is_parameter(SignalId::new(index)), index % 3 == 0);
        }
        assert_eq!(codes.find(b"b"), None);
        assert_eq!(codes.find(b""), None);
    }
}
