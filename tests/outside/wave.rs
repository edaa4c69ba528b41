//! What Icarus wrote: for each variable its word at every tick.

use std::collections::HashMap;
use std::path::Path;

use stepwright::export::BRANCH;
use vcd::{Command, IdCode, Parser, ScopeItem, TimescaleUnit, Value};

/// A waveform.
pub struct Wave {
    names: HashMap<String, IdCode>,
    /// Of each variable the ticks at which it changed, with the words since; `None` where a bit is unknown.
    changes: HashMap<IdCode, Vec<(u64, Option<u64>)>>,
}

/// A variable of a [`Wave`].
#[derive(Clone, Copy)]
pub struct Variable<'w>(&'w [(u64, Option<u64>)]);

impl Wave {
    /// Reads what an exported bench wrote: without the bench's own scope, and without those of the branches that
    /// blocks are made in.
    pub fn of_bench(path: &Path) -> Self {
        let file = std::io::BufReader::new(std::fs::File::open(path).expect("a waveform"));
        let mut parser = Parser::new(file);
        let header = parser.parse_header().expect("a header");
        assert_eq!(header.timescale, Some((100, TimescaleUnit::PS)), "the bench's time unit");
        let [ScopeItem::Scope(bench)] = &header.items[..] else { panic!("the bench's scope is the only one") };
        let mut wave = Self { names: HashMap::new(), changes: HashMap::new() };
        wave.declare(&bench.items, "");
        let mut tick = 0;
        for command in parser {
            let (id, word) = match command.expect("a command") {
                // A tick lasts 1 ns; the clock, and nothing else, changes in the middle of it.
                Command::Timestamp(time) => {
                    tick = time / 10;
                    continue;
                }
                Command::ChangeScalar(id, value) => (id, bit(value)),
                Command::ChangeVector(id, value) => {
                    (id, value.iter().try_fold(0, |word, value| Some(word << 1 | bit(value)?)))
                }
                _ => continue,
            };
            wave.changes.entry(id).or_default().push((tick, word));
        }
        wave
    }

    /// The variable of a dotted name below the bench.
    pub fn find(&self, name: &str) -> Option<Variable<'_>> {
        self.names.get(name).map(|id| Variable(self.changes.get(id).map_or(&[], Vec::as_slice)))
    }

    fn declare(&mut self, items: &[ScopeItem], prefix: &str) {
        for item in items {
            match item {
                ScopeItem::Scope(scope) if scope.identifier == BRANCH => self.declare(&scope.items, prefix),
                ScopeItem::Scope(scope) => self.declare(&scope.items, &format!("{prefix}{}.", scope.identifier)),
                ScopeItem::Var(var) => _ = self.names.insert(format!("{prefix}{}", var.reference), var.code),
                _ => {}
            }
        }
    }
}

impl Variable<'_> {
    /// Its word at the end of a tick.
    pub fn at(self, tick: u64) -> Option<u64> {
        let past = self.0.partition_point(|(since, _)| *since <= tick);
        self.0[..past].last().and_then(|(_, word)| *word)
    }
}

fn bit(value: Value) -> Option<u64> {
    match value {
        Value::V0 => Some(0),
        Value::V1 => Some(1),
        _ => None,
    }
}
