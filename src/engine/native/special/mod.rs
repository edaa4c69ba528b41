//! Specialised code: it runs only what can change.
//!
//! While the plain code runs, the interpreter now and then looks at some ticks ([`profile`]). From what one-bit values
//! do in them a decision tree is grown ([`tree`]); at each leaf only what is left of a tick under the values asked for is
//! compiled ([`view`], [`emit`]). What was rare in the profile is left to the plain code, and whatever the profile said,
//! the results are the same.

mod emit;
mod profile;
mod tree;
mod view;

use std::time::Instant;

use self::profile::Profile;
use self::tree::Tree;
use self::view::View;
use super::host::{Assembler, Code};
use super::memory::{Layout, Memory};
use super::register_nodes;
use crate::base::Diagnostic;
use crate::compile::Program;
use crate::engine::{Engine, Interpreter, Stats};

/// Ticks looked at in a row.
const WINDOW: usize = 64;
/// Windows of a profile.
const WINDOWS: usize = 32;
/// Ticks that the plain code runs between two windows.
const PAUSE: u64 = 4096;
/// Ticks that the plain code runs where the tree leaves a tick to it; what is rare comes in groups.
const BURST: u64 = 4;
/// A profile has misled when the plain code is called more often than once in so many ticks.
const MISLED: u64 = 128;

/// Specialised code and how it comes about.
pub(super) struct Special {
    stage: Stage,
    pause: u64,
    windows: usize,
}

enum Stage {
    /// The plain code runs, and is looked at.
    Watching(Profile),
    /// The specialised code runs.
    Running(Box<Running>),
    /// The plain code runs for good.
    Plain,
}

struct Running {
    code: Code,
    function: usize,
    stats: Stats,
}

impl Special {
    /// Specialises a program after its plain code has run for some time.
    pub fn new(program: &Program) -> Self {
        Self { stage: Stage::Watching(Profile::new(&program.graph)), pause: PAUSE, windows: WINDOWS }
    }

    /// Leaves a program as it is: one of many functions has too much code for trees over the whole of it.
    pub fn never() -> Self {
        Self { stage: Stage::Plain, pause: PAUSE, windows: WINDOWS }
    }

    /// Specialises a program after its first ticks, on what they were.
    pub fn eager(program: &Program) -> Self {
        Self { pause: 1, windows: 1, ..Self::new(program) }
    }

    /// What came of it so far.
    pub fn stats(&self) -> Option<&Stats> {
        match &self.stage {
            Stage::Running(running) => Some(&running.stats),
            Stage::Watching(_) | Stage::Plain => None,
        }
    }

    /// Goes on by up to `left` ticks as far as it can. Returns how many are left.
    pub fn run(&mut self, memory: &mut Memory, left: u64, until_stop: bool) -> u64 {
        let Stage::Running(running) = &mut self.stage else { return left };
        let after = running.code.call(running.function, memory, &[until_stop.into()], left);
        running.stats.ticks += left - after;
        running.stats.rests += u64::from(after > 0);
        after
    }

    /// For how many ticks the plain code shall run now.
    pub fn plain_ticks(&self) -> u64 {
        match self.stage {
            Stage::Watching(_) => self.pause,
            Stage::Running(_) => BURST,
            Stage::Plain => u64::MAX,
        }
    }

    /// Looks at the ticks to come, if that is due, and makes code when enough has been seen.
    pub fn watch(&mut self, program: &Program, layout: &Layout, interpreter: impl FnOnce() -> Interpreter) {
        if let Stage::Running(running) = &self.stage
            && running.stats.rests > WINDOW as u64
            && running.stats.rests * MISLED > running.stats.ticks
        {
            self.stage = Stage::Watching(Profile::new(&program.graph));
            self.pause = self.pause.saturating_mul(8);
        }
        let Stage::Watching(profile) = &mut self.stage else { return };
        let mut twin = interpreter();
        for _ in 0..WINDOW {
            profile.tick(|id| twin.value(id));
            twin.advance(1, false);
        }
        if profile.ticks() >= self.windows * WINDOW {
            let made = compile(program, layout, profile);
            self.stage = made.ok().flatten().map_or(Stage::Plain, |running| Stage::Running(Box::new(running)));
        }
    }
}

/// The specialised code; `None` when there is nothing to ask for.
fn compile(program: &Program, layout: &Layout, profile: &Profile) -> Result<Option<Running>, Diagnostic> {
    let since = Instant::now();
    let view = View::new(program, &register_nodes(&program.graph));
    let whole = view.work();
    let tree = tree::grow(view, profile);
    if !matches!(tree, Tree::Fork { .. }) {
        return Ok(None);
    }
    let mut assembler = Assembler::new()?;
    let function = emit::compile(&mut assembler, program, layout, &tree)?;
    let code = assembler.finish(layout)?;
    let mut stats = Stats { whole, leaves: Vec::new(), made_in: since.elapsed(), ticks: 0, rests: 0 };
    tree.leaves(&mut |work, share| stats.leaves.push((work, share)));
    Ok(Some(Running { code, function, stats }))
}
