//! House rules that hold for every source file.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// Which rooms a room may import, as in the design's table. `None`: everything.
const MAY_IMPORT: &[(&str, Option<&[&str]>)] = &[
    ("base", Some(&[])),
    ("blocks", Some(&["base"])),
    ("netlist", Some(&["base", "blocks"])),
    ("compile", Some(&["base", "blocks", "netlist"])),
    ("engine", Some(&["base", "compile"])),
    ("scenario", Some(&["base"])),
    ("files", Some(&["base"])),
    ("trace", Some(&["base", "files"])),
    ("golden", Some(&["base"])),
    ("picture", Some(&["base", "files"])),
    ("plotfile", Some(&["base", "picture"])),
    ("draw", Some(&["base", "host", "picture", "simulation", "trace"])),
    ("export", Some(&["base", "blocks", "netlist", "scenario"])),
    // The front door puts the rooms together; only the command line stands before it.
    ("simulation", Some(&["base", "blocks", "netlist", "compile", "engine", "files", "scenario", "trace"])),
    ("host", Some(&["base", "simulation"])),
    ("plot", Some(&["picture"])),
    ("accuracy", Some(&["base", "scenario", "simulation", "trace"])),
    ("cli", None),
];

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

fn files(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for path in fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path()) {
        if path.is_dir() {
            found.extend(files(&path));
        } else if path.extension().is_some_and(|ending| ending == "rs") {
            found.push(path);
        }
    }
    found.sort();
    found
}

/// The files of `src` with their texts up to the first test module: tests may look into any room.
fn sources() -> Vec<(PathBuf, String)> {
    let read = |path: PathBuf| {
        let text = fs::read_to_string(&path).expect("text");
        (path, text)
    };
    files(&root().join("src")).into_iter().map(read).collect()
}

fn is_test(path: &Path) -> bool {
    let name = path.file_stem().expect("a name").to_string_lossy();
    name == "tests" || name.ends_with("_tests") || path.ends_with("blocks/bench.rs")
}

/// Code that is not a test or a comment.
fn code(text: &str) -> String {
    let end = ["#[cfg(test)]", "#[cfg(all(test,"].iter().filter_map(|start| text.find(start)).min();
    text[..end.unwrap_or(text.len())]
        .lines()
        .filter(|line| !line.trim_start().starts_with("//"))
        .collect::<Vec<_>>()
        .join("\n")
}

/// A module of the crate, as its names from the root on.
type Module = Vec<String>;

fn module_of(path: &Path) -> Module {
    let below = path.strip_prefix(root().join("src")).expect("below src").with_extension("");
    let names = below.iter().map(|name| name.to_string_lossy().into_owned());
    names.filter(|name| !["mod", "lib", "main"].contains(&name.as_str())).collect()
}

/// Every path in `code` that starts at the crate or above the module, grouped ones written out.
fn paths(code: &str) -> Vec<Vec<String>> {
    let mut found = Vec::new();
    for start in ["crate::", "super::"] {
        for (at, _) in code.match_indices(start) {
            let before = code[..at].chars().next_back();
            // What follows `::` belongs to a path that has been seen from its start.
            if !before.is_some_and(|c| c.is_alphanumeric() || "_:$".contains(c)) {
                tree(&code[at..], &mut Vec::new(), &mut found);
            }
        }
    }
    found
}

/// Writes out the use tree that `text` begins with, below `prefix`; returns what comes after it.
fn tree<'a>(text: &'a str, prefix: &mut Vec<String>, found: &mut Vec<Vec<String>>) -> &'a str {
    let depth = prefix.len();
    let mut rest = text.trim_start();
    loop {
        let end = rest.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(rest.len());
        prefix.push(rest[..end].to_owned());
        rest = &rest[end..];
        let Some(next) = rest.strip_prefix("::") else { break };
        rest = next;
        if let Some(mut inside) = rest.strip_prefix('{') {
            while !inside.trim_start().starts_with('}') && !inside.trim().is_empty() {
                inside = tree(inside, prefix, found).trim_start();
                // An alias, or the comma before the next one.
                inside = inside.find([',', '}']).map_or("", |end| inside[end..].trim_start_matches(','));
            }
            prefix.truncate(depth);
            return inside.trim_start().strip_prefix('}').unwrap_or("");
        }
    }
    found.push(prefix.clone());
    prefix.truncate(depth);
    rest
}

