//! What a shell offers while a command is typed: names of circuits, scenarios, blocks, instances, inputs, nets.
//!
//! The script that `stepwright completions SHELL` prints asks stepwright itself, with the words typed so far.

use std::ffi::OsStr;
use std::path::Path;

use clap::CommandFactory;
use clap_complete::engine::ValueCompleter as _;
use clap_complete::env::Shells;
use clap_complete::{ArgValueCompleter, CompleteEnv, CompletionCandidate, PathCompleter, Shell};

use super::args::Arguments;
use super::show;
use crate::base::Signal;
use crate::blocks::REGISTRY;
use crate::compile;
use crate::files;
use crate::simulation::{Design, Session, shipped};

/// The variable by which the script tells stepwright that it asks.
const ASKED: &str = "STEPWRIGHT_COMPLETE";

/// Answers the script, and ends the program then.
pub(super) fn answer() {
    CompleteEnv::with_factory(Arguments::command).var(ASKED).complete();
}

/// The script for a shell.
pub(super) fn script(shell: Shell) -> String {
    let mut text = Vec::new();
    if let Some(shell) = Shells::builtins().completer(&shell.to_string()) {
        // Nothing fails that is written into memory.
        let _ = shell.write_registration(ASKED, "stepwright", "stepwright", "stepwright", &mut text);
    }
    String::from_utf8_lossy(&text).into_owned()
}

/// Circuits and scenarios, by name or path.
pub(super) fn targets() -> ArgValueCompleter {
    ArgValueCompleter::new(|typed: &OsStr| with_files(typed, names(&["v", "toml"])))
}

/// Scenarios, by name or path.
pub(super) fn scenarios() -> ArgValueCompleter {
    ArgValueCompleter::new(|typed: &OsStr| with_files(typed, names(&["toml"])))
}

/// What `list` lists.
pub(super) fn folders() -> ArgValueCompleter {
    ArgValueCompleter::new(|typed: &OsStr| {
        let mut all = begun(typed, ["circuits".to_owned(), "blocks".to_owned()]);
        all.extend(PathCompleter::dir().complete(typed));
        all
    })
}

/// Circuits, scenarios, blocks, and the instances of a circuit once its name and a dot are there.
pub(super) fn shown() -> ArgValueCompleter {
    ArgValueCompleter::new(|typed: &OsStr| {
        let blocks = REGISTRY.iter().map(|block| block.description().name.to_owned());
        let mut all = with_files(typed, names(&["v", "toml"]).into_iter().chain(blocks));
        let text = typed.to_string_lossy();
        let design = |dot: usize| Some((dot, Session::open(&text[..dot]).ok()?.elaborate().ok()?));
        if let Some((dot, design)) = text.rmatch_indices('.').find_map(|(dot, _)| design(dot)) {
            let paths = show::paths(design.netlist()).into_iter();
            all.extend(begun(typed, paths.map(|path| format!("{}.{path}", &text[..dot]))));
        }
        all
    })
}

/// Inputs of the circuit that was named before, as `NAME=`.
pub(super) fn inputs() -> ArgValueCompleter {
    of_target(|design| design.inputs().map(|net| format!("{}=", net.name)).collect())
}

/// Its parameters, as `NAME=`.
pub(super) fn parameters() -> ArgValueCompleter {
    of_target(|design| design.netlist().parameters.iter().map(|one| format!("{}=", one.name)).collect())
}

/// Its nets and what can be seen in its blocks; with `!` before them where that was typed.
pub(super) fn nets() -> ArgValueCompleter {
    of_target(|design| {
        let names = compile::signals(design.netlist()).iter().map(Signal::name).collect::<Vec<_>>();
        let low = names.iter().map(|name| format!("!{name}")).collect();
        [names, low].concat()
    })
}

fn of_target(names: fn(&Design) -> Vec<String>) -> ArgValueCompleter {
    ArgValueCompleter::new(move |typed: &OsStr| begun(typed, target().iter().flat_map(names)))
}

/// The design of the first word after the command that names one.
fn target() -> Option<Design> {
    let words = std::env::args().skip_while(|word| word != "--").skip(3);
    let mut words = words.filter(|word| !word.starts_with('-'));
    words.find_map(|word| Session::open(&word).ok()).and_then(|session| session.elaborate().ok())
}

/// Names of circuits and scenarios: of the shipped ones and those below `./circuits`.
fn names(endings: &[&'static str]) -> Vec<String> {
    let mut all = Vec::new();
    for &ending in endings {
        all.extend(shipped::names(ending).map(str::to_owned));
        let below = files::below(Path::new("circuits"), ending).into_iter();
        all.extend(
            below.map(|path| path.strip_prefix("circuits").unwrap_or(&path).with_extension("").display().to_string()),
        );
    }
    all.sort();
    all.dedup();
    all
}

fn with_files(typed: &OsStr, names: impl IntoIterator<Item = String>) -> Vec<CompletionCandidate> {
    let is_ours = |path: &Path| path.extension().is_some_and(|ending| ending == "v" || ending == "toml");
    let mut all = begun(typed, names);
    all.extend(PathCompleter::any().filter(move |path| path.is_dir() || is_ours(path)).complete(typed));
    all
}

/// The names that begin with what was typed.
fn begun(typed: &OsStr, names: impl IntoIterator<Item = String>) -> Vec<CompletionCandidate> {
    let typed = typed.to_string_lossy();
    let names = names.into_iter().filter(|name| name.starts_with(&*typed));
    names.map(CompletionCandidate::new).collect()
}
