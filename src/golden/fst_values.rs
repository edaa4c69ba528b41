//! How much the value changes of a block of an FST file unpack to, which the crate that decodes it takes whole.
//!
//! Behind the changes stands a chain with an entry for each signal: where its changes begin, which signal's it shares,
//! or how many signals have none (GTKWave's writer and reader, `fstapi.c`).

use std::io::{self, Read, Seek, SeekFrom};

use super::fst_numbers::{number, varint};

/// The changes of a block, as its head and its end state them.
pub(super) struct Changes {
    /// The kind of the block: 8 has another form of chain than 1 and 5.
    pub kind: u64,
    /// Where offsets count from: the byte that names the packing.
    pub start: u64,
    pub signals: u64,
    /// Where the length of the chain stands, right behind it.
    pub chain_end: u64,
}

/// What stands in the chain for a signal.
#[derive(Clone, Copy)]
enum Entry {
    Nothing,
    At(u64),
    Shared(u64),
}

impl Entry {
    fn offset(self) -> Option<u64> {
        if let Self::At(offset) = self { Some(offset) } else { None }
    }
}

/// The bytes that all changes unpack to, those that signals share as often as they do; `None` where the chain cannot be.
pub(super) fn unpacked(input: &mut (impl Read + Seek), changes: &Changes) -> io::Result<Option<u64>> {
    input.seek(SeekFrom::Start(changes.chain_end))?;
    let length = number(input, 8)?;
    let Some(begin) = changes.chain_end.checked_sub(length).filter(|&begin| begin > changes.start) else {
        return Ok(None);
    };
    input.seek(SeekFrom::Start(begin))?;
    let mut chain = Vec::new();
    input.take(length).read_to_end(&mut chain)?;
    let Some(entries) = entries(&chain, changes) else { return Ok(None) };
    input.seek(SeekFrom::Start(changes.start))?;
    let packing = number(input, 1)? as u8;
    let placed: Vec<_> =
        entries.iter().enumerate().filter_map(|(signal, entry)| entry.offset().map(|at| (signal, at))).collect();
    let mut own = vec![None; entries.len()];
    for (place, &(signal, offset)) in placed.iter().enumerate() {
        let end = placed.get(place + 1).map_or(u64::MAX, |next| next.1).min(begin - changes.start);
        let Some(packed) = end.checked_sub(offset) else { return Ok(None) };
        input.seek(SeekFrom::Start(changes.start + offset))?;
        own[signal] = Some(cost(&mut input.take(packed), packing, packed)?);
    }
    let cost_of = |signal: usize| own.get(signal).copied().flatten();
    let mut costs = entries.iter().enumerate().map(|(signal, entry)| match entry {
        Entry::Nothing => Some(0),
        Entry::At(_) => cost_of(signal),
        Entry::Shared(with) => cost_of(usize::try_from(*with).ok()?),
    });
    Ok(costs.try_fold(0_u64, |sum, cost| Some(sum.saturating_add(cost?))))
}

/// The entries, one for each signal up to the last that has changes.
fn entries(mut chain: &[u8], changes: &Changes) -> Option<Vec<Entry>> {
    let (mut entries, mut offset, mut shared) = (Vec::new(), 0_u64, 0);
    while !chain.is_empty() {
        let is_signed = changes.kind == 8 && chain[0] & 1 == 1;
        let value = if is_signed { signed(&mut chain)? } else { i64::try_from(varint(&mut chain).ok()?).ok()? };
        match value >> 1 {
            0 if !is_signed && value == 0 && changes.kind != 8 => {
                entries.push(Entry::Shared(varint(&mut chain).ok()?.checked_sub(1)?));
            }
            nothing if value & 1 == 0 => {
                let count = entries.len() as u64 + nothing as u64;
                entries.resize(count.min(changes.signals + 1) as usize, Entry::Nothing);
            }
            more if more >= 0 && !(is_signed && more == 0) => {
                offset = offset.checked_add(more as u64)?;
                entries.push(Entry::At(offset));
            }
            of => {
                shared = if of == 0 { shared } else { of.unsigned_abs() - 1 };
                entries.push(Entry::Shared(shared));
            }
        }
        if entries.len() as u64 > changes.signals {
            return None;
        }
    }
    Some(entries)
}

