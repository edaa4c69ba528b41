//! Files by name: circuits and scenarios from disk or from the binary, outputs written aside and then renamed.

use std::fs;
use std::io::{self, BufWriter, Read, Write};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::base::{Diagnostic, Report};
use crate::netlist::Library;
use crate::simulation::shipped::{self, Shelf};

/// The longest text that is read; no circuit or scenario comes near it.
const LONGEST_TEXT: u64 = 64 << 20;

/// A text and where it came from.
#[derive(Clone, Debug)]
pub struct Text {
    /// What messages call it: a path, for a shipped file `circuits/...`.
    pub name: String,
    /// Its place on disk; `None` for a shipped file.
    pub path: Option<PathBuf>,
    /// The text.
    pub text: Arc<str>,
}

/// What a name or path on the command line stands for.
#[derive(Clone, Debug)]
pub enum Found {
    /// A circuit file, and the scenario of the same stem beside it if there is one.
    Circuit(Text, Option<Text>),
    /// A scenario file.
    Scenario(Text),
}

/// Finds a circuit or scenario: a path to a `.v` or `.toml` file, or the name of a shipped one.
///
/// # Errors
/// `C001` nothing of that name, `C002` a file that cannot be read.
pub fn find(target: &str) -> Result<Found, Report> {
    let path = Path::new(target);
    match path.extension().and_then(|ending| ending.to_str()) {
        Some("toml") => return Ok(Found::Scenario(read(path)?)),
        Some("v") => return circuit_on_disk(path),
        _ if path.is_file() || target.starts_with(['.', '/']) => return circuit_on_disk(path),
        _ => {}
    }
    match (shipped_text(target, "v"), shipped_text(target, "toml")) {
        (Some(circuit), scenario) => Ok(Found::Circuit(circuit, scenario)),
        (None, Some(scenario)) => Ok(Found::Scenario(scenario)),
        (None, None) => Err(unknown(target).into()),
    }
}

fn unknown(target: &str) -> Diagnostic {
    Diagnostic::new("C001", format!("there is no circuit or scenario `{target}`"))
        .nearest(target, shipped::names("v").chain(shipped::names("toml")))
        .help("`stepwright list` names the shipped ones; a file of yours is named by its path, as in ./my.v")
}

fn circuit_on_disk(path: &Path) -> Result<Found, Report> {
    let circuit = read(path)?;
    let scenario = path.with_extension("toml");
    let scenario = if scenario.is_file() { Some(read(&scenario)?) } else { None };
    Ok(Found::Circuit(circuit, scenario))
}

fn shipped_text(name: &str, ending: &str) -> Option<Text> {
    let path = format!("{name}.{ending}");
    shipped::text(&path).map(|text| Text { name: format!("circuits/{path}"), path: None, text: text.into() })
}

/// The circuit that a scenario names: a path relative to the scenario, or a name below the `circuits` folder the
/// scenario stands in, or a shipped one.
///
/// # Errors
/// `C001`, `C002`.
pub fn circuit_of(scenario: &Text, circuit: &str) -> Result<Text, Report> {
    let folder = scenario.path.as_deref().and_then(Path::parent);
    if let Some(folder) = folder.filter(|_| circuit.ends_with(".v")) {
        return read(&folder.join(circuit));
    }
    let on_disk = folder.and_then(circuits_root).map(|root| root.join(format!("{circuit}.v")));
    match on_disk.filter(|path| path.is_file()) {
        Some(path) => read(&path),
        None => shipped_text(circuit, "v").ok_or_else(|| unknown(circuit).into()),
    }
}

/// The nearest folder called `circuits` that holds `folder` or is it.
fn circuits_root(folder: &Path) -> Option<PathBuf> {
    let folder = fs::canonicalize(folder).ok()?;
    folder.ancestors().find(|path| path.file_name().is_some_and(|name| name == "circuits")).map(Path::to_owned)
}

/// Modules for a circuit: beside it, anywhere in its `circuits` folder, or shipped.
#[derive(Debug)]
pub struct Modules {
    folder: Option<PathBuf>,
    /// Path of the circuit below `circuits/`.
    near: String,
}

impl Modules {
    /// The library for a circuit file.
    #[must_use]
    pub fn of(circuit: &Text) -> Self {
        let folder = circuit.path.as_deref().map(|path| path.parent().unwrap_or(Path::new(".")).to_owned());
        let near = circuit.name.strip_prefix("circuits/").unwrap_or(&circuit.name).to_owned();
        Self { folder, near }
    }
}

