//! A stream to go back and forth in, which it cannot: its bytes wait in a temporary file without a name.

use std::fs::File;
use std::io::{self, BufWriter, Seek, Write};
use std::path::Path;

use super::output::Out;
use super::unwritable;
use crate::base::Report;

/// `out` itself where it can be gone back and forth in, else a temporary file that goes into it at the end.
///
/// # Errors
/// When there is no room for temporary files.
pub fn seekable<'o>(mut out: Box<dyn Out + 'o>) -> io::Result<Box<dyn Out + 'o>> {
    if out.stream_position().is_ok() {
        return Ok(out);
    }
    Ok(Box::new(Spool { file: BufWriter::new(tempfile::tempfile()?), out }))
}

struct Spool<'o> {
    file: BufWriter<File>,
    out: Box<dyn Out + 'o>,
}

impl Out for Spool<'_> {
    fn commit(mut self: Box<Self>) -> Result<(), Report> {
        let copied = self.file.rewind().and_then(|()| io::copy(self.file.get_mut(), &mut self.out));
        copied.map_err(|error| unwritable(Path::new(&self.out.name()), &error))?;
        self.out.commit()
    }

    fn name(&self) -> String {
        self.out.name()
    }
}

impl Write for Spool<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.file.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}

impl Seek for Spool<'_> {
    fn seek(&mut self, to: io::SeekFrom) -> io::Result<u64> {
        self.file.seek(to)
    }
}
