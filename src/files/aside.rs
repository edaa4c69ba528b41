//! A file written aside: under a name made of its own at first, under its own once it is whole.
//!
//! The file aside is locked while it is written. So two programs never write one output at a time, and a file that
//! nobody has locked was left by a program that was killed.

use std::ffi::OsString;
use std::fs::{self, File, Metadata, OpenOptions, TryLockError};
use std::io::{self, Seek, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use super::place::{Identity, folder_of};
use super::{busy, unwritable};
use crate::base::{Diagnostic, Report};

/// The files aside of this program.
static UNFINISHED: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// Removes all files that are not finished: the program is about to be ended.
pub fn abandon() {
    for aside in UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner).iter() {
        let _ = fs::remove_file(aside);
    }
}

/// The name aside of an output.
fn name_aside(target: &Path) -> PathBuf {
    let mut name = OsString::from(".");
    name.push(target.file_name().unwrap_or_default());
    name.push(".unfinished");
    target.with_file_name(name)
}

/// Removes what a program that was killed has left of an output, and says where that was.
///
/// # Errors
/// `C031` another program is writing the output, `C003` what stands there is not ours to remove.
pub(super) fn clear(target: &Path) -> Result<Option<PathBuf>, Report> {
    if is_locked(target) {
        return Err(busy(target).into());
    }
    let aside = name_aside(target);
    match take(&aside) {
        Ok(Taken::Nothing) => Ok(None),
        Ok(Taken::Busy) => Err(busy(target).into()),
        Ok(Taken::Left(_locked)) => {
            fs::remove_file(&aside).map_err(|error| unwritable(&aside, &error))?;
            Ok(Some(aside))
        }
        Err(error) => {
            let diagnostic = unwritable(&aside, &error);
            Err(diagnostic.help(format!("{} is written there first; remove what is there", target.display())).into())
        }
    }
}

/// Whether another program writes a file in place ([`super::Lasting`]); putting another one under its name would leave that
/// program writing what nobody sees.
fn is_locked(target: &Path) -> bool {
    File::open(target).is_ok_and(|file| matches!(file.try_lock_shared(), Err(TryLockError::WouldBlock)))
}

/// What stands under a name aside.
enum Taken {
    Nothing,
    Busy,
    /// A file that nobody writes; as long as it is held here nobody else takes it.
    Left(File),
}

fn take(aside: &Path) -> io::Result<Taken> {
    // A link is not followed: whoever may write in the folder could lead us to any file by one.
    match fs::symlink_metadata(aside) {
        Ok(about) if about.is_file() => {}
        Ok(_) => return Err(io::Error::other("it is no ordinary file")),
        Err(_) => return Ok(Taken::Nothing),
    }
    let file = match OpenOptions::new().write(true).open(aside) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(Taken::Nothing),
        file => file?,
    };
    Ok(match file.try_lock() {
        Err(TryLockError::WouldBlock) => Taken::Busy,
        // Whoever had it may have finished it in the meantime.
        _ if !is_at(&file, aside) => Taken::Nothing,
        _ => Taken::Left(file),
    })
}

/// Whether an open file still stands under a name.
fn is_at(file: &File, name: &Path) -> bool {
    let identity = |about: io::Result<Metadata>| Identity::found(name, &about.ok()?);
    identity(file.metadata()) == identity(fs::symlink_metadata(name))
}

/// A file being written aside; it goes when it is dropped.
#[derive(Debug)]
pub(super) struct Aside {
    file: File,
    aside: PathBuf,
    target: PathBuf,
}

impl Aside {
    /// Begins to write `target`, where no link is left to follow.
    ///
    /// # Errors
    /// `C003`, `C031`.
    pub fn create(target: PathBuf) -> Result<Self, Report> {
        let aside = name_aside(&target);
        loop {
            clear(&target)?;
            match OpenOptions::new().read(true).write(true).create_new(true).open(&aside) {
                Ok(file) => {
                    // Where files cannot be locked, the last one to finish wins.
                    let is_busy = matches!(file.try_lock(), Err(TryLockError::WouldBlock));
                    if !is_busy && is_at(&file, &aside) {
                        UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner).push(aside.clone());
                        return Ok(Self { file, aside, target });
                    }
                }
                Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
                Err(error) => return Err(in_folder(&target, &error).into()),
            }
        }
    }

    /// Gives the file its name. One that has other names too, or an owner whom we cannot give it, is written in place.
    pub fn commit(mut self) -> io::Result<()> {
        match fs::metadata(&self.target) {
            Ok(old) if !replaces(&self.file, &old) => {
                self.file.rewind()?;
                let mut target = OpenOptions::new().write(true).truncate(true).open(&self.target)?;
                io::copy(&mut self.file, &mut target).map(drop)
            }
            _ => fs::rename(&self.aside, &self.target),
        }
    }
}

/// Why no file can be made in the folder of an output.
fn in_folder(target: &Path, error: &io::Error) -> Diagnostic {
    let folder = folder_of(target).display().to_string();
    let diagnostic = unwritable(target, error);
    match error.kind() {
        io::ErrorKind::NotFound => diagnostic.help(format!("there is no folder {folder}: make it first")),
        io::ErrorKind::PermissionDenied => diagnostic.help(format!("the folder {folder} must be writable")),
        _ => diagnostic,
    }
}

/// Gives `file` the owner and mode of the old one; `false` when a new file cannot stand for it.
#[cfg(unix)]
fn replaces(file: &File, old: &Metadata) -> bool {
    use std::os::unix::fs::{MetadataExt, fchown};
    let is_mine = file.metadata().is_ok_and(|new| (new.uid(), new.gid()) == (old.uid(), old.gid()));
    let is_owned = is_mine || fchown(file, Some(old.uid()), Some(old.gid())).is_ok();
    old.nlink() == 1 && is_owned && file.set_permissions(old.permissions()).is_ok()
}

#[cfg(not(unix))]
fn replaces(_: &File, _: &Metadata) -> bool {
    true
}

impl Drop for Aside {
    fn drop(&mut self) {
        // After a rename there is nothing any more; else it must not stay.
        if is_at(&self.file, &self.aside) {
            let _ = fs::remove_file(&self.aside);
        }
        UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner).retain(|aside| *aside != self.aside);
    }
}

impl Write for Aside {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.file.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}

impl Seek for Aside {
    fn seek(&mut self, to: io::SeekFrom) -> io::Result<u64> {
        self.file.seek(to)
    }
}
