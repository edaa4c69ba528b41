//! Matching the names of two tools: what one calls `fig1.adder.sum` another calls `bench.dut.adder.sum`.

use std::collections::{HashMap, HashSet};

use super::declared::{Declared, Kind};

/// Names of one side and those of the other that stand for them.
pub(super) type Match = [Vec<usize>; 2];

/// A last name that one file has more often than this tells nothing about which scopes stand for each other.
const MOST_ALIKE: usize = 64;

/// A scope of the expected waveform and the one that stands for it.
pub(super) type Scopes = (String, String);

/// The names that stand for each other: those under `maps`, then those under the pair of scopes that most names speak
/// for, then under the next one, and so on. What has no name of its own may be a bus in one file and bits in the other.
pub(super) fn matched(expected: &Declared, got: &Declared, maps: &[Scopes]) -> Vec<Match> {
    let [mine, theirs] = [Side::new(expected), Side::new(got)];
    let scopes: Vec<Scopes> = maps.iter().cloned().chain(voted(expected, got)).collect();
    let mut taken = HashSet::new();
    let mut found = Vec::new();
    for (index, name) in expected.names.iter().enumerate() {
        let candidates = scopes.iter().filter_map(|(from, to)| moved(&name.path, from, to));
        let other =
            candidates.filter_map(|path| theirs.find(&path, index, expected)).find(|other| !taken.contains(&other[0]));
        if let Some(other) = other {
            taken.extend(other.iter().copied());
            found.push([vec![index], other]);
        }
    }
    let used: HashSet<usize> = found.iter().map(|[mine, _]| mine[0]).collect();
    for (index, name) in got.names.iter().enumerate().filter(|(index, _)| !taken.contains(index)) {
        let candidates = scopes.iter().filter_map(|(from, to)| moved(&name.path, to, from));
        let bits = candidates.filter_map(|path| mine.bits(&path, index, got));
        if let Some(bits) = { bits }.find(|bits| bits.iter().all(|bit| !used.contains(bit))) {
            found.push([bits, vec![index]]);
        }
    }
    found
}

/// A path with one scope, or itself, put in the place of another.
pub(super) fn moved(path: &str, from: &str, to: &str) -> Option<String> {
    let rest = path.strip_prefix(from)?;
    let rest = if from.is_empty() {
        rest
    } else if rest.is_empty() {
        ""
    } else {
        rest.strip_prefix('.')?
    };
    Some(if rest.is_empty() || to.is_empty() { format!("{to}{rest}") } else { format!("{to}.{rest}") })
}

/// The one pair of scopes that most names speak for.
pub(super) fn best(expected: &Declared, got: &Declared) -> Option<Scopes> {
    voted(expected, got).into_iter().next()
}

struct Side<'a> {
    declared: &'a Declared,
    by_path: HashMap<&'a str, usize>,
}

impl<'a> Side<'a> {
    fn new(declared: &'a Declared) -> Self {
        let by_path = declared.names.iter().enumerate().map(|(index, name)| (name.path.as_str(), index)).collect();
        Self { declared, by_path }
    }

    /// What stands under `path` for a name of the other side.
    fn find(&self, path: &str, index: usize, other: &Declared) -> Option<Vec<usize>> {
        self.by_path.get(path).map(|&found| vec![found]).or_else(|| self.bits(path, index, other))
    }

    /// The bits that make the bus `index` of the other side, the least significant first.
    fn bits(&self, path: &str, index: usize, other: &Declared) -> Option<Vec<usize>> {
        let bus = &other.names[index];
        let signal = other.signals[bus.signal.index()];
        if signal.kind != Kind::Bits || signal.width < 2 {
            return None;
        }
        let (high, low) = bus.range.unwrap_or((i64::from(signal.width) - 1, 0));
        let step = if high < low { -1 } else { 1 };
        let bit = |at: i64| {
            let found = *self.by_path.get(format!("{path}[{}]", low.checked_add(at * step)?).as_str())?;
            let part = self.declared.signals[self.declared.names[found].signal.index()];
            (part.kind == Kind::Bits && part.width == 1).then_some(found)
        };
        (0..i64::from(signal.width)).map(bit).collect()
    }
}

/// Pairs of scopes that signals of the same last names speak for: what is left of two names when their common tail is
/// taken away. Those with most votes come first, then those with the shorter scopes.
fn voted(expected: &Declared, got: &Declared) -> Vec<Scopes> {
    let [mine, theirs] = [by_leaf(expected), by_leaf(got)];
    let mut votes: HashMap<Scopes, usize> = HashMap::new();
    for (leaf, paths) in &mine {
        let others = theirs.get(leaf).map_or(&[][..], Vec::as_slice);
        if paths.len() <= MOST_ALIKE && others.len() <= MOST_ALIKE {
            for (a, b) in paths.iter().flat_map(|a| others.iter().map(move |b| (a, b))) {
                *votes.entry(without_common_tail(a, b)).or_default() += 1;
            }
        }
    }
    let mut all: Vec<_> = votes.into_iter().collect();
    all.sort_by(|(a, votes), (b, others)| {
        others.cmp(votes).then((a.0.len() + a.1.len()).cmp(&(b.0.len() + b.1.len()))).then(a.cmp(b))
    });
    all.into_iter().map(|(scopes, _)| scopes).take(MOST_ALIKE).collect()
}

/// Paths without the index of a bit, by their last part, each once.
fn by_leaf(declared: &Declared) -> HashMap<&str, Vec<&str>> {
    let mut all: HashMap<&str, Vec<&str>> = HashMap::new();
    for name in &declared.names {
        let path =
            name.path.strip_suffix(']').and_then(|path| path.rsplit_once('[')).map_or(&*name.path, |(path, _)| path);
        let leaf = path.rsplit('.').next().unwrap_or(path);
        let paths = all.entry(leaf).or_default();
        if paths.last() != Some(&path) {
            paths.push(path);
        }
    }
    all
}

fn without_common_tail(a: &str, b: &str) -> Scopes {
    let common =
        a.rsplit('.').zip(b.rsplit('.')).take_while(|(a, b)| a == b).map(|(part, _)| part.len() + 1).sum::<usize>();
    let scope = |path: &str| path[..path.len().saturating_sub(common)].to_owned();
    (scope(a), scope(b))
}
