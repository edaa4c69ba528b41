//! The engines by name, and which one suits a piece of work.

use std::fmt;
use std::str::FromStr;
use std::sync::Arc;

use super::{Engine, Interpreter};
use crate::base::Diagnostic;
use crate::compile::Program;

/// An engine as it is asked for.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum EngineKind {
    /// One op after another: starts at once.
    Interpreter,
    /// Machine code for one long run.
    Native,
    /// Bit planes for many stimuli at once ([`super::batch`]); for one run only to be compared with the others.
    Lanes,
    /// Whatever suits the work: see [`EngineKind::resolve`].
    Auto,
}

/// Ticks from which compiling pays.
///
/// Measured: for each op the interpreter takes about 10 ns a tick and Cranelift about 10 us once.
const COMPILE_PAYS: u64 = 1_000;

impl EngineKind {
    /// Every kind, in the order of the command line's help.
    pub const ALL: [EngineKind; 4] = [EngineKind::Interpreter, EngineKind::Native, EngineKind::Lanes, EngineKind::Auto];

    /// Its name on the command line.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            EngineKind::Interpreter => "interpreter",
            EngineKind::Native => "native",
            EngineKind::Lanes => "lanes",
            EngineKind::Auto => "auto",
        }
    }

    /// The kind that runs `ticks` ticks (at most) of one stimulus soonest, compilation included; itself if it is
    /// not `Auto`.
    #[must_use]
    pub fn resolve(self, ticks: u64) -> EngineKind {
        match self {
            EngineKind::Auto if ticks < COMPILE_PAYS => EngineKind::Interpreter,
            EngineKind::Auto => EngineKind::Native,
            kind => kind,
        }
    }

    /// An engine for `program`, at tick 0. `Auto` falls back to the interpreter when there is no native code for
    /// this machine.
    ///
    /// # Errors
    /// When an engine was asked for by name and cannot be made: `E001` for want of native code on this machine, `E003` it
    /// was not built in, `E004` and `E005` for want of room.
    pub fn build(self, program: Arc<Program>, ticks: u64) -> Result<Box<dyn Engine>, Diagnostic> {
        match self.resolve(ticks) {
            EngineKind::Interpreter => Ok(Box::new(Interpreter::new(program))),
            EngineKind::Lanes => lanes(&program),
            EngineKind::Native | EngineKind::Auto => match native(&program) {
                Err(_) if self == EngineKind::Auto => Ok(Box::new(Interpreter::new(program))),
                made => made,
            },
        }
    }
}

#[cfg(feature = "native")]
fn native(program: &Arc<Program>) -> Result<Box<dyn Engine>, Diagnostic> {
    Ok(Box::new(super::Native::new(Arc::clone(program))?))
}

#[cfg(not(feature = "native"))]
fn native(_: &Arc<Program>) -> Result<Box<dyn Engine>, Diagnostic> {
    Err(not_built_in("native"))
}

#[cfg(feature = "lanes")]
fn lanes(program: &Program) -> Result<Box<dyn Engine>, Diagnostic> {
    Ok(Box::new(super::LanesEngine::new(program)?))
}

#[cfg(not(feature = "lanes"))]
fn lanes(_: &Program) -> Result<Box<dyn Engine>, Diagnostic> {
    Err(not_built_in("lanes"))
}

/// The diagnostic for an engine that the crate was built without.
#[must_use]
pub fn not_built_in(engine: &str) -> Diagnostic {
    Diagnostic::new("E003", format!("this program was built without the engine `{engine}`"))
        .help(format!("build it with the feature `{engine}`, or take another engine"))
}

/// A new engine of every kind that runs on this machine, at tick 0: what a test of all engines goes through.
#[must_use]
pub fn all(program: &Arc<Program>) -> Vec<Box<dyn Engine>> {
    let kinds = EngineKind::ALL.into_iter().filter(|kind| *kind != EngineKind::Auto);
    kinds.filter_map(|kind| kind.build(Arc::clone(program), u64::MAX).ok()).collect()
}

impl fmt::Display for EngineKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for EngineKind {
    type Err = Diagnostic;

    fn from_str(name: &str) -> Result<Self, Diagnostic> {
        let found = Self::ALL.into_iter().find(|kind| kind.name() == name);
        found.ok_or_else(|| {
            let names = Self::ALL.map(Self::name);
            let unknown = Diagnostic::new("E002", format!("there is no engine `{name}`"));
            unknown.nearest(name, names).help(format!("engines: {}", names.join(", ")))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_engine_is_found_by_its_name() {
        for kind in EngineKind::ALL {
            assert_eq!(kind.name().parse(), Ok(kind));
        }
    }

    #[test]
    fn an_unknown_engine_is_refused_with_the_nearest_name() {
        let error = "nativ".parse::<EngineKind>().expect_err("no such engine");
        assert_eq!(error.code, "E002");
        assert!(error.help.iter().any(|line| line.contains("`native`")), "{error:?}");
    }

    #[test]
    fn auto_interprets_what_is_over_before_it_could_be_compiled() {
        assert_eq!(EngineKind::Auto.resolve(100), EngineKind::Interpreter);
        assert_eq!(EngineKind::Auto.resolve(1_000_000), EngineKind::Native);
        assert_eq!(EngineKind::Native.resolve(1), EngineKind::Native);
    }
}
