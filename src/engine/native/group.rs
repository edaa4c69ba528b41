//! Groups: module instances whose code may be shared with instances that are built alike.

use std::collections::HashMap;

use crate::compile::Program;

/// Ops of no group: code of their own.
pub(super) const FLAT: u32 = 0;

/// The least and the most ops of an instance that becomes a group: below, calling it costs more than sharing
/// saves; above, one function of it would take too long to compile.
const SIZES: std::ops::RangeInclusive<usize> = 16..=4000;

/// The group of each node, [`FLAT`] or counted from 1: the outermost instances of modules that stand several
/// times. Parameters may differ: a seed or a power-on value need not show in the code, and whether code is equal
/// is found out later.
pub(super) fn groups(program: &Program) -> Vec<u32> {
    let sizes = sizes(program);
    let mut alike = HashMap::new();
    for owner in &program.owners {
        *alike.entry(&owner.module).or_insert(0) += 1;
    }
    let mut count = FLAT;
    let mut of_owner: Vec<u32> = Vec::with_capacity(program.owners.len());
    for (i, owner) in program.owners.iter().enumerate() {
        let enclosing = owner.parent.map_or(FLAT, |parent| of_owner[parent.index()]);
        let starts = enclosing == FLAT && alike[&owner.module] > 1 && SIZES.contains(&sizes[i]);
        count += u32::from(starts);
        of_owner.push(if starts { count } else { enclosing });
    }
    program.owner.iter().map(|owner| of_owner[owner.index()]).collect()
}

/// How many ops each instance has, those of instances inside it included.
fn sizes(program: &Program) -> Vec<usize> {
    let mut sizes = vec![0; program.owners.len()];
    for (node, owner) in program.graph.nodes.iter().zip(&program.owner) {
        sizes[owner.index()] += usize::from(!node.op.is_leaf());
    }
    for i in (0..sizes.len()).rev() {
        if let Some(parent) = program.owners[i].parent {
            sizes[parent.index()] += sizes[i];
        }
    }
    sizes
}
