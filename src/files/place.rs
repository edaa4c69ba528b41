//! What a path leads to, and whether two paths lead to one file.

use std::fs::{self, File, Metadata, OpenOptions};
use std::io;
use std::path::{Path, PathBuf};

/// Most links that are followed, as the system does.
const MOST_LINKS: usize = 40;

/// What a path that is to be written leads to.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) enum Place {
    /// Standard output: the path `-`, or another name of what standard output goes to.
    Standard,
    /// A device, a pipe, a socket: written through.
    Stream(PathBuf),
    /// An ordinary file that may be written, or the name of one to come. Links have been followed.
    File(PathBuf),
}

impl Place {
    /// What `path` leads to.
    ///
    /// # Errors
    /// A directory, a file that must not be written, more links than are followed.
    pub fn of(path: &Path) -> io::Result<Self> {
        if is_standard_output(path) {
            return Ok(Place::Standard);
        }
        match fs::metadata(path) {
            Ok(about) if about.is_dir() => Err(io::Error::other("it is a directory")),
            Ok(about) if !about.is_file() => Ok(Place::Stream(path.to_owned())),
            // The system lets its administrator write such a file all the same.
            Ok(about) if about.permissions().readonly() => Err(io::Error::other("the file is read-only")),
            Ok(_) => {
                OpenOptions::new().write(true).open(path)?;
                Ok(Place::File(path.canonicalize()?))
            }
            Err(error) if error.kind() == io::ErrorKind::NotFound => end_of_links(path).map(Place::File),
            Err(error) => Err(error),
        }
    }

    /// What the places of one file have in common; `None` for the null device, which may be written twice.
    pub fn identity(&self) -> Option<Identity> {
        match self {
            Place::Standard => Some(standard_output().unwrap_or(Identity::Name("-".into()))),
            Place::Stream(path) => Identity::of(path).filter(|identity| !is_null(identity)),
            Place::File(path) => Some(Identity::of(path).unwrap_or_else(|| Identity::Name(in_whole(path)))),
        }
    }
}

/// What all names of one file have in common.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) enum Identity {
    /// Device and number of a file that exists.
    #[cfg(unix)]
    Number(u64, u64),
    /// Its whole path, where there is no file yet, or files have no numbers.
    Name(PathBuf),
}

impl Identity {
    /// That of the file at a path, links followed, if there is one.
    pub fn of(path: &Path) -> Option<Self> {
        Self::found(path, &fs::metadata(path).ok()?)
    }

    #[cfg(unix)]
    pub fn found(_: &Path, about: &Metadata) -> Option<Self> {
        use std::os::unix::fs::MetadataExt;
        Some(Self::Number(about.dev(), about.ino()))
    }

    #[cfg(not(unix))]
    pub fn found(path: &Path, _: &Metadata) -> Option<Self> {
        path.canonicalize().ok().map(Self::Name)
    }
}

/// Whether a path is `-` or another name of what standard output goes to, such as `/dev/stdout`.
#[must_use]
pub fn is_standard_output(path: &Path) -> bool {
    let is_it =
        || standard_output().filter(|identity| !is_null(identity)).is_some_and(|it| Identity::of(path) == Some(it));
    path == Path::new("-") || is_it()
}

#[cfg(unix)]
fn standard_output() -> Option<Identity> {
    use std::os::fd::AsFd;
    let out = File::from(io::stdout().as_fd().try_clone_to_owned().ok()?);
    Identity::found(Path::new("-"), &out.metadata().ok()?)
}

#[cfg(not(unix))]
fn standard_output() -> Option<Identity> {
    None
}

fn is_null(identity: &Identity) -> bool {
    Identity::of(Path::new("/dev/null")).as_ref() == Some(identity)
}

/// Where links lead that may lead to nothing yet.
fn end_of_links(path: &Path) -> io::Result<PathBuf> {
    let mut path = path.to_owned();
    for _ in 0..MOST_LINKS {
        match fs::read_link(&path) {
            Ok(target) => path = path.parent().unwrap_or(Path::new("")).join(target),
            Err(_) => return Ok(path),
        }
    }
    Err(io::Error::other("it is a link to itself"))
}

/// The whole path of a file to come, whose folder may be named in several ways.
fn in_whole(path: &Path) -> PathBuf {
    let folder = folder_of(path).canonicalize();
    folder.ok().zip(path.file_name()).map_or_else(|| path.to_owned(), |(folder, name)| folder.join(name))
}

/// The folder that a file stands in.
pub(super) fn folder_of(path: &Path) -> &Path {
    path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."))
}
