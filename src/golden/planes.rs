//! Planes: bits of a value in words of 64.

/// How many words of 64 bits a plane of `width` bits takes.
pub(super) fn words_of(width: u32) -> usize {
    (width as usize).div_ceil(64)
}

/// The bits of the last word of a plane that count.
pub(super) fn last_mask(width: u32) -> u64 {
    u64::MAX >> (width.wrapping_neg() & 63)
}
