//! A CSV file that is read more than once.

use std::fs::File;
use std::io::{self, BufRead, BufReader, Seek};
use std::path::{Path, PathBuf};

use sha2::{Digest, Sha256};

use super::description::hex;
use crate::base::{Diagnostic, Report};
use crate::files;

/// A CSV file, or what a pipe has brought.
pub struct CsvFile {
    path: PathBuf,
    /// One reader at a time: they share the place in the file.
    file: File,
    sha256: String,
}

impl CsvFile {
    /// Opens a file; reads a pipe to its end, into a temporary file without a name.
    ///
    /// # Errors
    /// `C002`.
    pub fn open(path: &Path) -> Result<Self, Report> {
        let opened = || {
            let mut file = File::open(path)?;
            let about = file.metadata()?;
            if about.is_dir() {
                return Err(io::Error::other("it is a directory"));
            }
            if !about.is_file() {
                let mut copy = tempfile::tempfile()?;
                io::copy(&mut file, &mut copy)?;
                file = copy;
            }
            let sha256 = hash(&file)?;
            Ok(Self { path: path.to_owned(), file, sha256 })
        };
        opened().map_err(|error| files::unreadable(path, &files::reason(&error)).into())
    }

    /// Reads it from the start. Lines may have any number of values.
    ///
    /// # Errors
    /// `C002`.
    pub fn reader(&self) -> Result<csv::Reader<File>, Report> {
        let from_start = || {
            let mut file = self.file.try_clone()?;
            file.rewind().map(|()| file)
        };
        let file = from_start().map_err(|error| files::unreadable(&self.path, &files::reason(&error)))?;
        Ok(csv::ReaderBuilder::new().trim(csv::Trim::All).flexible(true).from_reader(file))
    }

    /// The hash of its bytes.
    pub fn sha256(&self) -> &str {
        &self.sha256
    }

    /// `C065`: it cannot be read as CSV.
    pub fn wrong(&self, error: &csv::Error) -> Report {
        Diagnostic::new("C065", format!("{}: {error}", self.path.display()))
            .help("the first line names inputs, every other line has a number for each of them")
            .into()
    }
}

fn hash(mut file: &File) -> io::Result<String> {
    file.rewind()?;
    let mut reader = BufReader::with_capacity(1 << 16, file);
    let mut hasher = Sha256::new();
    loop {
        let bytes = reader.fill_buf()?;
        if bytes.is_empty() {
            return Ok(hex(hasher));
        }
        hasher.update(bytes);
        let read = bytes.len();
        reader.consume(read);
    }
}
