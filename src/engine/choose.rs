//! The engines by name. Adding one is its file and its line in [`ENGINES`].

use std::fmt;
use std::str::FromStr;
use std::sync::Arc;

use super::format::EngineFormat;
use super::{Engine, auto, interpreter};
use crate::base::Diagnostic;
use crate::compile::Program;

/// Every engine, in the order of the command line's help.
static ENGINES: &[&EngineFormat] = &[
    &interpreter::ENGINE,
    #[cfg(feature = "native")]
    &super::native::ENGINE,
    #[cfg(feature = "lanes")]
    &super::lanes::ENGINE,
    #[cfg(not(feature = "native"))]
    &absent("native", |_, _| Err(not_built_in("native"))),
    #[cfg(not(feature = "lanes"))]
    &absent("lanes", |_, _| Err(not_built_in("lanes"))),
    &auto::ENGINE,
];

/// An engine as it is asked for.
#[derive(Clone, Copy, Debug)]
pub struct EngineKind(&'static EngineFormat);

impl EngineKind {
    /// Whatever suits the work.
    pub const AUTO: EngineKind = EngineKind(&auto::ENGINE);
    /// The plain twin of all others.
    pub const INTERPRETER: EngineKind = EngineKind(&interpreter::ENGINE);

    /// Every kind, [`EngineKind::AUTO`] last.
    pub fn all() -> impl Iterator<Item = EngineKind> {
        ENGINES.iter().copied().map(EngineKind)
    }

    /// Its name on the command line.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.0.name
    }

    /// What it is for.
    #[must_use]
    pub fn doc(self) -> &'static str {
        self.0.doc
    }

    /// Whether a batch on it runs many stimuli at once.
    #[must_use]
    pub fn runs_many(self) -> bool {
        self.0.runs_many
    }

    /// An engine for `program`, at tick 0, that will run `ticks` ticks of one stimulus at most.
    ///
    /// # Errors
    /// When an engine was asked for by name and cannot be made: `E001` for want of native code on this machine, `E003` it
    /// was not built in, `E004` and `E005` for want of room.
    pub fn build(self, program: Arc<Program>, ticks: u64) -> Result<Box<dyn Engine>, Diagnostic> {
        (self.0.build)(program, ticks)
    }
}

/// The diagnostic for an engine that the crate was built without.
#[must_use]
pub fn not_built_in(engine: &str) -> Diagnostic {
    Diagnostic::new("E003", format!("this program was built without the engine `{engine}`"))
        .help(format!("build it with the feature `{engine}`, or take another engine"))
}

/// A name that is known, though there is no such engine here.
#[cfg(not(all(feature = "native", feature = "lanes")))]
const fn absent(name: &'static str, build: super::format::Build) -> EngineFormat {
    EngineFormat { name, doc: "not built in", runs_many: false, build }
}

/// A new engine of every kind that runs on this machine, at tick 0: what a test of all engines goes through.
#[must_use]
pub fn all(program: &Arc<Program>) -> Vec<Box<dyn Engine>> {
    let kinds = EngineKind::all().filter(|kind| *kind != EngineKind::AUTO);
    kinds.filter_map(|kind| kind.build(Arc::clone(program), u64::MAX).ok()).collect()
}

impl PartialEq for EngineKind {
    fn eq(&self, other: &Self) -> bool {
        self.name() == other.name()
    }
}

impl Eq for EngineKind {}

impl fmt::Display for EngineKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for EngineKind {
    type Err = Diagnostic;

    fn from_str(name: &str) -> Result<Self, Diagnostic> {
        Self::all().find(|kind| kind.name() == name).ok_or_else(|| {
            let names: Vec<_> = Self::all().map(Self::name).collect();
            let unknown = Diagnostic::new("E002", format!("there is no engine `{name}`"));
            unknown.nearest(name, names.iter().copied()).help(format!("engines: {}", names.join(", ")))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_engine_is_found_by_its_name() {
        for kind in EngineKind::all() {
            assert_eq!(kind.name().parse(), Ok(kind));
        }
    }

    #[test]
    fn an_unknown_engine_is_refused_with_the_nearest_name() {
        let error = "nativ".parse::<EngineKind>().expect_err("no such engine");
        assert_eq!(error.code, "E002");
        assert!(error.help.iter().any(|line| line.contains("`native`")), "{error:?}");
    }
}
