//! Bad circuits and the messages they get, side by side in `tests/errors`: `x.v` and `x.expected`.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use stepwright::netlist::load;

use crate::support::NoLibrary;

/// A lost file must not go unnoticed.
const FILES: usize = 37;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/errors")
}

fn circuits() -> Vec<PathBuf> {
    let entries = fs::read_dir(folder()).expect("a folder").map(|entry| entry.expect("an entry").path());
    let mut all: Vec<_> = entries.filter(|path| path.extension().is_some_and(|ending| ending == "v")).collect();
    all.sort();
    all
}

/// The message for a file, which must be wrong.
fn message(path: &Path) -> String {
    let name = path.file_name().and_then(|name| name.to_str()).expect("a name");
    let text = fs::read_to_string(path).expect("text");
    match load(name, &text, None, &NoLibrary, &[]) {
        Ok(_) => format!("{name} loads"),
        Err(report) => report.render(false),
    }
}

#[test]
fn every_bad_circuit_gets_the_message_beside_it() {
    let circuits = circuits();
    assert_eq!(circuits.len(), FILES);
    let mut wrong = Vec::new();
    for path in circuits {
        let expected = path.with_extension("expected");
        let message = message(&path);
        if std::env::var_os("STEPWRIGHT_BLESS").is_some() && std::env::var_os("CI").is_none() {
            fs::write(&expected, &message).expect("writable");
        }
        if fs::read_to_string(&expected).unwrap_or_default() != message {
            wrong.push(format!("{} now gives:\n{message}", path.display()));
        }
    }
    assert!(wrong.is_empty(), "STEPWRIGHT_BLESS=1 rewrites them\n{}", wrong.join("\n"));
}

#[test]
fn every_file_shows_the_code_of_its_name_and_every_code_has_a_file() {
    let mut shown = BTreeSet::new();
    for path in circuits() {
        let name = path.file_stem().and_then(|name| name.to_str()).expect("a name").to_owned();
        let code = name[..4].to_uppercase();
        let message = message(&path);
        assert!(message.contains(&format!("error[{code}]")), "{name}");
        shown.insert(code);
    }
    // The table in the documentation of the room names each code once.
    let table = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("src/netlist/mod.rs")).expect("text");
    let rows = table.lines().filter_map(|line| line.strip_prefix("//! | N"));
    let documented: BTreeSet<_> = rows.map(|row| format!("N{}", &row[..3])).collect();
    assert_eq!(shown, documented);
}

#[test]
fn every_message_names_a_place_and_says_what_to_do() {
    for path in circuits() {
        let message = message(&path);
        let name = path.file_name().and_then(|name| name.to_str()).expect("a name");
        assert!(message.contains(name), "{name}: {message}");
        assert!(message.contains('^') || message.contains("N001"), "{name}: {message}");
    }
}

#[test]
fn a_loop_is_printed_hop_by_hop_with_places() {
    let message = message(&folder().join("n024_loop.v"));
    for part in [
        "a combinational loop through 2 cells",
        "hop 1: `q` -> `inner_1.x` -> `inner_1.passed` -> `in0` of `not_1` (not) -> `out`, n024_loop.v:10:9",
        "hop 2: `inner_1.y` -> `q_bar` -> `in1` of `nor_1` (nor) -> `out`, n024_loop.v:3:9",
    ] {
        assert!(message.contains(part), "{part}\n{message}");
    }
}
