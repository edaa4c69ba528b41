//! Bits as text, eight at a time by a table.

/// The bits of each byte as `0` and `1`, most significant first.
static BYTES: [[u8; 8]; 256] = {
    let mut table = [[b'0'; 8]; 256];
    let mut byte = 0;
    while byte < 256 {
        let mut bit = 0;
        while bit < 8 {
            table[byte][bit] += ((byte >> (7 - bit)) & 1) as u8;
            bit += 1;
        }
        byte += 1;
    }
    table
};

/// Writes the low `width` bits (1 to 64) of `word` to the start of `out`, most significant first. What follows up
/// to the next multiple of 8 is overwritten too; `out` must have that much room.
#[inline]
pub(super) fn put_bits(out: &mut [u8], word: u64, width: u32) {
    let mut rest = word << (64 - width);
    for eight in out.chunks_exact_mut(8).take(width.div_ceil(8) as usize) {
        eight.copy_from_slice(&BYTES[(rest >> 56) as usize]);
        rest <<= 8;
    }
}

/// Writes a number in decimal to the end of `out` and returns where it starts.
#[inline]
pub(super) fn put_decimal(out: &mut [u8; 20], mut number: u64) -> usize {
    let mut start = out.len();
    loop {
        start -= 1;
        out[start] = b'0' + (number % 10) as u8;
        number /= 10;
        if number == 0 {
            return start;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn bits_are_written_as_the_standard_library_writes_them(word: u64, width in 1u32..=64) {
            let word = word & crate::base::word::mask(width);
            let mut out = [b'?'; 64];
            put_bits(&mut out, word, width);
            let expected = format!("{word:0width$b}", width = width as usize);
            prop_assert_eq!(&out[..width as usize], expected.as_bytes());
        }

        #[test]
        fn numbers_are_written_as_the_standard_library_writes_them(number: u64, shift in 0u32..64) {
            let number = number >> shift;
            let mut out = [0; 20];
            let start = put_decimal(&mut out, number);
            prop_assert_eq!(out[start..].to_vec(), number.to_string().into_bytes());
        }
    }
}
