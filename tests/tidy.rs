//! House rules that hold for every source file.

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
    ("export", Some(&["base", "blocks", "netlist", "scenario"])),
    // The front door puts the rooms together; only the command line stands before it.
    ("simulation", Some(&["base", "blocks", "netlist", "compile", "engine", "files", "scenario", "trace"])),
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

fn room_of(path: &Path) -> Option<String> {
    let below = path.strip_prefix(root().join("src")).expect("below src");
    (below.components().count() > 1)
        .then(|| below.components().next().expect("a room").as_os_str().to_string_lossy().into())
}

/// The rooms named after `crate::` in code that is not a test or a comment.
fn imported(text: &str) -> Vec<String> {
    let code = text.split("#[cfg(test)]").next().expect("a first part");
    let lines = code.lines().filter(|line| !line.trim_start().starts_with("//"));
    lines
        .flat_map(|line| line.split("crate::").skip(1))
        .map(|rest| rest.chars().take_while(|c| c.is_ascii_lowercase() || *c == '_').collect::<String>())
        .filter(|name| MAY_IMPORT.iter().any(|(room, _)| room == name))
        .collect()
}

#[test]
fn rooms_import_only_what_the_design_allows() {
    let mut wrong = Vec::new();
    for (path, text) in sources() {
        let Some(room) = room_of(&path).filter(|_| !is_test(&path)) else { continue };
        let Some((_, allowed)) = MAY_IMPORT.iter().find(|(known, _)| *known == room) else {
            wrong.push(format!("{}: the room `{room}` is not in the table", path.display()));
            continue;
        };
        for other in imported(&text) {
            if other != room && allowed.is_some_and(|allowed| !allowed.contains(&other.as_str())) {
                wrong.push(format!("{}: `{room}` may not import `{other}`", path.display()));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
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
fn only_the_command_line_prints() {
    for (path, text) in sources() {
        let code = text.split("#[cfg(test)]").next().expect("a first part");
        let prints = ["println!", "eprintln!", "print!(", "dbg!"]
            .iter()
            .any(|call| code.lines().any(|line| line.contains(call) && !line.trim_start().starts_with("//")));
        let allowed = room_of(&path).as_deref() == Some("cli") || is_test(&path);
        assert!(!prints || allowed, "{} prints", path.display());
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
