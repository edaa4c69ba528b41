//! The contents of a ROM or a RAM.

use std::sync::Arc;

/// `depth` words of `width` bits each (1 to 64), word 0 first. Clones share the words, so that a thousand instances of
/// one table cost as much memory as one.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub struct MemoryImage {
    width: u32,
    words: Arc<[u64]>,
}

impl MemoryImage {
    /// An image that holds `words`; bits above `width` are refused.
    ///
    /// # Panics
    /// When a word has a bit above `width`: a block's table is wrong, not the user's input.
    #[must_use]
    pub fn from_words(width: u32, words: impl IntoIterator<Item = u64>) -> Self {
        let words: Arc<[u64]> = words.into_iter().collect();
        let wide = words.iter().find(|word| **word & !super::word::mask(width) != 0);
        assert_eq!(wide, None, "a word is wider than {width} bits");
        Self { width, words }
    }

    /// Word width in bits.
    #[must_use]
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Number of words.
    #[must_use]
    pub fn depth(&self) -> usize {
        self.words.len()
    }

    /// The words in order of address.
    #[must_use]
    pub fn words(&self) -> &[u64] {
        &self.words
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
            assert_eq!(image.words(), words);
        }
    }

    #[test]
    fn clones_share_their_words() {
        let image = MemoryImage::from_words(8, [1, 2, 3]);
        assert!(std::ptr::eq(image.clone().words(), image.words()));
    }
}
