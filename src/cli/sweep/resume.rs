//! Where rows go, and how a file that an interrupted sweep left is gone on with.
//!
//! Rows are in order, so that their number says where to go on; a torn last line is dropped. What sweep they are of
//! stands in the description beside them.

use std::fs::File;
use std::io::{self, BufRead, BufReader, BufWriter, Seek, SeekFrom, Write};
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use super::SweepArguments;
use super::description::Description;
use super::plan::Plan;
use super::rows::Rows;
use crate::base::{Diagnostic, Report};
use crate::files::{self, Lasting};

/// How long rows may stay in memory, which is what the kill of a sweep can lose.
const LATE: Duration = Duration::from_secs(1);

/// A file of rows, or standard output.
pub struct Output {
    path: PathBuf,
    to: BufWriter<Box<dyn Write + Send>>,
    flushed: Instant,
    error: Option<io::Error>,
}

impl Output {
    /// Writes some lines; breaks off when they cannot be written.
    pub fn write(&mut self, text: &str) -> ControlFlow<()> {
        let mut written = self.to.write_all(text.as_bytes());
        if written.is_ok() && self.flushed.elapsed() > LATE {
            written = self.to.flush();
            self.flushed = Instant::now();
        }
        match written {
            Ok(()) => ControlFlow::Continue(()),
            Err(error) => {
                self.error = Some(error);
                ControlFlow::Break(())
            }
        }
    }

    /// Writes what is left.
    ///
    /// # Errors
    /// `C003`, also when a line before could not be written.
    pub fn finish(mut self) -> Result<(), Report> {
        let error = self.error.take().or_else(|| self.to.flush().err());
        error.map_or(Ok(()), |error| Err(files::unwritable(&self.path, &error).into()))
    }
}

/// The whole lines of a file.
#[derive(Clone, Default)]
pub struct Left {
    /// How many of them are rows.
    pub rows: u64,
    /// How many of those reached the limit.
    pub at_limit: u64,
    has_header: bool,
    bytes: u64,
    last: Vec<u8>,
}

/// Opens the output and tells what it has already, which is nothing unless it `resume`s.
///
/// # Errors
/// `C003` what cannot be written, `C031` what another sweep is writing, `C066` a file that this sweep cannot have
/// left.
pub fn open(path: &Path, arguments: &SweepArguments, plan: &Plan) -> Result<(Output, Left), Report> {
    let part = plan.first();
    let batch = part.batch(arguments)?;
    let rows = &plan.written(part, &batch, arguments);
    let description = &Description::new(arguments, part);
    let wrong = |error: io::Error| Report::from(files::unwritable(path, &error));
    let mut left = Left::default();
    let to: Box<dyn Write + Send> = match Lasting::open(path)? {
        Lasting::Stream(_) if arguments.resume => {
            let message = format!("there is nothing to go on with in {}, which is no file", path.display());
            return Err(Diagnostic::new("C066", message).into());
        }
        Lasting::Stream(stream) => Box::new(stream),
        Lasting::File(mut file) => {
            if arguments.resume {
                left = Left::of(&file, rows).map_err(wrong)?;
                left.check(path, rows, description)?;
                left.check_last(path, arguments, plan)?;
            }
            file.set_len(left.bytes).and_then(|()| file.seek(SeekFrom::End(0))).map_err(wrong)?;
            if left.bytes == 0 {
                description.write(path)?;
            }
            Box::new(file)
        }
    };
    let to = BufWriter::with_capacity(1 << 18, to);
    let mut output = Output { path: path.to_owned(), to, flushed: Instant::now(), error: None };
    if left.bytes == 0 {
        let _ = output.write(&rows.header().unwrap_or_default());
    }
    Ok((output, left))
}

impl Left {
    fn of(file: &File, rows: &Rows<'_>) -> io::Result<Self> {
        let mut reader = BufReader::with_capacity(1 << 18, file);
        let mut left = Self::default();
        let header = rows.header();
        let mut line = Vec::new();
        while reader.read_until(b'\n', &mut line)? > 0 && line.ends_with(b"\n") {
            if left.bytes == 0 && header.is_some() {
                left.has_header = header.as_ref().is_some_and(|header| header.as_bytes() == line);
            } else {
                left.rows += 1;
                left.at_limit += u64::from(rows.is_at_limit(&line));
            }
            left.bytes += line.len() as u64;
            std::mem::swap(&mut left.last, &mut line);
            line.clear();
        }
        Ok(left)
    }

    /// An error if these lines are not of this sweep.
    fn check(&self, path: &Path, rows: &Rows<'_>, description: &Description) -> Result<(), Report> {
        if self.bytes == 0 {
            return Ok(());
        }
        description.check(path)?;
        match rows.header().filter(|_| !self.has_header) {
            Some(header) => Err(changed(path, &format!("its header is not {}", header.trim_end()))),
            None => Ok(()),
        }
    }

    /// An error if the last row has other inputs than its number says.
    fn check_last(&self, path: &Path, arguments: &SweepArguments, plan: &Plan) -> Result<(), Report> {
        let all = plan.rows().unwrap_or(u64::MAX);
        if self.rows > all {
            return Err(changed(path, &format!("it has {} rows, and there are {all} stimuli", self.rows)));
        }
        let Some(last) = self.rows.checked_sub(1) else { return Ok(()) };
        let Some((part, skip)) = plan.from(last).next() else { return Ok(()) };
        let mut words = vec![0; part.stimuli.inputs()];
        let is_one = part.stimuli.feed(skip)?(&mut words);
        let rows = plan.written(part, &part.design().batch(), arguments);
        if !is_one || !self.last.starts_with(rows.beginning(&words).as_bytes()) {
            return Err(changed(path, &format!("row {} has other inputs", self.rows)));
        }
        Ok(())
    }
}

/// `C066`.
fn changed(path: &Path, what: &str) -> Report {
    let message = format!("{} has been changed since it was written: {what}", path.display());
    Diagnostic::new("C066", message).help("leave out --resume to begin anew").into()
}
