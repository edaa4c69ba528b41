//! Numbers as FST files have them.

use std::io::{self, Read};

/// A number of so many bytes, the most significant first.
pub(super) fn number(input: &mut impl Read, bytes: usize) -> io::Result<u64> {
    let mut buffer = [0; 8];
    input.read_exact(&mut buffer[8 - bytes..])?;
    Ok(u64::from_be_bytes(buffer))
}

/// A number of seven bits a byte, the least significant first; the largest one if it does not fit.
pub(super) fn varint(input: &mut impl Read) -> io::Result<u64> {
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
