//! What waveforms are read from, and which format it has.

use std::fs::File;
use std::io::{BufRead, BufReader, Cursor, Read, Seek};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::fst::FstSource;
use super::source::Source;
use super::vcd::VcdSource;
use crate::base::{Diagnostic, Report};

/// A waveform file, or the bytes of one, that can be read more than once.
#[derive(Clone, Debug)]
pub struct Input {
    name: String,
    from: From,
}

#[derive(Clone, Debug)]
enum From {
    File(PathBuf),
    Bytes(Arc<[u8]>),
}

/// What formats are read from.
trait Bytes: BufRead + Seek + Send {}
impl<T: BufRead + Seek + Send> Bytes for T {}

impl Input {
    /// A file; messages call it by its path.
    #[must_use]
    pub fn file(path: &Path) -> Self {
        Self { name: path.display().to_string(), from: From::File(path.to_owned()) }
    }

    /// Bytes, and what messages call them.
    #[must_use]
    pub fn bytes(name: &str, bytes: impl Into<Arc<[u8]>>) -> Self {
        Self { name: name.to_owned(), from: From::Bytes(bytes.into()) }
    }

    /// What messages call it.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    pub(super) fn open(&self) -> Result<Box<dyn Source>, Report> {
        let bytes: Box<dyn Bytes> = match &self.from {
            From::File(path) => {
                Box::new(BufReader::new(File::open(path).map_err(|error| unreadable(&self.name, &error))?))
            }
            From::Bytes(bytes) => Box::new(Cursor::new(Arc::clone(bytes))),
        };
        self.of_its_kind(bytes)
    }

    fn of_its_kind(&self, mut bytes: Box<dyn Bytes>) -> Result<Box<dyn Source>, Report> {
        if is_fst(&mut bytes).map_err(|error| unreadable(&self.name, &error))? {
            return Ok(Box::new(FstSource::open(&self.name, bytes)?));
        }
        Ok(Box::new(VcdSource::open(&self.name, bytes)?))
    }
}

/// Whether these are the first bytes of an FST file: a header block, or a packed file.
pub(super) fn is_fst(input: &mut impl BufRead) -> std::io::Result<bool> {
    Ok(matches!(input.fill_buf()?.first(), Some(0 | 254)))
}

pub(super) fn unreadable(name: &str, error: &std::io::Error) -> Diagnostic {
    Diagnostic::new("W017", format!("{name}: cannot be read: {error}"))
}

/// The longest FST file that is read from something that cannot seek, in bytes.
const LONGEST_STREAMED: u64 = 64 << 20;

/// A waveform from something that is read only once.
pub(super) fn open<'a>(name: &str, mut input: impl BufRead + 'a) -> Result<Box<dyn Source + 'a>, Report> {
    if !is_fst(&mut input).map_err(|error| unreadable(name, &error))? {
        return Ok(Box::new(VcdSource::open(name, input)?));
    }
    let mut bytes = Vec::new();
    input.take(LONGEST_STREAMED + 1).read_to_end(&mut bytes).map_err(|error| unreadable(name, &error))?;
    if bytes.len() as u64 > LONGEST_STREAMED {
        let message = format!("{name}: an FST file of more than {} MiB is read from disk only", LONGEST_STREAMED >> 20);
        return Err(Diagnostic::new("W019", message).help("write it to a file first").into());
    }
    Ok(Box::new(FstSource::open(name, Box::new(Cursor::new(bytes)))?))
}
