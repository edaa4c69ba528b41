//! A result that is read again and then forgotten: a temporary file without a name, which nothing can leave behind.

use std::fs::File;
use std::io::{self, BufWriter, Read, Seek, SeekFrom, Write};
use std::path::Path;
use std::sync::{Arc, Mutex, PoisonError};

use super::output::Out;
use super::unwritable;
use crate::base::Report;

/// A temporary file; its clones are the same one.
#[derive(Clone, Debug)]
pub struct Scratch {
    file: Arc<Mutex<File>>,
}

/// What messages call it.
const NAME: &str = "a temporary file";

impl Scratch {
    /// An empty one.
    ///
    /// # Errors
    /// `C003`.
    pub fn create() -> Result<Self, Report> {
        let file = tempfile::tempfile().map_err(|error| unwritable(Path::new(NAME), &error))?;
        Ok(Self { file: Arc::new(Mutex::new(file)) })
    }

    /// Writes it, from the beginning on.
    #[must_use]
    pub fn writer(&self) -> Box<dyn Out> {
        Box::new(Writer(BufWriter::new(self.reader())))
    }

    /// Reads it from the beginning; each reader stands where it stands.
    #[must_use]
    pub fn reader(&self) -> ScratchReader {
        ScratchReader { file: Arc::clone(&self.file), at: 0 }
    }
}

/// A place in a temporary file, to read from and to write at.
#[derive(Debug)]
pub struct ScratchReader {
    file: Arc<Mutex<File>>,
    at: u64,
}

impl ScratchReader {
    /// Does something to the file here, and goes on by as many bytes as that says.
    fn here(&mut self, work: impl FnOnce(&mut File) -> io::Result<usize>) -> io::Result<usize> {
        let mut file = self.file.lock().unwrap_or_else(PoisonError::into_inner);
        file.seek(SeekFrom::Start(self.at))?;
        let done = work(&mut file)?;
        self.at += done as u64;
        Ok(done)
    }
}

impl Read for ScratchReader {
    fn read(&mut self, bytes: &mut [u8]) -> io::Result<usize> {
        self.here(|file| file.read(bytes))
    }
}

impl Write for ScratchReader {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.here(|file| file.write(bytes))
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl Seek for ScratchReader {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        let to = match to {
            SeekFrom::Current(by) => {
                SeekFrom::Start(self.at.checked_add_signed(by).ok_or(io::ErrorKind::InvalidInput)?)
            }
            to => to,
        };
        self.at = self.file.lock().unwrap_or_else(PoisonError::into_inner).seek(to)?;
        Ok(self.at)
    }
}

struct Writer(BufWriter<ScratchReader>);

impl Out for Writer {
    fn commit(mut self: Box<Self>) -> Result<(), Report> {
        self.0.flush().map_err(|error| unwritable(Path::new(NAME), &error).into())
    }

    fn name(&self) -> String {
        NAME.to_owned()
    }
}

impl Write for Writer {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.0.flush()
    }
}

impl Seek for Writer {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        self.0.seek(to)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_written_is_read_by_several_at_once_each_at_its_own_place() {
        let scratch = Scratch::create().unwrap();
        let mut writer = scratch.writer();
        writer.write_all(b"abcdef").unwrap();
        writer.commit().unwrap();
        let [mut first, mut second] = [scratch.reader(), scratch.reader()];
        let mut two = [0; 2];
        let mut next = |reader: &mut ScratchReader| reader.read_exact(&mut two).map(|()| two).unwrap();
        assert_eq!([next(&mut first), next(&mut second), next(&mut first)], [*b"ab", *b"ab", *b"cd"]);
        first.seek(SeekFrom::Current(-3)).unwrap();
        assert_eq!(next(&mut first), *b"bc");
        assert_eq!(second.seek(SeekFrom::End(-1)).unwrap(), 5);
        assert!(second.seek(SeekFrom::Current(-6)).is_err());
    }
}
