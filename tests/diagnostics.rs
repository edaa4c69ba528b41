//! The table of all diagnostics against the sources: no code without a row, no row without a code, and the tests it names.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use crate::outside::tools::files_below;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The rows: code, and what raises it.
fn rows() -> Vec<(String, String)> {
    let table = fs::read_to_string(root().join("docs/diagnostics.md")).expect("text");
    let cells = table.lines().map(|line| line.split(" | ").collect::<Vec<_>>());
    let rows = cells.filter(|cells| cells.len() == 3 && cells[0].ends_with(|c: char| c.is_ascii_digit()));
    rows.map(|cells| (cells[0][2..].to_owned(), cells[2].trim_end_matches(" |").to_owned())).collect()
}

/// Codes in the sources, tests not counted, and a file that has each.
fn used() -> BTreeMap<String, PathBuf> {
    let mut used = BTreeMap::new();
    for path in files_below("src", "rs").into_iter().filter(|path| !path.to_string_lossy().ends_with("tests.rs")) {
        let text = fs::read_to_string(&path).expect("text");
        let code = text.split("#[cfg(test)]").next().expect("a first part");
        for (at, _) in code.match_indices('"') {
            let word = code[at + 1..].split('"').next().expect("a first part");
            let is_code = |mut c: std::str::Chars<'_>| {
                c.next().is_some_and(|c| c.is_ascii_uppercase()) && c.all(|c| c.is_ascii_digit())
            };
            // N000 is never shown.
            if word.len() == 4 && is_code(word.chars()) && word != "N000" {
                used.insert(word.to_owned(), path.clone());
            }
        }
    }
    used
}

#[test]
fn every_code_stands_in_the_table_once_and_in_order() {
    let rows = rows();
    let listed: Vec<_> = rows.iter().map(|(code, _)| code).collect();
    let used = used();
    assert!(used.len() > 60, "only {} codes are found in the sources", used.len());
    assert_eq!(listed, used.keys().collect::<Vec<_>>());
}

#[test]
fn the_test_that_the_table_names_is_there_and_speaks_of_the_code() {
    for (code, raised_by) in rows() {
        let names: Vec<_> = raised_by.split('`').skip(1).step_by(2).collect();
        match names[..] {
            [] => assert!(raised_by.starts_with("none"), "{code}: {raised_by}"),
            // Its own test demands a file for each code, and the code in its message.
            ["tests/errors"] => assert!(code.starts_with('N'), "{code}"),
            [file, test] => {
                let text = fs::read_to_string(root().join(file)).unwrap_or_else(|error| panic!("{file}: {error}"));
                assert!(text.contains(&format!("fn {test}(")), "{code}: {file} has no {test}");
                assert!(text.contains(&code), "{code}: {file} does not name it");
            }
            _ => panic!("{code}: {raised_by}"),
        }
    }
}
