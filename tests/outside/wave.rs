//! What Icarus wrote, tick by tick.

use std::collections::HashMap;
use std::path::Path;

use vcd::{Command, Parser, ScopeItem, Value};

/// Reads the waveform of an exported bench: for each variable its word at ticks `0..=ticks`, `None` where a bit is
/// unknown. Names are dotted, below the bench.
pub fn read(path: &Path, ticks: u64) -> HashMap<String, Vec<Option<u64>>> {
    let file = std::io::BufReader::new(std::fs::File::open(path).expect("a waveform"));
    let mut parser = Parser::new(file);
    let header = parser.parse_header().expect("a header");
    assert_eq!(header.timescale, Some((100, vcd::TimescaleUnit::PS)), "the bench's time unit");
    let mut names = HashMap::new();
    declared(&header.items, "", &mut names);
    let mut now: HashMap<vcd::IdCode, Option<u64>> = HashMap::new();
    let mut all: HashMap<vcd::IdCode, Vec<Option<u64>>> = HashMap::new();
    let mut tick = 0;
    for command in parser {
        match command.expect("a command") {
            Command::Timestamp(time) => {
                // The values of a tick are those before the first time that is past it; half ticks are the clock's.
                while tick <= ticks && tick * 10 < time {
                    now.iter().for_each(|(id, value)| all.entry(*id).or_default().push(*value));
                    tick += 1;
                }
            }
            Command::ChangeScalar(id, value) => _ = now.insert(id, bit(value)),
            Command::ChangeVector(id, value) => {
                let word = value.iter().try_fold(0, |word, value| Some(word << 1 | bit(value)?));
                now.insert(id, word);
            }
            _ => {}
        }
    }
    names.into_iter().map(|(name, id)| (name, all.get(&id).cloned().unwrap_or_default())).collect()
}

fn bit(value: Value) -> Option<u64> {
    match value {
        Value::V0 => Some(0),
        Value::V1 => Some(1),
        _ => None,
    }
}

fn declared(items: &[ScopeItem], prefix: &str, names: &mut HashMap<String, vcd::IdCode>) {
    for item in items {
        match item {
            ScopeItem::Scope(scope) if prefix.is_empty() => declared(&scope.items, ".", names),
            ScopeItem::Scope(scope) if scope.identifier == stepwright::export::BRANCH => {
                declared(&scope.items, prefix, names)
            }
            ScopeItem::Scope(scope) => declared(&scope.items, &format!("{prefix}{}.", scope.identifier), names),
            ScopeItem::Var(var) => _ = names.insert(format!("{prefix}{}", var.reference).split_off(1), var.code),
            _ => {}
        }
    }
}
