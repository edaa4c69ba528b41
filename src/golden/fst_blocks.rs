//! Whether the sizes that an FST file states can be true: the crate that decodes it takes memory by them, unasked.
//!
//! A file is a row of blocks, each with a kind of one byte and a length of eight (the format's description in GTKWave).

use std::io::{self, Read, Seek, SeekFrom};

/// The largest part of a block when it is unpacked, in bytes; writers make blocks of some tens of MiB.
const LARGEST: u64 = 256 << 20;

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
            1 | 5 | 8 => length >= 56 && are_changes_sound(input, at + 1, end)?,
            // How wide each signal is.
            3 => {
                let (unpacked, signals) = (number(input, 8)?, number(input, 8)?);
                length >= 24 && unpacked <= LARGEST && signals <= unpacked
            }
            // Names.
            4 | 6 => length >= 16 && number(input, 8)? <= LARGEST,
            7 => length >= 16 && number(input, 8)? <= LARGEST && varint(input)? <= LARGEST,
            _ => true,
        };
        if !is_sound {
            return Ok(Err(format!("the block at byte {at} states a size that cannot be")));
        }
        at = end;
    }
    Ok(Ok(()))
}

/// The table of times at the end of a block, and how many signals have values at its beginning and in it.
fn are_changes_sound(input: &mut (impl Read + Seek), start: u64, end: u64) -> io::Result<bool> {
    input.seek(SeekFrom::Start(end - 24))?;
    let [unpacked, packed, times] = [number(input, 8)?, number(input, 8)?, number(input, 8)?];
    if unpacked > LARGEST || packed > end - start || times > unpacked {
        return Ok(false);
    }
    input.seek(SeekFrom::Start(start + 32))?;
    let [unpacked, packed, signals] = [varint(input)?, varint(input)?, varint(input)?];
    if unpacked > LARGEST || packed > end - start || signals > LARGEST / 16 {
        return Ok(false);
    }
    let values = input.stream_position()? + packed;
    input.seek(SeekFrom::Start(values))?;
    Ok(varint(input)? <= LARGEST / 16)
}

/// A number of so many bytes, the most significant first.
fn number(input: &mut impl Read, bytes: usize) -> io::Result<u64> {
    let mut buffer = [0; 8];
    input.read_exact(&mut buffer[8 - bytes..])?;
    Ok(u64::from_be_bytes(buffer))
}

/// A number of seven bits a byte, the least significant first; the largest one if it does not fit.
fn varint(input: &mut impl Read) -> io::Result<u64> {
    let mut value = 0;
    for shift in (0..63).step_by(7) {
        let byte = number(input, 1)?;
        value |= (byte & 127) << shift;
        if byte < 128 {
            return Ok(value);
        }
    }
    Ok(u64::MAX)
}
