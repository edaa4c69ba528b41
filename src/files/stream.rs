//! What is written through as it comes: standard output, devices, pipes.

use std::fs::File;
use std::io::{self, Write};
use std::sync::atomic::{AtomicUsize, Ordering};

/// How many writes are under way.
static WRITES: AtomicUsize = AtomicUsize::new(0);

/// Whether a write into a stream is under way: one that nobody reads keeps its writer waiting.
#[must_use]
pub fn is_waiting() -> bool {
    WRITES.load(Ordering::Relaxed) > 0
}

/// Standard output, a device, or a pipe.
#[derive(Debug)]
pub enum Stream {
    /// Standard output.
    Standard(io::Stdout),
    /// Another one, that has been opened.
    Opened(File),
}

impl Stream {
    fn waiting<T>(&mut self, write: impl FnOnce(&mut dyn Write) -> io::Result<T>) -> io::Result<T> {
        WRITES.fetch_add(1, Ordering::Relaxed);
        let written = match self {
            Stream::Standard(out) => write(out),
            Stream::Opened(file) => write(file),
        };
        WRITES.fetch_sub(1, Ordering::Relaxed);
        written
    }
}

impl Write for Stream {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.waiting(|out| out.write(bytes))
    }

    fn flush(&mut self) -> io::Result<()> {
        self.waiting(|out| out.flush())
    }
}

/// Writes a text to standard output.
///
/// # Errors
/// Those of standard output.
pub fn print(text: &str) -> io::Result<()> {
    let mut out = Stream::Standard(io::stdout());
    out.write_all(text.as_bytes())?;
    out.flush()
}
