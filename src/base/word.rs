//! Words of 1 to 64 bits, held in the low bits of a `u64`; the bits above the width are always 0.

/// The widest word of the simulator, in bits.
pub const MAX_WIDTH: u32 = 64;

/// All ones in the low `width` bits. `width` is 0 to 64.
#[must_use]
pub const fn mask(width: u32) -> u64 {
    match width {
        0 => 0,
        1..MAX_WIDTH => (1 << width) - 1,
        _ => u64::MAX,
    }
}

/// The two's-complement value of a word of `width` bits (1 to 64).
#[must_use]
pub const fn signed(word: u64, width: u32) -> i64 {
    let shift = MAX_WIDTH - width;
    ((word << shift) as i64) >> shift
}

/// The word of `width` bits that holds `value`, or `None` when it does not fit.
///
/// A signed word holds `-2^(width-1) .. 2^(width-1)`, an unsigned one `0 .. 2^width`.
#[must_use]
pub fn encode(value: i128, width: u32, is_signed: bool) -> Option<u64> {
    let (low, high) = range(width, is_signed);
    (low..=high).contains(&value).then_some(value as u64 & mask(width))
}

/// The number that a word stands for.
#[must_use]
pub fn decode(word: u64, width: u32, is_signed: bool) -> i128 {
    if is_signed { signed(word, width).into() } else { word.into() }
}

/// The smallest and the largest number a word can hold.
#[must_use]
pub fn range(width: u32, is_signed: bool) -> (i128, i128) {
    if is_signed { (-(1 << (width - 1)), (1 << (width - 1)) - 1) } else { (0, i128::from(mask(width))) }
}

/// The least number of bits that can count `count` states: Verilog's `$clog2` (0 for 0 and 1).
#[must_use]
pub const fn clog2(count: u64) -> u32 {
    if count <= 1 { 0 } else { u64::BITS - (count - 1).leading_zeros() }
}

/// The number that a string is in Verilog (IEEE 1364-2005, 3.6): 8 bits a letter, the last one lowest. `None` for no
/// letter, more than eight, or one that is not printable ASCII or that Verilog would escape.
#[must_use]
pub fn of_letters(letters: &str) -> Option<u64> {
    let plain = |letter: u8| letter.is_ascii_graphic() && !b"\\\"".contains(&letter);
    let good = (1..=8).contains(&letters.len()) && letters.bytes().all(plain);
    good.then(|| letters.bytes().fold(0, |number, letter| number << 8 | u64::from(letter)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mask_has_as_many_ones_as_the_width() {
        for width in 0..=64 {
            assert_eq!(mask(width).count_ones(), width);
        }
    }

    #[test]
    fn encoding_and_decoding_are_inverse_at_the_ends_of_the_range() {
        for width in 1..=64 {
            for is_signed in [false, true] {
                let (low, high) = range(width, is_signed);
                for value in [low, high] {
                    let word = encode(value, width, is_signed).expect("in range");
                    assert_eq!(decode(word, width, is_signed), value);
                }
                assert_eq!(encode(low - 1, width, is_signed), None);
                assert_eq!(encode(high + 1, width, is_signed), None);
            }
        }
    }

    #[test]
    fn clog2_follows_the_verilog_standard() {
        // IEEE 1364-2005, 17.11.1: the ceiling of the logarithm; an argument of 0 gives 0.
        for (count, bits) in [(0, 0), (1, 0), (2, 1), (3, 2), (4, 2), (5, 3), (256, 8), (257, 9)] {
            assert_eq!(clog2(count), bits, "$clog2({count})");
        }
    }

    #[test]
    fn a_string_is_the_number_of_its_letters() {
        assert_eq!(of_letters("A"), Some(0x41));
        assert_eq!(of_letters("letters"), Some(0x6C_6574_7465_7273));
        assert_eq!(of_letters("~~~~~~~~"), Some(0x7E7E_7E7E_7E7E_7E7E));
        for no_number in ["", "ninechars", "a b", "\u{436}", "a\n", "a\\n", "a\"b"] {
            assert_eq!(of_letters(no_number), None, "{no_number:?}");
        }
    }
}
