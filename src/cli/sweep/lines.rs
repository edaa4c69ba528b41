//! What a file of rows holds, counted without keeping it.

use std::io::{self, BufRead, BufReader, Read};

use super::rows::Format;

/// The longest line that is taken for a row; a circuit's ports and their numbers stay far below it.
const LONGEST: u64 = 1 << 20;

/// The whole lines of a file.
#[derive(Clone, Default)]
pub struct Lines {
    /// The first line, where the format has a header.
    pub header: Option<Vec<u8>>,
    /// How many rows there are.
    pub rows: u64,
    /// How many of those reached the limit.
    pub at_limit: u64,
    /// How long all lines are together.
    pub bytes: u64,
    /// The last line.
    pub last: Vec<u8>,
    /// Whether something follows that is no whole line.
    pub is_torn: bool,
}

impl Lines {
    /// Those of a file, from where it stands.
    ///
    /// # Errors
    /// When it cannot be read.
    pub fn of(file: impl Read, format: Format) -> io::Result<Self> {
        let mut reader = BufReader::with_capacity(1 << 18, file);
        let mut lines = Self::default();
        let mut line = Vec::new();
        while reader.by_ref().take(LONGEST).read_until(b'\n', &mut line)? > 0 && line.ends_with(b"\n") {
            lines.bytes += line.len() as u64;
            if lines.header.is_none() && format == Format::Csv {
                lines.header = Some(line.clone());
            } else {
                lines.rows += 1;
                lines.at_limit += u64::from(format.is_at_limit(&line));
            }
            std::mem::swap(&mut lines.last, &mut line);
            line.clear();
        }
        lines.is_torn = !line.is_empty();
        Ok(lines)
    }
}