/// What the changes of one signal unpack to.
fn cost(input: &mut impl Read, packing: u8, packed: u64) -> io::Result<u64> {
    let stated = varint(input)?;
    Ok(match (stated, packing) {
        (0, _) => packed,
        (_, b'F') => {
            let mut bytes = Vec::new();
            input.read_to_end(&mut bytes)?;
            stated.max(fast_lz(&bytes))
        }
        _ => stated,
    })
}

/// The length that FastLZ unpacks to, which is not held against the one stated (github.com/ariya/FastLZ).
fn fast_lz(bytes: &[u8]) -> u64 {
    let mut rest = bytes.iter().map(|&byte| u64::from(byte));
    let Some(first) = rest.next() else { return 0 };
    let is_second_level = first >> 5 == 1;
    let (mut length, mut op) = (0, Some(first & 31));
    while let Some(code) = op {
        if code < 32 {
            length += code + 1;
            rest.nth(code as usize);
        } else {
            length += (code >> 5) + 2;
            if code >> 5 == 7 {
                let more = |byte: &u64| is_second_level && *byte == 255;
                let mut byte = rest.next();
                while let Some(255) = byte.filter(more) {
                    length += 255;
                    byte = rest.next();
                }
                length += byte.unwrap_or(0);
            }
            if rest.next() == Some(255) && is_second_level && code & 31 == 31 {
                rest.nth(1);
            }
        }
        op = rest.next();
    }
    length
}

/// A number of seven bits a byte, the least significant first, the last byte's second bit being its sign.
fn signed(bytes: &mut &[u8]) -> Option<i64> {
    let mut value = 0;
    for shift in (0..63).step_by(7) {
        let (&byte, rest) = bytes.split_first()?;
        *bytes = rest;
        value |= i64::from(byte & 127) << shift;
        if byte < 128 {
            let above = 57 - shift;
            return Some(if above > 0 { value << above >> above } else { value });
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use std::io::Cursor;

    use super::*;

    /// A block of four signals or so: the packing, the values from offset 1 on, and a chain.
    fn unpacked_of(kind: u64, packing: u8, values: &[u8], chain: &[u8]) -> Option<u64> {
        let length = (chain.len() as u64).to_be_bytes();
        let bytes = [&[packing], values, chain, &length].concat();
        let changes = Changes { kind, start: 0, signals: 5, chain_end: (bytes.len() - 8) as u64 };
        unpacked(&mut Cursor::new(bytes), &changes).unwrap()
    }

    #[test]
    fn values_that_signals_share_count_for_each_of_them() {
        // 100 bytes packed into two, for the first signal; the second one shares them, two have none.
        assert_eq!(unpacked_of(5, b'4', &[100, 7, 7], &[3, 0, 1, 4]), Some(200));
        // The same in the later form, where a third one shares them too.
        assert_eq!(unpacked_of(8, b'4', &[100, 7, 7], &[3, 0x7f, 1, 4]), Some(300));
        // More than can be counted.
        assert_eq!(unpacked_of(5, b'4', &[255; 9], &[3, 0, 1]), Some(u64::MAX));
        // Nothing stated: the bytes stand there as they are.
        assert_eq!(unpacked_of(8, b'Z', &[0, 7, 7, 0, 7], &[3, 7]), Some(5));
    }

    #[test]
    fn what_fast_lz_comes_to_counts_more_than_what_is_stated() {
        // A letter, then 9 + 255 + 255 + 0 more of it.
        assert_eq!(unpacked_of(8, b'F', &[1, 0x20, b'a', 0xe0, 255, 255, 0, 0], &[3]), Some(520));
        // The first level: three letters, then 9 + 255 more, then one.
        assert_eq!(unpacked_of(8, b'F', &[1, 2, b'a', b'b', b'c', 0xe0, 255, 0, 0, b'd'], &[3]), Some(268));
    }

    #[test]
    fn a_chain_that_cannot_be_is_none() {
        let values = [100, 7, 7];
        // More signals than the block has; values behind the chain; one that shares what another has not.
        let far = [0x83, 0x80, 0x80, 0x80, 0x80, 0x80, 0x80, 0x80, 0x7f, 3];
        for chain in [&[3, 12][..], &[3, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1], &[99], &[0, 3], &[0x80], &far] {
            assert_eq!(unpacked_of(5, b'4', &values, chain), None, "{chain:?}");
        }
    }
}
