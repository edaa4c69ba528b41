//! Memory images: what a memory holds, written down in a text file that stands beside the circuit.

use crate::base::{Diagnostic, MemoryImage, SourceId};

/// A kind of text file that a block's memory is loaded from when the circuit is elaborated.
///
/// The block has a parameter that names the file. Parameters are numbers, and so is a string in Verilog: its letters,
/// eight bits each, the last one lowest. 0, which is no string, stands for a memory of no words.
#[derive(Debug)]
pub struct ImageFormat {
    /// The parameter that names the file.
    pub parameter: &'static str,
    /// The ending of the file's name.
    pub ending: &'static str,
    /// What such a file holds, in a sentence.
    pub summary: &'static str,
    /// Reads a text into words; otherwise says all that is wrong with it, with places.
    pub read: fn(SourceId, &str) -> Result<MemoryImage, Vec<Diagnostic>>,
}

impl ImageFormat {
    /// The file name that the parameter's value stands for; `None` when it is no string of letters, digits and `_`.
    #[must_use]
    pub fn file_name(&self, value: i64) -> Option<String> {
        let letters: Vec<u8> = value.to_be_bytes().into_iter().skip_while(|&byte| byte == 0).collect();
        let plain = letters.iter().all(|byte| byte.is_ascii_alphanumeric() || *byte == b'_');
        let stem = String::from_utf8(letters).ok().filter(|stem| plain && !stem.is_empty())?;
        Some(format!("{stem}.{}", self.ending))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_is_the_name_that_verilog_packs_into_it() {
        let format = ImageFormat { parameter: "IMAGE", ending: "txt", summary: "", read: |_, _| Err(Vec::new()) };
        assert_eq!(format.file_name(0x41).as_deref(), Some("A.txt"));
        assert_eq!(format.file_name(0x61_5F39).as_deref(), Some("a_9.txt"));
        for no_name in [0, 0x61_0039, i64::MAX, -1, i64::from_be_bytes(*b"../etc/a")] {
            assert_eq!(format.file_name(no_name), None, "{no_name}");
        }
    }
}
