//! Pages that say what the program does, held against it.

use std::fs;
use std::process::Command;

use stepwright::scenario::{self, KEYS};

fn page(path: &str) -> String {
    fs::read_to_string(format!("{}/{path}", env!("CARGO_MANIFEST_DIR"))).expect("a page")
}

/// The fenced blocks of a page in a language.
fn fenced(page: &str, language: &str) -> Vec<String> {
    let mut blocks = Vec::new();
    let mut lines = page.lines();
    while let Some(line) = lines.next() {
        if let Some(found) = line.strip_prefix("```") {
            let block: Vec<_> = lines.by_ref().take_while(|line| *line != "```").collect();
            if found == language {
                blocks.push(block.join("\n") + "\n");
            }
        }
    }
    blocks
}

#[test]
fn the_picture_on_the_front_page_is_what_its_command_prints() {
    let readme = page("README.md");
    let command = &fenced(&readme, "sh")[0];
    let words: Vec<_> =
        command.trim().strip_prefix("cargo run --release -- ").expect("the command").split(' ').collect();
    let folder = tempfile::tempdir().expect("a folder");
    let output = Command::new(env!("CARGO_BIN_EXE_stepwright")).current_dir(&folder).args(words).output();
    assert_eq!(String::from_utf8(output.expect("it starts").stdout).expect("text"), fenced(&readme, "text")[0]);
    assert!(folder.path().join("table1.gtkw").is_file());
}

/// Each command of a page in a shell block, with what the page says it prints: the text block just behind it.
fn commands(page: &str) -> Vec<(String, String)> {
    let mut parts = page.split("```sh\n").skip(1).filter_map(|rest| rest.split_once("```\n\n```text\n")).peekable();
    let shown = |(command, rest): (&str, &str)| {
        let output = rest.split("```").next().expect("a first part");
        (!command.contains("```")).then(|| (command.trim().to_owned(), output.to_owned()))
    };
    assert!(parts.peek().is_some(), "the page has no command with its output");
    parts.filter_map(shown).collect()
}

#[test]
fn what_stands_below_a_command_on_the_pages_of_accuracy_is_what_it_prints() {
    let folder = tempfile::tempdir().expect("a folder");
    for path in ["docs/accuracy.md", "docs/hazards.md"] {
        for (command, expected) in commands(&page(path)) {
            let words = shlex::split(&command).expect("words");
            let mut program = Command::new(env!("CARGO_BIN_EXE_stepwright"));
            let output = program.current_dir(&folder).args(&words[1..]).output().expect("it starts");
            assert_eq!(String::from_utf8_lossy(&output.stdout), expected, "{path}: {command}");
        }
    }
}

#[test]
fn every_key_of_a_scenario_is_on_its_page() {
    let page = page("docs/scenarios.md");
    for (key, inner) in KEYS {
        let named = [format!("| `{key}` |"), format!("| `[{key}]` "), format!("| `[[{key}]]` ")];
        assert!(named.iter().any(|name| page.contains(name)), "{key}");
        for name in *inner {
            let rows = page.lines().filter(|line| named[1..].iter().any(|name| line.starts_with(name)));
            assert!(
                rows.clone().any(|row| row.split('|').nth(1).unwrap().contains(&format!("`{name}`"))),
                "{key}.{name}"
            );
        }
    }
}

#[test]
fn the_example_of_a_scenario_uses_every_key_but_one_and_does_what_it_expects() {
    let examples = fenced(&page("docs/scenarios.md"), "toml");
    let [example] = examples.as_slice() else { panic!("{} examples", examples.len()) };
    scenario::parse("docs/scenarios.md", example).expect("it is right");
    let table: toml::Table = example.parse().expect("TOML");
    for (key, inner) in KEYS {
        let value = table.get(*key).unwrap_or_else(|| panic!("{key} is not in the example"));
        let value = value.as_array().map_or(value, |list| &list[0]);
        // A run ends by `ticks` or `until`.
        for name in inner.iter().filter(|name| (*key, **name) != ("stop", "ticks")) {
            assert!(value.get(name).is_some(), "{key}.{name} is not in the example");
        }
    }
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("steep.toml"), example).expect("a file");
    let run = |arguments: &[&str]| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_stepwright"));
        command.current_dir(&folder).args(arguments).env_remove("CI").output().expect("it starts")
    };
    let output = run(&["run", "steep.toml", "--table"]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    assert!(run(&["check", "--bless", "steep.toml"]).status.success());
    assert!(folder.path().join("goldens/steep.vcd").is_file());
}
