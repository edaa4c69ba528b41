//! The contents of a ROM or a RAM, held as bits.

use bitvec::{field::BitField, order::Lsb0, vec::BitVec};

/// `depth` words of `width` bits each (1 to 64), word 0 first, least significant bit first.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub struct MemoryImage {
    width: u32,
    bits: BitVec<u64, Lsb0>,
}

impl MemoryImage {
    /// An image that holds `words`; bits above `width` are refused.
    ///
    /// # Panics
    /// When a word has a bit above `width`: a block's table is wrong, not the user's input.
    #[must_use]
    pub fn from_words(width: u32, words: impl IntoIterator<Item = u64>) -> Self {
        let mut bits = BitVec::new();
        for word in words {
            assert_eq!(word & !super::word::mask(width), 0, "the word {word} is wider than {width} bits");
            let start = bits.len();
            bits.resize(start + width as usize, false);
            bits[start..].store_le(word);
        }
        Self { width, bits }
    }

    /// Word width in bits.
    #[must_use]
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Number of words.
    #[must_use]
    pub fn depth(&self) -> usize {
        self.bits.len() / self.width as usize
    }

    /// The words in order of address.
    pub fn words(&self) -> impl Iterator<Item = u64> + '_ {
        self.bits.chunks_exact(self.width as usize).map(|word| word.load_le::<u64>())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_image_gives_back_its_words_at_every_width() {
        for width in 1..=64 {
            let words: Vec<u64> =
                (0..70).map(|i: u64| i.wrapping_mul(0x9E37_79B9_7F4A_7C15) & super::super::word::mask(width)).collect();
            let image = MemoryImage::from_words(width, words.iter().copied());
            assert_eq!(image.depth(), 70);
            assert_eq!(image.words().collect::<Vec<_>>(), words);
        }
    }
}
