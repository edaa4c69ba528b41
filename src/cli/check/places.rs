//! Which scenarios are checked, and where their golden traces are.

use std::path::{Component, Path, PathBuf};

use crate::base::{Diagnostic, Report};
use crate::files;
use crate::simulation::shipped;

/// The folder of scenarios that are checked when none is named.
pub(super) const ROOT: &str = "circuits";

/// The scenario files of what was named: files, folders, and either below `./circuits`, with or without the ending.
///
/// # Errors
/// `C001` for each that is nowhere.
pub(super) fn scenarios(named: &[PathBuf]) -> Result<Vec<PathBuf>, Report> {
    let (mut all, mut wrong) = (Vec::new(), Vec::new());
    for name in named {
        let near = [name.clone(), Path::new(ROOT).join(name)];
        let with_ending = near.iter().map(|path| path.with_added_extension("toml"));
        let files = near.iter().filter(|path| path.extension().is_some_and(|ending| ending == "toml"));
        let mut files = files.cloned().chain(with_ending).filter(|path| path.is_file());
        match (files.next(), near.iter().find(|path| path.is_dir())) {
            (Some(file), _) => all.push(file),
            (None, Some(folder)) => all.extend(files::below(folder, "toml")),
            (None, None) => wrong.push(nowhere(&name.to_string_lossy())),
        }
    }
    all.sort();
    all.dedup();
    if wrong.is_empty() { Ok(all) } else { Err(Report::new(Default::default(), wrong)) }
}

fn nowhere(name: &str) -> Diagnostic {
    let wrong = Diagnostic::new("C001", format!("there is no scenario or folder `{name}`"));
    if shipped::file(name, "toml").is_some() {
        let copy = "copy the shipped one to check it: stepwright show --source";
        return wrong.help(format!("{copy} {name}.toml > {}.toml", name.rsplit('/').next().unwrap_or(name)));
    }
    let near: Vec<_> = files::below(Path::new(ROOT), "toml").iter().map(|path| scenario_name(path)).collect();
    wrong
        .nearest(name, near.iter().map(String::as_str))
        .help("a scenario is named by its path, or by that below ./circuits")
}

fn scenario_name(path: &Path) -> String {
    path.strip_prefix(ROOT).unwrap_or(path).with_extension("").display().to_string()
}

/// Where the golden trace of a scenario is: where it says, seen from its folder; for `circuits/A/B.toml`, beside the
/// last folder called `circuits`, `traces/A/B.vcd`; for any other `B.toml` beside it `B.golden.vcd`, a name that no
/// dump gets by chance.
pub(super) fn golden(scenario: &Path, said: Option<&str>) -> PathBuf {
    if let Some(said) = said {
        return scenario.with_file_name(said);
    }
    let whole = || std::path::absolute(scenario).ok().and_then(|path| below_circuits(&path));
    below_circuits(scenario).or_else(whole).unwrap_or_else(|| scenario.with_extension("golden.vcd"))
}

fn below_circuits(scenario: &Path) -> Option<PathBuf> {
    let parts: Vec<_> = scenario.components().collect();
    let place = parts.iter().rposition(|part| *part == Component::Normal(ROOT.as_ref()))?;
    let (before, below) = (parts[..place].iter().collect::<PathBuf>(), parts[place + 1..].iter().collect::<PathBuf>());
    Some(before.join("traces").join(below).with_extension("vcd"))
}
