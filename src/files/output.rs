//! Results written: files aside at first, under their name only once they are whole; standard output as it comes.

use std::fs;
use std::io::{self, BufWriter, Seek, Write};
use std::path::{Path, PathBuf};

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

/// A file being written: aside at first, under its name only once it is whole. The path `-` is standard output.
#[derive(Debug)]
pub struct Output {
    path: PathBuf,
    sink: BufWriter<Sink>,
}

#[derive(Debug)]
enum Sink {
    Aside(tempfile::NamedTempFile),
    /// A device or pipe such as /dev/null, which a rename would replace.
    Special(fs::File),
    Standard(io::Stdout),
}

impl Output {
    /// Begins to write `path`.
    ///
    /// # Errors
    /// `C003`: its folder is missing or not writable.
    pub fn create(path: &Path) -> Result<Self, Report> {
        let sink = Self::sink(path).map_err(|error| unwritable(path, &error))?;
        Ok(Self { path: path.to_owned(), sink: BufWriter::new(sink) })
    }

    fn sink(path: &Path) -> io::Result<Sink> {
        if path == Path::new("-") {
            return Ok(Sink::Standard(io::stdout()));
        }
        match fs::metadata(path) {
            Ok(about) if about.is_dir() => Err(io::Error::other("it is a directory")),
            Ok(about) if !about.is_file() => fs::File::create(path).map(Sink::Special),
            _ => {
                let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
                let mut aside = tempfile::Builder::new();
                readable_by_all(&mut aside);
                aside.prefix(".stepwright-").tempfile_in(folder).map(Sink::Aside)
            }
        }
    }
}

impl Out for Output {
    fn commit(self: Box<Self>) -> Result<(), Report> {
        let path = self.path;
        let mut sink = self.sink.into_inner().map_err(|error| unwritable(&path, error.error()))?;
        sink.flush().map_err(|error| unwritable(&path, &error))?;
        match sink {
            Sink::Aside(file) => file.persist(&path).map(drop).map_err(|error| unwritable(&path, &error.error).into()),
            Sink::Special(_) | Sink::Standard(_) => Ok(()),
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

impl Sink {
    fn writer(&mut self) -> &mut dyn Write {
        match self {
            Sink::Aside(file) => file,
            Sink::Special(file) => file,
            Sink::Standard(out) => out,
        }
    }
}

impl Write for Sink {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.writer().write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.writer().flush()
    }
}

impl Seek for Output {
    fn seek(&mut self, to: io::SeekFrom) -> io::Result<u64> {
        self.sink.flush()?;
        match self.sink.get_mut() {
            Sink::Aside(file) => file.seek(to),
            Sink::Special(file) => file.seek(to),
            Sink::Standard(_) => Err(io::Error::other("this format has to go back and forth in its file: name a file")),
        }
    }
}

/// Temporary files are private by default; a result is an ordinary file, cut by the user's umask.
#[cfg(unix)]
fn readable_by_all(aside: &mut tempfile::Builder<'_, '_>) {
    use std::os::unix::fs::PermissionsExt;
    aside.permissions(fs::Permissions::from_mode(0o666));
}

#[cfg(not(unix))]
fn readable_by_all(_: &mut tempfile::Builder<'_, '_>) {}

/// Writes a whole file.
///
/// # Errors
/// `C003`.
pub fn write_bytes(path: &Path, bytes: &[u8]) -> Result<(), Report> {
    let mut output = Output::create(path)?;
    output.write_all(bytes).map_err(|error| unwritable(path, &error))?;
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
