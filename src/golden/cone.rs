//! What drives the compared signals, through all that the waveforms do not hold.

use std::collections::{BTreeSet, HashMap, HashSet};

use super::declared::Declared;
use super::drivers::Drivers;
use super::pairs::Pairs;
use super::tails;

/// How many signals are walked through from one before the walk gives up; reached only where nearly nothing is traced.
const MOST_STEPS: usize = 100_000;

/// The nearest signals behind a compared one, as one of its names is made. Where two nets always say the same in both
/// waveforms they are one signal that is made in two ways.
#[derive(Clone, Default, Debug)]
pub(super) struct Cone {
    /// The compared signals that it is computed from, and whether each works through state.
    pub by: Vec<(usize, bool)>,
    /// What it is called where it is made, and what makes it; `None` when its drivers are not known.
    pub made: Option<(String, String)>,
    /// How many nets between it and them are not compared.
    pub untraced: usize,
}

/// The cones of compared signals by class, each found when it is asked for.
pub(super) struct Cones<'a> {
    drivers: &'a Drivers,
    class_of: HashMap<&'a str, usize>,
    names_of: HashMap<usize, Vec<&'a str>>,
    known: HashMap<usize, Vec<Cone>>,
}

impl<'a> Cones<'a> {
    /// The netlist stands in the waveforms where most of its names are found, whatever scopes are around it there.
    pub fn new(drivers: &'a Drivers, pairs: &Pairs) -> Self {
        // In order, because that of a hash map is another one every time.
        let behind = drivers.values().flat_map(|driven| driven.by.iter().map(|driver| driver.net.as_str()));
        let all: BTreeSet<&str> = drivers.keys().map(String::as_str).chain(behind).collect();
        let compared = Declared::of_names(pairs.all.iter().map(|pair| pair.name.as_str()));
        let scopes = tails::best(&Declared::of_names(all.iter().copied()), &compared);
        let classes: HashMap<&str, usize> = pairs.all.iter().map(|pair| (pair.name.as_str(), pair.class)).collect();
        let mut cones = Self { drivers, class_of: HashMap::new(), names_of: HashMap::new(), known: HashMap::new() };
        for name in all {
            let path = scopes.as_ref().and_then(|(from, to)| tails::moved(name, from, to));
            if let Some(&class) = path.and_then(|path| classes.get(path.as_str())) {
                cones.class_of.insert(name, class);
                cones.names_of.entry(class).or_default().push(name);
            }
        }
        // What is inside a block comes after its ports.
        cones.names_of.values_mut().for_each(|names| names.sort_by_key(|name| name.matches('.').count()));
        cones
    }

    /// The cones of a class, at least one.
    pub fn of(&mut self, class: usize) -> &[Cone] {
        if !self.known.contains_key(&class) {
            let names = self.names_of.get(&class).map_or(&[][..], Vec::as_slice);
            let sources = names.iter().filter(|name| !self.is_passed_on(class, name));
            let mut cones: Vec<_> = sources.map(|source| self.walk(class, source, names)).collect();
            if cones.is_empty() {
                cones.push(Cone::default());
            }
            self.known.insert(class, cones);
        }
        &self.known[&class]
    }

    /// Whether a name only passes on what another name of the same signal says.
    fn is_passed_on(&self, class: usize, name: &str) -> bool {
        let is_same = |name: &str| self.class_of.get(name) == Some(&class);
        let driven = self.drivers.get(name);
        driven.is_some_and(|driven| driven.by.iter().any(|driver| !driver.delayed && is_same(&driver.net)))
    }

    fn walk(&self, class: usize, source: &'a str, names: &[&'a str]) -> Cone {
        let mut cone = Cone { made: self.made(source, names), ..Cone::default() };
        let mut stack = vec![(source, false)];
        let mut seen = HashSet::from([(source, false)]);
        let mut untraced = HashSet::new();
        while let Some((net, delayed)) = stack.pop() {
            for driver in self.drivers.get(net).map_or(&[][..], |driven| &driven.by) {
                let at = (driver.net.as_str(), delayed || driver.delayed);
                match self.class_of.get(at.0) {
                    // A net that is wrong because it was wrong itself tells nothing.
                    Some(&behind) if behind == class => {}
                    Some(&behind) => cone.by.push((behind, at.1)),
                    None if seen.len() < MOST_STEPS && seen.insert(at) => {
                        untraced.extend(self.drivers.get(at.0).filter(|driven| driven.is_net).map(|_| at.0));
                        stack.push(at);
                    }
                    None => {}
                }
            }
        }
        cone.by.sort_unstable();
        cone.by.dedup();
        cone.untraced = untraced.len();
        cone
    }

    /// Of a name the net that a block or gate drives there, in the scope where it does, and the block or gate.
    fn made(&self, source: &str, names: &[&str]) -> Option<(String, String)> {
        let made = self.drivers.get(source)?;
        let is_next = |name: &&&str| {
            let driven = self.drivers.get(**name);
            driven.is_some_and(|driven| driven.is_net && driven.by.iter().any(|driver| driver.net == source))
        };
        let net = if made.is_net { None } else { names.iter().find(is_next) };
        Some((net.map_or(source, |net| net).to_owned(), made.place.clone()))
    }
}
