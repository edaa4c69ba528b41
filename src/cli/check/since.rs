//! The netlists of an older revision, out of git: fully traced they name the net that a golden trace does not hold.

use std::path::{Path, PathBuf};
use std::process::Command;

use tempfile::TempDir;

use crate::base::{Diagnostic, Report};

/// All files of a revision, in a folder that goes away with it.
pub(super) struct Older {
    /// What the revision was called.
    pub name: String,
    top: PathBuf,
    folder: TempDir,
}

impl Older {
    /// The revision `name` of the repository that this folder stands in. Neither its index nor its files are touched.
    ///
    /// # Errors
    /// `C010` git cannot be run, or knows no such revision; `C003` no temporary folder.
    pub fn checked_out(name: &str) -> Result<Self, Report> {
        let unwritable = |error: std::io::Error| crate::files::unwritable(Path::new("a temporary folder"), &error);
        let folder = tempfile::tempdir().map_err(unwritable)?;
        let index = folder.path().join("index");
        let top = PathBuf::from(git(&index, &["rev-parse", "--show-toplevel"])?);
        let tree = format!("{name}^{{tree}}");
        let tree = git(&index, &["rev-parse", "--verify", "--end-of-options", &tree])?;
        git(&index, &["read-tree", &tree])?;
        let at_top = top.to_string_lossy();
        let prefix = format!("--prefix={}/tree/", folder.path().display());
        git(&index, &["-C", &at_top, "checkout-index", "--all", &prefix])?;
        let top = top.canonicalize().unwrap_or(top);
        Ok(Self { name: name.to_owned(), top, folder })
    }

    /// The file as it was then; `None` when it is not of this repository.
    pub fn file(&self, now: &Path) -> Option<PathBuf> {
        let below = now.canonicalize().ok()?.strip_prefix(&self.top).ok()?.to_owned();
        Some(self.folder.path().join("tree").join(below))
    }
}

/// What git answers, with an index of its own.
fn git(index: &Path, arguments: &[&str]) -> Result<String, Diagnostic> {
    let output = Command::new("git").args(arguments).env("GIT_INDEX_FILE", index).output();
    let wrong = |said: &str| {
        let message = format!("--since: git {}: {}", arguments.join(" "), said.trim());
        Diagnostic::new("C010", message).help("name a commit, tag or branch, as in --since HEAD")
    };
    let output = output.map_err(|error| wrong(&error.to_string()))?;
    if !output.status.success() {
        return Err(wrong(&String::from_utf8_lossy(&output.stderr)));
    }
    Ok(String::from_utf8_lossy(&output.stdout).trim_end().to_owned())
}
