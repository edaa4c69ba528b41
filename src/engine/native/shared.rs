//! A large program as many functions: one for each shape of its units, called for all units of that shape.

use std::collections::HashMap;

use super::group::{FLAT, groups};
use super::host::{Assembler, Code};
use super::memory::{Layout, Memory};
use super::plan::{Assignment, Item, Unit, operands};
use super::shape::{Shape, Whole};
use super::{register_nodes, unit};
use crate::base::{Diagnostic, Graph};
use crate::compile::Program;

/// How to compute a tick: every call once, in order.
#[derive(Debug)]
pub(super) struct Schedule {
    calls: Vec<Call>,
}

/// Units of one shape at one level.
#[derive(Debug)]
struct Call {
    function: usize,
    count: u64,
    records: Vec<u32>,
}

impl Schedule {
    /// Settles the tick whose state is in `now`, and computes the state to come.
    pub fn settle(&self, code: &Code, memory: &mut Memory) {
        for call in &self.calls {
            code.call(call.function, memory, &call.records, call.count);
        }
    }
}

/// Compiles a program; what `stored` says, and what passes between units, is in memory after a tick.
pub(super) fn compile(
    assembler: &mut Assembler,
    program: &Program,
    stored: Vec<bool>,
) -> Result<(Layout, Schedule), Diagnostic> {
    let graph = &program.graph;
    let homes = groups(program);
    let mut assignment = Assignment::new(graph, &homes);
    let mut units = assignment.units(graph);
    // Whatever is not shared after all had better be one with the rest; that may move levels, but little.
    let lonely = Plan::new(program, &homes, &units, &stored)?.lonely();
    if !lonely.is_empty() {
        lonely.iter().for_each(|&unit| assignment.dissolve(&units[unit]));
        units = assignment.units(graph);
    }
    let plan = Plan::new(program, &homes, &units, &stored)?;
    let calls = plan.compile(assembler)?;
    Ok((plan.layout, Schedule { calls }))
}

/// Units with their shapes, and the memory they work on.
struct Plan {
    layout: Layout,
    shapes: Vec<Shape>,
    /// For each unit its level, group, shape and record.
    units: Vec<(u32, u32, usize, Vec<u32>)>,
}

impl Plan {
    fn new(program: &Program, homes: &[u32], units: &[Unit], stored: &[bool]) -> Result<Self, Diagnostic> {
        let graph = &program.graph;
        let crossing = crossing(graph, units);
        let layout = Layout::new(program, homes, |id| stored[id.index()] || crossing[id.index()])?;
        let register_nodes = register_nodes(graph);
        let whole = Whole { graph, layout: &layout, homes, register_nodes: &register_nodes };
        let mut numbers = HashMap::new();
        let mut shaped = Vec::new();
        for unit in units {
            let (shape, record) = whole.shape(unit);
            let next = numbers.len();
            let number = *numbers.entry(shape).or_insert(next);
            shaped.push((unit.level, unit.group, number, record));
        }
        let mut shapes: Vec<_> = numbers.into_iter().collect();
        shapes.sort_unstable_by_key(|(_, number)| *number);
        Ok(Plan { layout, shapes: shapes.into_iter().map(|(shape, _)| shape).collect(), units: shaped })
    }

    /// Units of groups whose shape no other unit has.
    fn lonely(&self) -> Vec<usize> {
        let mut uses = vec![0; self.shapes.len()];
        self.units.iter().for_each(|(_, _, shape, _)| uses[*shape] += 1);
        let lonely = |(_, (_, group, shape, _)): &(usize, &(u32, u32, usize, _))| *group != FLAT && uses[*shape] == 1;
        self.units.iter().enumerate().filter(lonely).map(|(unit, _)| unit).collect()
    }

    fn compile(&self, assembler: &mut Assembler) -> Result<Vec<Call>, Diagnostic> {
        let mut order: Vec<_> = self.units.iter().collect();
        // Within a level the units of groups may go in any order; those of no group keep theirs.
        order.sort_by_key(|(level, group, shape, _)| (*level, *group != FLAT, if *group == FLAT { 0 } else { *shape }));
        let mut functions = vec![None; self.shapes.len()];
        let mut calls: Vec<Call> = Vec::new();
        let mut last = None;
        for (level, group, shape, record) in order {
            if functions[*shape].is_none() {
                functions[*shape] = Some(unit::compile(assembler, &self.shapes[*shape], record.len())?);
            }
            let key = (*level, *group == FLAT, *shape);
            match calls.last_mut() {
                Some(call) if last == Some(key) && *group != FLAT => {
                    call.records.extend(record);
                    call.count += 1;
                }
                _ => {
                    let function = functions[*shape].unwrap_or_default();
                    calls.push(Call { function, count: 1, records: record.clone() });
                }
            }
            last = Some(key);
        }
        Ok(calls)
    }
}

/// Values that a unit computes and another one reads.
fn crossing(graph: &Graph, units: &[Unit]) -> Vec<bool> {
    let mut unit_of = vec![usize::MAX; graph.nodes.len()];
    for (number, unit) in units.iter().enumerate() {
        for item in &unit.items {
            if let Item::Value(id) = item {
                unit_of[id.index()] = number;
            }
        }
    }
    let mut crossing = vec![false; graph.nodes.len()];
    for (number, unit) in units.iter().enumerate() {
        for &item in &unit.items {
            operands(graph, item, |id| crossing[id.index()] |= unit_of[id.index()] != number);
        }
    }
    for (crossing, node) in crossing.iter_mut().zip(&graph.nodes) {
        *crossing &= !node.op.is_leaf();
    }
    crossing
}
