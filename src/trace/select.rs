//! Select: which signals are traced, by globs over their dotted names below the top module.

use globset::{Glob, GlobMatcher};

use crate::base::{Diagnostic, Report, Signal, Sources};

/// Globs over dotted names. `*` also matches dots, `?` one character, `{a,b}` either, `[0-9]` one of a class.
///
/// ```
/// use stepwright::trace::Select;
///
/// let select = Select::new(["counter_14.*", "tap_2?"])?;
/// assert!(select.matches("counter_14.cell.q"));
/// assert!(select.matches("tap_23"));
/// assert!(!select.matches("tap_31"));
/// # Ok::<(), stepwright::base::Report>(())
/// ```
#[derive(Clone, Debug)]
pub struct Select {
    globs: Vec<GlobMatcher>,
}

impl Select {
    /// The selection of all names that one of `patterns` matches.
    ///
    /// # Errors
    /// `W001` for each pattern that is no glob.
    pub fn new<S: AsRef<str>>(patterns: impl IntoIterator<Item = S>) -> Result<Self, Report> {
        let (mut globs, mut wrong) = (Vec::new(), Vec::new());
        for pattern in patterns {
            match Glob::new(pattern.as_ref()) {
                Ok(glob) => globs.push(glob.compile_matcher()),
                Err(error) => wrong.push(bad_glob(pattern.as_ref(), &error)),
            }
        }
        if wrong.is_empty() { Ok(Self { globs }) } else { Err(Report::new(Sources::default(), wrong)) }
    }

    /// Whether it is the selection of all names.
    #[must_use]
    pub fn is_all(&self) -> bool {
        matches!(self.globs.as_slice(), [glob] if glob.glob().glob() == "*")
    }

    /// Whether a dotted name is chosen.
    #[must_use]
    pub fn matches(&self, name: &str) -> bool {
        self.globs.iter().any(|glob| glob.is_match(name))
    }

    /// The selection of all names.
    ///
    /// # Panics
    /// Never: a star is a glob.
    #[must_use]
    pub fn all() -> Self {
        Self::new(["*"]).expect("a star is a glob")
    }

    /// The chosen ones of `signals`, in their order.
    ///
    /// # Errors
    /// `W002` for each pattern that chose nothing, with the nearest names.
    pub fn of(&self, signals: &[Signal]) -> Result<Vec<Signal>, Report> {
        let names: Vec<_> = signals.iter().map(Signal::name).collect();
        let chose_nothing = |glob: &&GlobMatcher| !names.iter().any(|name| glob.is_match(name));
        let wrong: Vec<_> =
            self.globs.iter().filter(chose_nothing).map(|glob| matches_nothing(glob.glob().glob(), &names)).collect();
        if !wrong.is_empty() {
            return Err(Report::new(Sources::default(), wrong));
        }
        let chosen = signals.iter().zip(&names).filter(|(_, name)| self.matches(name));
        Ok(chosen.map(|(signal, _)| signal.clone()).collect())
    }
}

fn bad_glob(pattern: &str, error: &globset::Error) -> Diagnostic {
    Diagnostic::new("W001", format!("`{pattern}` is not a glob: {}", error.kind()))
        .help("a glob is a name with `*` (anything), `?` (one character), `{a,b}` (either) or `[0-9]` (one of these)")
}

fn matches_nothing(pattern: &str, all: &[String]) -> Diagnostic {
    let wrong = Diagnostic::new("W002", format!("no signal matches `{pattern}`"));
    if all.iter().any(|name| name.strip_prefix(pattern).is_some_and(|rest| rest.starts_with('.'))) {
        return wrong.help(format!("`{pattern}` is a scope; `{pattern}.*` matches what is in it"));
    }
    let plain: String = pattern.chars().filter(|c| !"*?[]{}".contains(*c)).collect();
    wrong.nearest(&plain, all.iter().map(String::as_str))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::ValueId;

    fn signals(names: &[&str]) -> Vec<Signal> {
        let path = |name: &str| ["top"].into_iter().chain(name.split('.')).map(str::to_owned).collect();
        let signal =
            |name: &&str| Signal { path: path(name), width: 1, signed: false, fraction: None, value: ValueId::new(0) };
        names.iter().map(signal).collect()
    }

    fn message(pattern: &str) -> String {
        let names = ["tap_23", "counter_14.count", "counter_14.cell.q"];
        let select = Select::new([pattern]).unwrap();
        select.of(&signals(&names)).map_or_else(|report| report.to_string(), |_| String::new())
    }

    #[test]
    fn a_star_chooses_everything_below_the_top() {
        let select = Select::new(["*"]).unwrap();
        assert!(signals(&["a", "b.c", "b.c.d"]).iter().all(|signal| select.matches(&signal.name())));
    }

    #[test]
    fn a_glob_that_matches_nothing_is_told_with_the_nearest_name() {
        assert_eq!(message("tap_*"), "");
        assert!(message("tab_23").contains("no signal matches `tab_23`"), "{}", message("tab_23"));
        assert!(message("tab_23").contains("did you mean `tap_23`?"), "{}", message("tab_23"));
        assert!(message("counter_14").contains("`counter_14.*` matches what is in it"), "{}", message("counter_14"));
    }

    #[test]
    fn every_bad_glob_is_told_at_once() {
        let report = Select::new(["a[", "b", "{c"]).unwrap_err();
        let codes: Vec<_> = report.diagnostics.iter().map(|diagnostic| diagnostic.code).collect();
        assert_eq!(codes, ["W001", "W001"]);
    }
}
