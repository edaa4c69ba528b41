//! Which signals of two waveforms stand for each other.

use std::collections::{HashMap, HashSet};

use super::declared::{Declared, Kind, Name, SignalId};
use super::how::{How, Names};
use super::tails::{self, Match};

/// A signal, or bits of several, the least significant first.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub(super) enum Parts {
    Whole(SignalId),
    /// Signals of one bit.
    Bits(Vec<SignalId>),
}

/// A signal of both waveforms.
#[derive(Clone, Debug)]
pub(super) struct Pair {
    /// As the expected waveform calls it.
    pub name: String,
    pub width: u32,
    /// Names that stand for the same in both waveforms have the same.
    pub class: usize,
}

/// What is compared with what.
#[derive(Clone, Debug, Default)]
pub(super) struct Pairs {
    /// In the order of the expected waveform.
    pub all: Vec<Pair>,
    /// What stands for what, each once.
    pub classes: Vec<[Parts; 2]>,
    known: HashMap<[Parts; 2], usize>,
    /// Names that only one has.
    pub only: [Vec<String>; 2],
    /// Signals whose width differs.
    pub widths: Vec<(String, u32, u32)>,
    /// Signals of both that are not compared.
    pub uncompared: Vec<String>,
}

impl Pairs {
    pub fn new(expected: &Declared, got: &Declared, how: &How) -> Self {
        let matched = match &how.names {
            Names::Same => same(expected, got),
            Names::Tails(maps) => tails::matched(expected, got, maps),
        };
        let mut pairs = Self::default();
        let mut used = [HashSet::new(), HashSet::new()];
        for [mine, theirs] in &matched {
            for (used, names) in used.iter_mut().zip([mine, theirs]) {
                used.extend(names.iter().copied());
            }
            pairs.add([expected, got], mine, theirs);
        }
        for (side, declared) in [expected, got].into_iter().enumerate() {
            let left = declared.names.iter().enumerate().filter(|(index, _)| !used[side].contains(index));
            pairs.only[side] = left.map(|(_, name)| name.path.clone()).collect();
        }
        pairs
    }

    /// Pairs names, of which one side may have several: the bits of the other side's bus.
    fn add(&mut self, declared: [&Declared; 2], mine: &[usize], theirs: &[usize]) {
        let [a, b] = [&declared[0].names[mine[0]], &declared[1].names[theirs[0]]];
        let [first, second] = [declared[0].signals[a.signal.index()], declared[1].signals[b.signal.index()]];
        let name = if mine.len() > 1 { b.path.clone() } else { a.path.clone() };
        if first.kind != second.kind || first.kind == Kind::Other {
            return self.uncompared.push(name);
        }
        let (parts, width) = match (mine.len(), theirs.len()) {
            (1, 1) if first.width != second.width => return self.widths.push((name, first.width, second.width)),
            (1, 1) => ([Parts::Whole(a.signal), Parts::Whole(b.signal)], first.width),
            (1, _) => ([Parts::Whole(a.signal), bits(declared[1], theirs)], first.width),
            _ => ([bits(declared[0], mine), Parts::Whole(b.signal)], second.width),
        };
        let class = *self.known.entry(parts.clone()).or_insert_with(|| {
            self.classes.push(parts);
            self.classes.len() - 1
        });
        self.all.push(Pair { name, width, class });
    }
}

fn bits(declared: &Declared, names: &[usize]) -> Parts {
    Parts::Bits(names.iter().map(|&name| declared.names[name].signal).collect())
}

fn same(expected: &Declared, got: &Declared) -> Vec<Match> {
    let theirs: HashMap<&str, usize> = got.names.iter().map(path).zip(0..).collect();
    let mine = expected.names.iter().map(path).enumerate();
    mine.filter_map(|(index, name)| theirs.get(name).map(|&other| [vec![index], vec![other]])).collect()
}

fn path(name: &Name) -> &str {
    &name.path
}
