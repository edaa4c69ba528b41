//! The circuits and scenarios that the library carries.

use std::sync::Arc;

use crate::base::{Diagnostic, Report};
use crate::files::Text;
use crate::netlist::Library;

/// Path below `circuits/` and text of every shipped file, in order of path.
static FILES: &[(&str, &str)] = include!(concat!(env!("OUT_DIR"), "/shipped.rs"));

/// The text of a shipped file by its path below `circuits/`, for example `su1522157/interpolator.v`.
#[must_use]
pub fn text(path: &str) -> Option<&'static str> {
    FILES.iter().find(|(known, _)| *known == path).map(|(_, text)| *text)
}

/// A shipped circuit (`v`) or scenario (`toml`) by its name, such as `su1522157/interpolator`.
#[must_use]
pub fn file(name: &str, ending: &str) -> Option<Text> {
    let path = format!("{name}.{ending}");
    text(&path).map(|text| Text { name: format!("circuits/{path}"), path: None, text: text.into() })
}

/// The names of all shipped circuits (`v`) or scenarios (`toml`): their paths without the ending.
pub fn names(ending: &str) -> impl Iterator<Item = &'static str> {
    FILES.iter().filter_map(move |(path, _)| path.strip_suffix(ending)?.strip_suffix('.'))
}

/// Files of the shipped circuits, those beside `near` (a path below `circuits/`) first.
#[derive(Clone, Copy, Debug)]
pub struct Shelf<'a> {
    /// The circuit that asks.
    pub near: &'a str,
}

impl Library for Shelf<'_> {
    fn find(&self, file: &str) -> Option<Result<(String, Arc<str>), Report>> {
        let folder = self.near.rsplit_once('/').map_or("", |(folder, _)| folder);
        let beside = format!("{folder}/{file}");
        let anywhere = || FILES.iter().find(|(path, _)| path.rsplit('/').next() == Some(file));
        let (path, text) = FILES.iter().find(|(path, _)| *path == beside).or_else(anywhere)?;
        Some(Ok((format!("circuits/{path}"), Arc::from(*text))))
    }
}

/// `C001`: nothing of that name, and what is near.
#[must_use]
pub fn unknown(target: &str) -> Diagnostic {
    Diagnostic::new("C001", format!("there is no circuit or scenario `{target}`"))
        .nearest(target, names("v").chain(names("toml")))
        .help("`stepwright list` names the shipped ones; a file of yours is named by its path, as in ./my.v")
}
