//! The words of a VCD file, in bounded memory.

use std::io::{self, Read};
use std::ops::Range;

/// The longest word; the widest vector that is read takes a quarter of it.
const LONGEST: usize = 1 << 18;

/// Words between blanks, and the line each stands in.
pub(super) struct Tokens<R> {
    input: R,
    buffer: Vec<u8>,
    /// What of the buffer has not been taken yet.
    rest: Range<usize>,
    line: u64,
}

/// Why there is no further word.
#[derive(Debug)]
pub(super) enum Broken {
    /// A word of more than 256 KiB.
    Long,
    /// The last word is not followed by a blank: it may have been longer.
    Cut,
    Unreadable(io::Error),
}

impl<R: Read> Tokens<R> {
    pub fn new(input: R) -> Self {
        Self { input, buffer: vec![0; LONGEST], rest: 0..0, line: 1 }
    }

    /// The line of the last word, counted from 1.
    pub fn line(&self) -> u64 {
        self.line
    }

    /// The next word; `None` at the end.
    pub fn next(&mut self) -> Result<Option<&[u8]>, Broken> {
        if !self.skip_blanks()? {
            return Ok(None);
        }
        let mut seen = 0;
        loop {
            let rest = &self.buffer[self.rest.clone()];
            if let Some(length) = rest[seen..].iter().position(|&byte| byte <= b' ') {
                let start = self.rest.start;
                self.rest.start += seen + length;
                return Ok(Some(&self.buffer[start..self.rest.start]));
            }
            seen = rest.len();
            if !self.fill()? {
                return Err(Broken::Cut);
            }
        }
    }

    /// Whether a word follows.
    fn skip_blanks(&mut self) -> Result<bool, Broken> {
        loop {
            for at in self.rest.clone() {
                match self.buffer[at] {
                    b'\n' => self.line += 1,
                    0..=b' ' => {}
                    _ => {
                        self.rest.start = at;
                        return Ok(true);
                    }
                }
            }
            self.rest = 0..0;
            if !self.fill()? {
                return Ok(false);
            }
        }
    }

    /// Reads more behind the rest; whether there was more.
    fn fill(&mut self) -> Result<bool, Broken> {
        self.buffer.copy_within(self.rest.clone(), 0);
        self.rest = 0..self.rest.len();
        if self.rest.end == self.buffer.len() {
            return Err(Broken::Long);
        }
        loop {
            match self.input.read(&mut self.buffer[self.rest.end..]) {
                Ok(count) => {
                    self.rest.end += count;
                    return Ok(count > 0);
                }
                Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
                Err(error) => return Err(Broken::Unreadable(error)),
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn words_and_their_lines_are_those_of_the_whole_text(text in "[ab\\n\\t ]{0,40}", piece in 1usize..7) {
            let text = text + "\n";
            struct Piecewise<'a>(&'a [u8], usize);
            impl Read for Piecewise<'_> {
                fn read(&mut self, to: &mut [u8]) -> io::Result<usize> {
                    let length = to.len().min(self.1);
                    self.0.read(&mut to[..length])
                }
            }
            let mut tokens = Tokens::new(Piecewise(text.as_bytes(), piece));
            let mut found = Vec::new();
            while let Some(word) = tokens.next().unwrap().map(<[u8]>::to_vec) {
                found.push((tokens.line() as usize, String::from_utf8(word).unwrap()));
            }
            let lines = text.lines().enumerate();
            let expected: Vec<_> = lines
                .flat_map(|(at, line)| line.split_whitespace().map(move |word| (at + 1, word.to_owned())))
                .collect();
            prop_assert_eq!(found, expected);
        }
    }

    #[test]
    fn a_word_without_end_is_refused_and_one_that_is_cut_is_told() {
        assert!(matches!(Tokens::new(io::repeat(b'a')).next(), Err(Broken::Long)));
        assert!(matches!(Tokens::new(&b" ab"[..]).next(), Err(Broken::Cut)));
    }
}
