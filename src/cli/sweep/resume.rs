//! Where rows go, and how a file that an interrupted sweep left is gone on with.
//!
//! Rows are in order, so that their number says where to go on; a torn last line is dropped. What sweep they are of
//! stands in the description beside them.

use std::io::{self, BufWriter, Seek, SeekFrom, Write};
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use super::SweepArguments;
use super::description::Description;
use super::lines::Lines;
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

/// Opens the output and tells what it has already, which is nothing unless it `resume`s.
///
/// # Errors
/// `C003` what cannot be written, `C031` what another sweep is writing, `C066` a file that this sweep cannot have
/// left, `C082` a file that is no place for a shard.
pub fn open(path: &Path, arguments: &SweepArguments, plan: &Plan) -> Result<(Output, Lines), Report> {
    let part = plan.first();
    let batch = part.batch(arguments)?;
    let rows = &plan.written(part, &batch, arguments);
    let description = &Description::new(arguments, plan);
    let wrong = |error: io::Error| Report::from(files::unwritable(path, &error));
    let mut left = Lines::default();
    let to: Box<dyn Write + Send> = match Lasting::open(path)? {
        Lasting::Stream(_) if arguments.resume => {
            let message = format!("there is nothing to go on with in {}, which is no file", path.display());
            return Err(Diagnostic::new("C066", message).into());
        }
        Lasting::Stream(_) if plan.shard().is_some() => {
            let message = format!("{} is no file, and a shard needs one that can be merged", path.display());
            return Err(Diagnostic::new("C082", message).help("give --out a file of its own").into());
        }
        Lasting::Stream(stream) => Box::new(stream),
        Lasting::File(mut file) => {
            description.check_shard(path)?;
            if arguments.resume {
                left = Lines::of(&file, rows.format()).map_err(wrong)?;
                check(&left, path, rows, description)?;
                check_last(&left, path, arguments, plan)?;
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

/// An error if the lines that are left are not of this sweep.
fn check(left: &Lines, path: &Path, rows: &Rows<'_>, description: &Description) -> Result<(), Report> {
    if left.bytes == 0 {
        return Ok(());
    }
    description.check(path)?;
    match rows.header().filter(|header| left.header.as_deref() != Some(header.as_bytes())) {
        Some(header) => Err(changed(path, &format!("its header is not {}", header.trim_end()))),
        None => Ok(()),
    }
}

/// An error if the last row that is left has other inputs than its number says.
fn check_last(left: &Lines, path: &Path, arguments: &SweepArguments, plan: &Plan) -> Result<(), Report> {
    let all = plan.rows();
    let count = all.end - all.start;
    if left.rows > count {
        return Err(changed(path, &format!("it has {} rows, and there are {count} stimuli", left.rows)));
    }
    let Some(last) = left.rows.checked_sub(1).map(|last| all.start + last) else { return Ok(()) };
    let Some((part, row)) = plan.within(last..last + 1).next() else { return Ok(()) };
    let mut words = vec![0; part.stimuli.inputs()];
    let is_one = part.stimuli.feed(row)?(&mut words);
    let rows = plan.written(part, &part.design().batch(), arguments);
    if !is_one || !left.last.starts_with(rows.beginning(&words).as_bytes()) {
        return Err(changed(path, &format!("row {} has other inputs", left.rows)));
    }
    Ok(())
}

/// `C066`.
fn changed(path: &Path, what: &str) -> Report {
    let message = format!("{} has been changed since it was written: {what}", path.display());
    Diagnostic::new("C066", message).help("leave out --resume to begin anew").into()
}
