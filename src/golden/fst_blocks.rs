//! Whether the sizes that an FST file states can be true: the crate that decodes it takes memory by them, unasked.
//!
//! A file is a row of blocks, each with a kind of one byte and a length of eight (the format's description in GTKWave).

use std::io::{self, Read, Seek, SeekFrom};

use miniz_oxide::inflate::decompress_to_vec_zlib_with_limit;

use super::declared::MOST_WORDS;
use super::fst_numbers::{number, varint};
use super::fst_values::{Changes, unpacked};

/// The largest part of a block when it is unpacked, in bytes; writers make blocks of some tens of MiB.
const LARGEST: u64 = 256 << 20;

/// The bytes that all value changes of a block may unpack to; GTKWave's writer ends a block at 128 MiB by default.
const MOST_VALUES: u64 = 512 << 20;

/// The times of a block; each has at least one change.
const MOST_TIMES: u64 = 1 << 25;

/// Signals: some 40 bytes are taken for each.
pub(super) const MOST_SIGNALS: u64 = 1 << 22;

/// Bits of all signals, as the declarations are limited to.
const MOST_BITS: u64 = 64 * MOST_WORDS as u64;

/// Walks over all blocks, and goes back to the beginning. `Err` with what is wrong.
pub(super) fn check(input: &mut (impl Read + Seek)) -> Result<(), String> {
    let found = walk(input).map_err(|error| match error.kind() {
        io::ErrorKind::UnexpectedEof => "it ends in the middle of a block".to_owned(),
        _ => error.to_string(),
    })?;
    input.rewind().map_err(|error| error.to_string())?;
    found
}

fn walk(input: &mut (impl Read + Seek)) -> io::Result<Result<(), String>> {
    let size = input.seek(SeekFrom::End(0))?;
    let mut at = 0;
    while at < size {
        input.seek(SeekFrom::Start(at))?;
        let kind = number(input, 1)?;
        let length = number(input, 8)?;
        let end = (at + 1).checked_add(length).filter(|&end| length >= 8 && end <= size);
        let Some(end) = end else { return Ok(Err("a block is longer than the file: it was cut off".to_owned())) };
        let is_sound = match kind {
            254 => return Ok(Err("it is packed as a whole, which is not read".to_owned())),
            // Value changes.
            1 | 5 | 8 => length >= 56 && are_changes_sound(input, kind, at + 1, end)?,
            // When the dump was switched off.
            2 => varint(input)? <= length,
            3 => length >= 24 && are_widths_sound(input, length - 24)?,
            // Names.
            4 | 6 => length >= 16 && number(input, 8)? <= LARGEST,
            7 => length >= 16 && number(input, 8)? <= LARGEST && varint(input)? <= LARGEST,
            _ => true,
        };
        if !is_sound {
            return Ok(Err(format!(
                "the block at byte {at} states a size that cannot be, or unpacks to more than {} MiB",
                MOST_VALUES >> 20
            )));
        }
        at = end;
    }
    Ok(Ok(()))
}

/// The table of times at the end of a block, how many signals have values at its beginning and in it, and the values.
fn are_changes_sound(input: &mut (impl Read + Seek), kind: u64, start: u64, end: u64) -> io::Result<bool> {
    input.seek(SeekFrom::Start(end - 24))?;
    let [unpacked_times, packed_times, times] = [number(input, 8)?, number(input, 8)?, number(input, 8)?];
    if unpacked_times > LARGEST || packed_times > end - start || times > unpacked_times.min(MOST_TIMES) {
        return Ok(false);
    }
    input.seek(SeekFrom::Start(start + 32))?;
    let [unpacked_frame, packed_frame, signals] = [varint(input)?, varint(input)?, varint(input)?];
    if unpacked_frame > LARGEST || packed_frame > end - start || signals > MOST_SIGNALS {
        return Ok(false);
    }
    let values = input.stream_position()? + packed_frame;
    input.seek(SeekFrom::Start(values))?;
    let signals = varint(input)?;
    let start = input.stream_position()?;
    let Some(chain_end) = end.checked_sub(24 + packed_times + 8).filter(|&at| at > start && signals <= MOST_SIGNALS)
    else {
        return Ok(false);
    };
    let changes = Changes { kind, start, signals, chain_end };
    Ok(unpacked(input, &changes)?.is_some_and(|bytes| bytes <= MOST_VALUES))
}

/// How wide each signal is: a value is unpacked to a byte a bit.
fn are_widths_sound(input: &mut impl Read, packed: u64) -> io::Result<bool> {
    let (unpacked, signals) = (number(input, 8)?, number(input, 8)?);
    if unpacked > 5 * MOST_SIGNALS || signals > unpacked.min(MOST_SIGNALS) {
        return Ok(false);
    }
    let mut bytes = Vec::new();
    input.take(packed).read_to_end(&mut bytes)?;
    if packed != unpacked {
        let Ok(inflated) = decompress_to_vec_zlib_with_limit(&bytes, unpacked as usize) else { return Ok(false) };
        bytes = inflated;
    }
    let mut rest = bytes.as_slice();
    let mut bits = 0_u64;
    for _ in 0..signals {
        // This one stands for values of any length.
        bits += Some(varint(&mut rest)?).filter(|&width| width != u64::from(u32::MAX)).unwrap_or(0);
        if bits > MOST_BITS {
            return Ok(false);
        }
    }
    Ok(true)
}
