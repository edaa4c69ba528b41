//! Where rows go, and how a file that an interrupted sweep left is gone on with.
//!
//! Unlike other results the file is written in place, not aside: what is done of a long sweep must be there after
//! whatever ended it. Rows are in order, so that their number says where to go on; a torn last line is dropped.

use std::fs::{File, OpenOptions};
use std::io::{self, BufRead, BufReader, BufWriter, Seek, SeekFrom, Write};
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

use super::SweepArguments;
use super::rows::Rows;
use super::stimuli::Stimuli;
use crate::base::{Diagnostic, Report};
use crate::files;

/// A file of rows, or standard output.
pub struct Output {
    path: Option<PathBuf>,
    to: BufWriter<Box<dyn Write + Send>>,
    error: Option<io::Error>,
}

impl Output {
    fn new(path: Option<&Path>, to: Box<dyn Write + Send>) -> Self {
        Self { path: path.map(Path::to_owned), to: BufWriter::with_capacity(1 << 18, to), error: None }
    }

    /// Writes some lines; breaks off when they cannot be written.
    pub fn write(&mut self, text: &str) -> ControlFlow<()> {
        match self.to.write_all(text.as_bytes()) {
            Ok(()) => ControlFlow::Continue(()),
            Err(error) => {
                self.error = Some(error);
                ControlFlow::Break(())
            }
        }
    }

    /// Writes what is left. `false` when the reader of standard output has gone away, which is no error.
    pub fn finish(mut self) -> Result<bool, Report> {
        let error = self.error.take().or_else(|| self.to.flush().err());
        match (error, self.path) {
            (None, _) => Ok(true),
            (Some(error), Some(path)) => Err(files::unwritable(&path, &error).into()),
            (Some(error), None) if error.kind() == io::ErrorKind::BrokenPipe => Ok(false),
            (Some(error), None) => Err(files::unwritable(Path::new("standard output"), &error).into()),
        }
    }
}

/// Opens the output and tells how many rows it has already.
///
/// # Errors
/// `C003` what cannot be written, `C066` a file that this sweep cannot have left.
pub fn open(arguments: &SweepArguments, rows: &Rows, stimuli: &Stimuli) -> Result<(Output, u64), Report> {
    let header = rows.header().unwrap_or_default();
    let Some(path) = arguments.out.as_deref() else {
        let mut output = Output::new(None, Box::new(io::stdout()));
        let _ = output.write(&header);
        return Ok((output, 0));
    };
    let wrong = |error: io::Error| Report::from(files::unwritable(path, &error));
    let mut options = OpenOptions::new();
    options.read(arguments.resume).write(true).create(true).truncate(!arguments.resume);
    let mut file = options.open(path).map_err(wrong)?;
    let left = if arguments.resume { Left::of(&file).map_err(wrong)? } else { Left::default() };
    let done = left.check(path, rows, stimuli)?;
    if arguments.resume {
        file.set_len(left.bytes).and_then(|()| file.seek(SeekFrom::End(0))).map_err(wrong)?;
    }
    let mut output = Output::new(Some(path), Box::new(file));
    if left.lines == 0 {
        let _ = output.write(&header);
    }
    Ok((output, done))
}

/// The whole lines of a file.
#[derive(Default)]
struct Left {
    lines: u64,
    bytes: u64,
    first: Vec<u8>,
    last: Vec<u8>,
}

impl Left {
    fn of(file: &File) -> io::Result<Self> {
        let mut reader = BufReader::with_capacity(1 << 18, file);
        let mut left = Self::default();
        let mut line = Vec::new();
        while reader.read_until(b'\n', &mut line)? > 0 && line.ends_with(b"\n") {
            left.lines += 1;
            left.bytes += line.len() as u64;
            if left.lines == 1 {
                left.first.clone_from(&line);
            }
            std::mem::swap(&mut left.last, &mut line);
            line.clear();
        }
        Ok(left)
    }

    /// How many rows there are; an error if the header or the last row is not of this sweep.
    fn check(&self, path: &Path, rows: &Rows, stimuli: &Stimuli) -> Result<u64, Report> {
        let header = rows.header();
        let done = self.lines.saturating_sub(u64::from(header.is_some()));
        let foreign = |what: String| {
            let message = format!("{} is not of this sweep: {what}", path.display());
            Report::from(
                Diagnostic::new("C066", message).help("resume with the command that began it, or leave out --resume"),
            )
        };
        if let Some(header) = header.filter(|header| self.lines > 0 && header.as_bytes() != self.first) {
            return Err(foreign(format!("its header is not {}", header.trim_end())));
        }
        if done > stimuli.count() {
            return Err(foreign(format!("it has {done} rows, and there are {} stimuli", stimuli.count())));
        }
        if done > 0 {
            let mut words = vec![0; stimuli.inputs()];
            let is_one = stimuli.feed(done - 1)?(&mut words);
            if !is_one || !self.last.starts_with(rows.beginning(&words).as_bytes()) {
                return Err(foreign(format!("row {done} has other inputs")));
            }
        }
        Ok(done)
    }
}