/// The modules, of those that `exist`, whose names the code of `module` uses.
fn imports(module: &Module, text: &str, exist: &BTreeSet<Module>) -> BTreeSet<Module> {
    let resolve = |path: Vec<String>| {
        let mut target = if path[0] == "crate" { Module::new() } else { module.clone() };
        for name in path {
            match name.as_str() {
                "crate" | "self" => {}
                "super" => drop(target.pop()),
                _ => {
                    target.push(name);
                    if !exist.contains(&target) {
                        target.pop();
                        break;
                    }
                }
            }
        }
        target
    };
    paths(&code(text)).into_iter().map(resolve).collect()
}

/// What each module imports.
fn all_imports() -> BTreeMap<Module, BTreeSet<Module>> {
    let sources = sources();
    let exist: BTreeSet<_> = sources.iter().map(|(path, _)| module_of(path)).collect();
    let sources = sources.iter().filter(|(path, _)| !is_test(path));
    sources.map(|(path, text)| (module_of(path), imports(&module_of(path), text, &exist))).collect()
}

#[test]
fn imports_are_seen_however_they_are_written() {
    let exist = [&["a"][..], &["a", "b"], &["a", "c"], &["d"], &["d", "e"]];
    let exist: BTreeSet<Module> =
        exist.iter().map(|names| names.iter().map(|name| (*name).to_owned()).collect()).collect();
    let seen = |text: &str| -> Vec<String> {
        imports(&vec!["a".to_owned(), "b".to_owned()], text, &exist).iter().map(|module| module.join("::")).collect()
    };
    for (text, modules) in [
        ("use crate::d::X;", &["d"][..]),
        ("use crate::{a::c::Y, d::{self, e::{X, Z as W}}, other};", &["", "a::c", "d", "d::e"]),
        ("use super::{\n    c,\n    Z,\n};", &["a", "a::c"]),
        ("fn f(x: super::super::d::X) -> crate::d::e::Y {}", &["d", "d::e"]),
        ("// use crate::d;\nuse std::crate_::d; #[cfg(test)] use crate::d;", &[]),
    ] {
        assert_eq!(seen(text), modules, "{text}");
    }
}

#[test]
fn rooms_import_only_what_the_design_allows() {
    let mut wrong = Vec::new();
    let is_room = |name: &String| root().join("src").join(name).is_dir();
    for (module, imported) in all_imports() {
        let Some(room) = module.first().filter(|name| is_room(name)) else { continue };
        let Some((_, allowed)) = MAY_IMPORT.iter().find(|(known, _)| known == room) else {
            wrong.push(format!("{}: the room `{room}` is not in the table", module.join("::")));
            continue;
        };
        for other in imported.iter().filter_map(|other| other.first()).filter(|other| is_room(other)) {
            if other != room && allowed.is_some_and(|allowed| !allowed.contains(&other.as_str())) {
                wrong.push(format!("{}: may not import `{other}`", module.join("::")));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// A module and those inside it are one: what is left are imports between neighbours.
fn is_around(one: &Module, other: &Module) -> bool {
    one.starts_with(other) || other.starts_with(one)
}

#[test]
fn no_modules_import_each_other_in_a_circle() {
    let mut open = all_imports();
    // One file lists the arguments of all commands, and each command takes its own from there.
    open.retain(|module, _| module.first().is_none_or(|room| room != "cli"));
    for (module, imported) in &mut open {
        imported.retain(|other| !is_around(module, other));
    }
    // A module that imports none of those left stands in no circle.
    while let Some(module) = open.iter().find(|(_, imported)| imported.is_empty()).map(|(module, _)| module.clone()) {
        open.remove(&module);
        open.values_mut().for_each(|imported| _ = imported.remove(&module));
    }
    let circles: Vec<_> = open.iter().map(|(module, imported)| format!("{module:?} imports {imported:?}")).collect();
    assert!(circles.is_empty(), "{}", circles.join("\n"));
}

#[test]
fn every_file_opens_by_saying_what_it_is() {
    for folder in ["src", "tests", "benches"] {
        for path in files(&root().join(folder)) {
            let text = fs::read_to_string(&path).expect("text");
            assert!(text.starts_with("//! "), "{} does not open with `//! `", path.display());
        }
    }
}

#[test]
fn nothing_prints_by_a_macro_that_panics_where_it_cannot() {
    for (path, text) in sources().into_iter().filter(|(path, _)| !is_test(path)) {
        let code = code(&text);
        for call in ["println!", "eprintln!", "print!(", "dbg!"] {
            assert!(!code.contains(call), "{} has {call}: the room `cli` has `print` and `say`", path.display());
        }
    }
}

#[test]
fn files_stay_small_enough_to_read() {
    for folder in ["src", "tests", "benches"] {
        for path in files(&root().join(folder)) {
            let lines = fs::read_to_string(&path).expect("text").lines().count();
            assert!(lines <= 500, "{} has {lines} lines: does it hold more than one idea?", path.display());
        }
    }
}