impl Library for Modules {
    fn find(&self, module: &str) -> Option<(String, Arc<str>)> {
        let file = format!("{module}.v");
        let beside = self.folder.as_ref().map(|folder| folder.join(&file)).filter(|path| path.is_file());
        let anywhere = || self.folder.as_deref().and_then(circuits_root).and_then(|root| search(&root, &file));
        match beside.or_else(anywhere) {
            Some(path) => read(&path).ok().map(|text| (text.name, text.text)),
            None => Shelf { near: &self.near }.find(module),
        }
    }
}

/// All files below `folder` with one of the endings, in order of path.
#[must_use]
pub fn below(folder: &Path, ending: &str) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    for path in entries.map(|entry| entry.path()) {
        if path.is_dir() {
            found.extend(below(&path, ending));
        } else if path.extension().is_some_and(|known| known == ending) {
            found.push(path);
        }
    }
    found.sort();
    found
}

fn search(root: &Path, file: &str) -> Option<PathBuf> {
    below(root, "v").into_iter().find(|path| path.file_name().is_some_and(|name| name == file))
}

/// Reads a text file.
///
/// # Errors
/// `C002`: it is missing, a directory, not text, or too long.
pub fn read(path: &Path) -> Result<Text, Report> {
    let bytes = read_bytes(path)?;
    let name = path.display().to_string();
    let text = String::from_utf8(bytes).map_err(|error| {
        let line = error.as_bytes()[..error.utf8_error().valid_up_to()].iter().filter(|&&b| b == b'\n').count() + 1;
        unreadable(path, &format!("it is not text (line {line} is not UTF-8)"))
    })?;
    Ok(Text { name, path: Some(path.to_owned()), text: text.into() })
}

/// Reads a file.
///
/// # Errors
/// `C002`.
pub fn read_bytes(path: &Path) -> Result<Vec<u8>, Report> {
    let wrong = |error: io::Error| unreadable(path, &reason(&error));
    let file = fs::File::open(path).map_err(wrong)?;
    let about = file.metadata().map_err(wrong)?;
    if about.is_dir() {
        return Err(unreadable(path, "it is a directory; name a file in it").into());
    }
    let mut bytes = Vec::new();
    file.take(LONGEST_TEXT + 1).read_to_end(&mut bytes).map_err(wrong)?;
    if bytes.len() as u64 > LONGEST_TEXT {
        return Err(unreadable(path, &format!("it is longer than {} MiB", LONGEST_TEXT >> 20)).into());
    }
    Ok(bytes)
}

/// The diagnostic for a file that cannot be read.
pub(super) fn unreadable(path: &Path, why: &str) -> Diagnostic {
    Diagnostic::new("C002", format!("cannot read {}: {why}", path.display()))
}

/// An I/O error in plain words.
pub(super) fn reason(error: &io::Error) -> String {
    match error.kind() {
        io::ErrorKind::NotFound => "there is no such file".to_owned(),
        io::ErrorKind::PermissionDenied => "permission denied".to_owned(),
        _ => error.to_string(),
    }
}

/// A file being written: aside at first, under its name only once it is whole.
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

    /// Gives the file its name.
    ///
    /// # Errors
    /// `C003`; nothing is left behind then.
    pub fn finish(self) -> Result<(), Report> {
        let path = self.path;
        let sink = self.sink.into_inner().map_err(|error| unwritable(&path, error.error()))?;
        match sink {
            Sink::Aside(file) => file.persist(&path).map(drop).map_err(|error| unwritable(&path, &error.error).into()),
            Sink::Special(_) => Ok(()),
        }
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

impl Write for Sink {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self {
            Sink::Aside(file) => file.write(bytes),
            Sink::Special(file) => file.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match self {
            Sink::Aside(file) => file.flush(),
            Sink::Special(file) => file.flush(),
        }
    }
}

impl io::Seek for Output {
    fn seek(&mut self, to: io::SeekFrom) -> io::Result<u64> {
        self.sink.flush()?;
        match self.sink.get_mut() {
            Sink::Aside(file) => file.seek(to),
            Sink::Special(file) => file.seek(to),
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
    output.finish()
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

/// The diagnostic for a file that could not be written.
#[must_use]
pub fn unwritable(path: &Path, error: &io::Error) -> Diagnostic {
    Diagnostic::new("C003", format!("cannot write {}: {}", path.display(), reason(error)))
        .help("the folder must exist and be writable")
}
