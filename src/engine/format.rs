//! What an engine says of itself.

use std::sync::Arc;

use super::Engine;
use crate::base::Diagnostic;
use crate::compile::Program;

/// An engine, as the command line knows it.
#[derive(Debug)]
pub struct EngineFormat {
    /// Its name on the command line.
    pub name: &'static str,
    /// What it is for, in a line of help.
    pub doc: &'static str,
    /// Whether a batch on it runs many stimuli at once ([`super::batch`]).
    pub runs_many: bool,
    /// Makes one for a program, at tick 0, that will run so many ticks of one stimulus at most.
    pub build: Build,
}

/// Makes an engine for a program.
pub type Build = fn(Arc<Program>, u64) -> Result<Box<dyn Engine>, Diagnostic>;
