//! Files written in place: what is done of a long work must be there after whatever ended it.

use std::fs::{File, OpenOptions, TryLockError};
use std::io;
use std::path::Path;

use super::output::opened;
use super::place::Place;
use super::stream::Stream;
use super::{busy, unwritable};
use crate::base::Report;

/// An output that is written in place.
#[derive(Debug)]
pub enum Lasting {
    /// A file to read and write, with all that it held. It is locked: no other work goes into it meanwhile.
    File(File),
    /// Standard output, a device or a pipe.
    Stream(Stream),
}

impl Lasting {
    /// Opens `path`, and makes the file if there is none.
    ///
    /// # Errors
    /// `C003` what cannot be written, `C031` a file that another program is writing.
    pub fn open(path: &Path) -> Result<Self, Report> {
        let wrong = |error: io::Error| Report::from(unwritable(path, &error));
        let target = match Place::of(path).map_err(wrong)? {
            Place::File(target) => target,
            Place::Standard => return Ok(Self::Stream(Stream::Standard(io::stdout()))),
            Place::Stream(target) => return opened(&target).map(Self::Stream).map_err(wrong),
        };
        let mut options = OpenOptions::new();
        let file = options.read(true).write(true).create(true).truncate(false).open(target).map_err(wrong)?;
        match file.try_lock() {
            Err(TryLockError::WouldBlock) => Err(busy(path).into()),
            // Where files cannot be locked, the user has to see to it.
            _ => Ok(Self::File(file)),
        }
    }
}
