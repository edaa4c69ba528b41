//! Outputs: files aside at first, under their name only once they are whole; streams as it comes.

use std::fs::OpenOptions;
use std::io::{self, BufWriter, Read, Seek, Write};
use std::path::{Path, PathBuf};

use super::aside::Aside;
use super::place::Place;
use super::stream::Stream;
use super::unwritable;
use crate::base::Report;

/// Where a result goes: a file, standard output, memory.
pub trait Out: Write + Seek {
    /// Makes what was written final: a file gets its name.
    ///
    /// # Errors
    /// `C003`; nothing is left behind then.
    fn commit(self: Box<Self>) -> Result<(), Report>;

    /// What messages call it.
    fn name(&self) -> String;
}

/// Memory, for results that are looked at rather than kept.
impl Out for io::Cursor<&mut Vec<u8>> {
    fn commit(self: Box<Self>) -> Result<(), Report> {
        Ok(())
    }

    fn name(&self) -> String {
        "memory".to_owned()
    }
}

/// A file being written: aside at first, under its name only once it is whole. The path `-` is standard output; links
/// are followed, devices and pipes written through. A file that was there before keeps its owner and mode.
#[derive(Debug)]
pub struct Output {
    path: PathBuf,
    sink: BufWriter<Sink>,
}

#[derive(Debug)]
enum Sink {
    Aside(Aside),
    Stream(Stream),
}

impl Output {
    /// Begins to write `path`.
    ///
    /// # Errors
    /// `C003` a directory, a read-only file, a folder that is missing or not writable; `C031` another program is
    /// writing it.
    pub fn create(path: &Path) -> Result<Self, Report> {
        let sink = match Place::of(path).map_err(|error| unwritable(path, &error))? {
            Place::File(target) => Sink::Aside(Aside::create(target)?),
            Place::Standard => Sink::Stream(Stream::Standard(io::stdout())),
            Place::Stream(target) => Sink::Stream(opened(&target).map_err(|error| unwritable(path, &error))?),
        };
        Ok(Self { path: path.to_owned(), sink: BufWriter::new(sink) })
    }
}

/// Opens a device or a pipe.
pub(super) fn opened(target: &Path) -> io::Result<Stream> {
    OpenOptions::new().write(true).open(target).map(Stream::Opened)
}

impl Out for Output {
    fn commit(self: Box<Self>) -> Result<(), Report> {
        let wrong = |error: &io::Error| Report::from(unwritable(&self.path, error));
        let mut sink = self.sink.into_inner().map_err(|error| wrong(error.error()))?;
        sink.flush().map_err(|error| wrong(&error))?;
        match sink {
            Sink::Aside(file) => file.commit().map_err(|error| wrong(&error)),
            Sink::Stream(_) => Ok(()),
        }
    }

    fn name(&self) -> String {
        self.path.display().to_string()
    }
}

impl Write for Output {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.sink.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.sink.flush()
    }
}

impl Write for Sink {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self {
            Sink::Aside(file) => file.write(bytes),
            Sink::Stream(stream) => stream.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match self {
            Sink::Aside(file) => file.flush(),
            Sink::Stream(stream) => stream.flush(),
        }
    }
}

impl Seek for Output {
    fn seek(&mut self, to: io::SeekFrom) -> io::Result<u64> {
        self.sink.flush()?;
        match self.sink.get_mut() {
            Sink::Aside(file) => file.seek(to),
            Sink::Stream(_) => Err(io::ErrorKind::NotSeekable.into()),
        }
    }
}

/// Writes a whole file.
///
/// # Errors
/// `C003`, `C031`.
pub fn write_bytes(path: &Path, mut bytes: &[u8]) -> Result<(), Report> {
    copy(&mut bytes, path)
}

/// Writes a whole file from something that is read.
///
/// # Errors
/// `C003`, `C031`.
pub fn copy(from: &mut impl Read, path: &Path) -> Result<(), Report> {
    let mut output = Output::create(path)?;
    io::copy(from, &mut output).map_err(|error| unwritable(path, &error))?;
    Box::new(output).commit()
}

/// How a file that stands at `near` may name the file `path`: just by its name in the same folder.
#[must_use]
pub fn seen_from(near: &Path, path: &Path) -> String {
    let name = path.file_name().filter(|_| near.parent() == path.parent());
    match name {
        Some(name) => name.to_string_lossy().into_owned(),
        None => std::path::absolute(path).unwrap_or_else(|_| path.to_owned()).display().to_string(),
    }
}
