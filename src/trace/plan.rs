//! The plan of a trace: which values are read once a tick, and under which names they are shown.

use std::collections::{HashMap, HashSet};

use crate::base::{Signal, ValueId};

crate::define_id!(
    /// A distinct value of a [`Plan`]; aliases share one.
    SlotId
);

/// A value that is read once a tick.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Slot {
    /// Where it is.
    pub value: ValueId,
    /// Width in bits, 1 to 64.
    pub width: u32,
}

/// A step of the walk over a plan's scopes: what a waveform's header holds, in its order.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Item<'a> {
    /// A scope opens.
    Open(&'a str),
    /// A signal of the scope opened last.
    Signal(&'a Signal, SlotId),
    /// The scope opened last closes.
    Close,
}

/// Distinct values and named signals of a trace, decided before the run.
#[derive(Clone, Debug)]
pub struct Plan {
    slots: Vec<Slot>,
    signals: Vec<(Signal, SlotId)>,
    /// The first holds the top scopes.
    scopes: Vec<Scope>,
}

#[derive(Clone, Debug, Default)]
struct Scope {
    name: String,
    signals: Vec<usize>,
    inner: Vec<usize>,
}

impl Plan {
    /// The plan for `signals`, in their order; of two with the same path the first counts.
    #[must_use]
    pub fn new(signals: &[Signal]) -> Self {
        let mut plan = Self { slots: Vec::new(), signals: Vec::new(), scopes: vec![Scope::default()] };
        let (mut slots, mut scopes, mut seen) = (HashMap::new(), HashMap::new(), HashSet::new());
        for signal in signals.iter().filter(|signal| seen.insert(&signal.path)) {
            let slot = Slot { value: signal.value, width: signal.width };
            let id = *slots.entry(slot).or_insert_with(|| {
                plan.slots.push(slot);
                SlotId::new(plan.slots.len() - 1)
            });
            let (_, path) = signal.path.split_last().unwrap_or((&plan.scopes[0].name, &[]));
            let scope = plan.scope(path, &mut scopes);
            plan.scopes[scope].signals.push(plan.signals.len());
            plan.signals.push((signal.clone(), id));
        }
        plan
    }

    /// The scope of a path, made where it is missing.
    fn scope<'a>(&mut self, path: &'a [String], known: &mut HashMap<(usize, &'a str), usize>) -> usize {
        path.iter().fold(0, |outer, name| {
            *known.entry((outer, name)).or_insert_with(|| {
                self.scopes.push(Scope { name: name.clone(), ..Scope::default() });
                let inner = self.scopes.len() - 1;
                self.scopes[outer].inner.push(inner);
                inner
            })
        })
    }

    /// The distinct values, by [`SlotId`], in the order in which signals first name them.
    #[must_use]
    pub fn slots(&self) -> &[Slot] {
        &self.slots
    }

    /// Scope by scope, a scope's signals before its inner scopes, all in the order of the signals.
    pub fn walk(&self) -> impl Iterator<Item = Item<'_>> {
        let mut items = Vec::new();
        self.walk_scope(0, &mut items);
        items.into_iter()
    }

    fn walk_scope<'a>(&'a self, scope: usize, items: &mut Vec<Item<'a>>) {
        let scope = &self.scopes[scope];
        items.extend(scope.signals.iter().map(|&i| Item::Signal(&self.signals[i].0, self.signals[i].1)));
        for &inner in &scope.inner {
            items.push(Item::Open(&self.scopes[inner].name));
            self.walk_scope(inner, items);
            items.push(Item::Close);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn signal(path: &str, value: usize) -> Signal {
        let path = path.split('.').map(str::to_owned).collect();
        Signal { path, width: 4, signed: false, fraction: None, value: ValueId::new(value) }
    }

    #[test]
    fn scattered_signals_of_a_scope_are_brought_together_and_aliases_share_a_slot() {
        let signals = ["t.a", "t.b.x", "t.c.y", "t.d", "t.b.z"];
        let signals: Vec<_> = signals.iter().zip([7, 5, 7, 6, 5]).map(|(path, value)| signal(path, value)).collect();
        let plan = Plan::new(&signals);
        let shown: Vec<_> = plan
            .walk()
            .map(|item| match item {
                Item::Open(name) => format!("{name}{{"),
                Item::Signal(signal, slot) => format!("{}:{}", signal.path.last().unwrap(), slot.index()),
                Item::Close => "}".to_owned(),
            })
            .collect();
        assert_eq!(shown.join(" "), "t{ a:0 d:2 b{ x:1 z:1 } c{ y:0 } }");
        assert_eq!(plan.slots().iter().map(|slot| slot.value.index()).collect::<Vec<_>>(), [7, 5, 6]);
    }

    #[test]
    fn a_path_that_occurs_twice_is_declared_once() {
        let plan = Plan::new(&[signal("t.a", 1), signal("t.a", 2)]);
        assert_eq!(plan.slots().len(), 1);
        assert_eq!(plan.walk().count(), 3);
    }
}
