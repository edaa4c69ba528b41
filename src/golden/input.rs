//! What waveforms are read from, and which format it has.

use std::fmt;
use std::fs::File;
use std::io::{self, BufRead, BufReader, Cursor, Read, Seek};
use std::path::Path;
use std::sync::Arc;

use super::fst::FstSource;
use super::source::Source;
use super::vcd::VcdSource;
use crate::base::{Diagnostic, Report};

/// What formats are read from.
trait Bytes: BufRead + Seek + Send {}
impl<T: BufRead + Seek + Send> Bytes for T {}

type Opener = dyn Fn() -> io::Result<Box<dyn Bytes>> + Send + Sync;

/// A waveform file, or something like one, that can be read more than once.
#[derive(Clone)]
pub struct Input {
    name: String,
    opener: Arc<Opener>,
}

impl Input {
    /// What `open` opens, every time at its beginning, and what messages call it.
    #[must_use]
    pub fn new<R: Read + Seek + Send + 'static>(
        name: &str,
        open: impl Fn() -> io::Result<R> + Send + Sync + 'static,
    ) -> Self {
        let opener = move || open().map(|input| Box::new(BufReader::with_capacity(1 << 16, input)) as Box<dyn Bytes>);
        Self { name: name.to_owned(), opener: Arc::new(opener) }
    }

    /// A file; messages call it by its path.
    #[must_use]
    pub fn file(path: &Path) -> Self {
        let name = path.display().to_string();
        let path = path.to_owned();
        Self::new(&name, move || File::open(&path))
    }

    /// Bytes, and what messages call them.
    #[must_use]
    pub fn bytes(name: &str, bytes: impl Into<Arc<[u8]>>) -> Self {
        let bytes = bytes.into();
        Self::new(name, move || Ok(Cursor::new(Arc::clone(&bytes))))
    }

    /// What messages call it.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    pub(super) fn open(&self) -> Result<Box<dyn Source>, Report> {
        self.of_its_kind((self.opener)().map_err(|error| unreadable(&self.name, &error))?)
    }

    fn of_its_kind(&self, mut bytes: Box<dyn Bytes>) -> Result<Box<dyn Source>, Report> {
        if is_fst(&mut bytes).map_err(|error| unreadable(&self.name, &error))? {
            return Ok(Box::new(FstSource::open(&self.name, bytes)?));
        }
        Ok(Box::new(VcdSource::open(&self.name, bytes)?))
    }
}

/// Whether these are the first bytes of an FST file: a header block, or a packed file.
pub(super) fn is_fst(input: &mut impl BufRead) -> io::Result<bool> {
    Ok(matches!(input.fill_buf()?.first(), Some(0 | 254)))
}

impl fmt::Debug for Input {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Input").field(&self.name).finish()
    }
}

pub(super) fn unreadable(name: &str, error: &io::Error) -> Diagnostic {
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
