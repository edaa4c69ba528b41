//! The decision tree: which values of one bit a tick asks for, one after the other, before it does what is left to do.

use super::profile::{Profile, Ticks, count};
use super::view::View;
use crate::base::ValueId;
use crate::engine::Work;

/// What a tick does.
pub(super) enum Tree {
    /// Asks for a value of one bit and goes on with the first tree if it is 0, the second if it is 1.
    Fork { on: ValueId, view: View, branches: Box<[Tree; 2]> },
    /// Does what can still change. It was so in this share of the profile's ticks.
    Leaf { view: View, share: f64 },
    /// So rare that the plain code does it.
    Rest,
}

/// What guessing a branch wrong costs, in machine operations.
const MISS: f64 = 4.0;
/// What a branch costs.
const BRANCH: f64 = 1.0;
/// Leaves that are rarer are left to the plain code.
const RARE: f64 = 1.0 / 512.0;
/// How many of the most useful values of a fork the forks below it choose from.
const CANDIDATES: usize = 32;

/// Forks on a path at most. Measured: from 5 on nothing is gained any more.
const DEPTH: usize = 6;

/// The tree of a tick under a profile.
pub(super) fn grow(view: View, profile: &Profile) -> Tree {
    let values = (0..profile.values.len()).collect();
    Grower { profile }.grow(view, &profile.all(), values, DEPTH)
}

impl Tree {
    /// Tells of every leaf what is left to do and its share of the profile's ticks.
    pub fn leaves(&self, tell: &mut impl FnMut(Work, f64)) {
        match self {
            Tree::Fork { branches, .. } => branches.iter().for_each(|branch| branch.leaves(tell)),
            Tree::Leaf { view, share } => tell(view.work(), *share),
            Tree::Rest => {}
        }
    }
}

struct Grower<'a> {
    profile: &'a Profile,
}

/// A value to ask for, and what a tick costs then, about.
struct Choice {
    value: usize,
    cost: f64,
}

impl Grower<'_> {
    fn grow(&self, view: View, ticks: &Ticks, values: Vec<usize>, depth: usize) -> Tree {
        let share = f64::from(count(ticks)) / self.profile.ticks() as f64;
        if share < RARE {
            return Tree::Rest;
        }
        let choices = if depth == 0 { Vec::new() } else { self.choices(&view, ticks, &values) };
        match choices.first() {
            Some(best) if best.cost + BRANCH < view.cost() => {
                let on = self.profile.values[best.value];
                let values: Vec<_> = choices.iter().take(CANDIDATES).map(|choice| choice.value).collect();
                let branches = [false, true].map(|bit| {
                    let ticks = self.profile.among(ticks, best.value, bit);
                    self.grow(view.assuming(on, bit), &ticks, values.clone(), depth - 1)
                });
                Tree::Fork { on, view, branches: Box::new(branches) }
            }
            _ => Tree::Leaf { view, share },
        }
    }

    /// What may be asked for, the best first.
    fn choices(&self, view: &View, ticks: &Ticks, values: &[usize]) -> Vec<Choice> {
        let mut is_live = vec![false; view.graph.nodes.len()];
        view.live.iter().for_each(|id| is_live[id.index()] = true);
        let live = values.iter().filter(|&&value| is_live[self.profile.values[value].index()]);
        let mut choices: Vec<_> = live.map(|&value| Choice { value, cost: self.cost(view, ticks, value) }).collect();
        choices.sort_by(|a, b| a.cost.total_cmp(&b.cost));
        choices
    }

    /// What a tick costs on average after value number so-and-so has been asked for.
    fn cost(&self, view: &View, ticks: &Ticks, value: usize) -> f64 {
        let all = f64::from(count(ticks));
        let high = f64::from(count(&self.profile.among(ticks, value, true)));
        let on = self.profile.values[value];
        let cost = |bit, ticks| if ticks == 0.0 { 0.0 } else { ticks * view.assuming(on, bit).cost() };
        let flips = f64::from(self.profile.flips(ticks, value));
        BRANCH + (cost(false, all - high) + cost(true, high) + MISS * flips) / all
    }
}
