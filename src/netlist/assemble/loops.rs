//! Combinational loops: a cell's output that depends on itself within one tick.

use std::collections::{HashMap, HashSet};
use std::sync::Arc;

use crate::base::Diagnostic;
use crate::blocks::{Body, Direction};
use crate::netlist::checked::{CellId, NetId, Netlist, Part, Source};
use crate::netlist::errors::Errors;

/// Loops told in one run.
const TOLD: usize = 10;
/// Hops of a loop that are printed.
const HOPS: usize = 40;

/// Notes the loops, each with every hop.
pub(super) fn find(netlist: &Netlist, errors: &mut Errors) {
    let mut walk = Walk::new(netlist);
    for cell in 0..netlist.cells.len() {
        for output in 0..netlist.cells[cell].body.outputs.len() {
            walk.from((CellId::new(cell), output as u32));
        }
    }
    for hops in &walk.loops {
        errors.push(describe(netlist, hops));
    }
}

/// An output of a cell.
type Output = (CellId, u32);

/// An output that is read, in the same tick, by another: through bits of a net and an input of its cell.
#[derive(Clone, Copy)]
struct Hop {
    from: Output,
    net: NetId,
    bit: u32,
    input: u32,
    to: Output,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum State {
    New,
    Open,
    Done,
}

/// An output whose hops are being followed.
struct Frame {
    output: Output,
    hops: Vec<Hop>,
    /// How many have been followed.
    done: usize,
}

/// A depth-first walk over the outputs of cells, against the flow.
struct Walk<'n> {
    netlist: &'n Netlist,
    /// Where the outputs of each cell begin in `state`.
    first: Vec<usize>,
    state: Vec<State>,
    /// For each body, which inputs each output reads in the same tick.
    edges: HashMap<*const Body, Arc<Vec<Vec<u32>>>>,
    loops: Vec<Vec<Hop>>,
    /// Cells that stand on a loop told already.
    told: HashSet<CellId>,
}

impl<'n> Walk<'n> {
    fn new(netlist: &'n Netlist) -> Self {
        let mut first = Vec::with_capacity(netlist.cells.len());
        let mut outputs = 0;
        for cell in &netlist.cells {
            first.push(outputs);
            outputs += cell.body.outputs.len();
        }
        let state = vec![State::New; outputs];
        Walk { netlist, first, state, edges: HashMap::new(), loops: Vec::new(), told: HashSet::new() }
    }

    /// Walks from one output; an explicit stack, because circuits are deeper than the machine's.
    fn from(&mut self, start: Output) {
        if *self.state(start) != State::New {
            return;
        }
        let mut stack = vec![self.open(start)];
        while let Some(frame) = stack.last_mut() {
            let Some(hop) = frame.hops.get(frame.done).copied() else {
                *self.state(frame.output) = State::Done;
                stack.pop();
                continue;
            };
            frame.done += 1;
            match *self.state(hop.from) {
                State::New => stack.push(self.open(hop.from)),
                State::Open => self.close(hop.from, &stack),
                State::Done => {}
            }
        }
    }

    fn state(&mut self, (cell, output): Output) -> &mut State {
        &mut self.state[self.first[cell.index()] + output as usize]
    }

    fn open(&mut self, output: Output) -> Frame {
        *self.state(output) = State::Open;
        Frame { output, hops: self.hops(output), done: 0 }
    }

    /// Whose outputs this one depends on within the tick.
    fn hops(&mut self, to: Output) -> Vec<Hop> {
        let netlist = self.netlist;
        let cell = &netlist.cells[to.0.index()];
        let mut hops = Vec::new();
        for &input in &self.edges(&cell.body)[to.1 as usize] {
            for part in &cell.inputs[input as usize] {
                let Part::Net { net, low, width } = *part else { continue };
                for root in &netlist.nets[net.index()].roots {
                    let bit = low.max(root.low);
                    if let (Source::Cell { cell, output, .. }, true) =
                        (root.source, bit < (low + width).min(root.low + root.width))
                    {
                        hops.push(Hop { from: (cell, output), net, bit, input, to });
                    }
                }
            }
        }
        hops
    }

    fn edges(&mut self, body: &Arc<Body>) -> Arc<Vec<Vec<u32>>> {
        let edges = self.edges.entry(Arc::as_ptr(body)).or_insert_with(|| {
            let inputs = |read: Vec<bool>| (0..).zip(read).filter(|(_, read)| *read).map(|(input, _)| input).collect();
            Arc::new(body.combinational_edges().into_iter().map(inputs).collect())
        });
        Arc::clone(edges)
    }

    /// Keeps the loop that ends where the walk has come back to `start`, unless part of it is told already.
    fn close(&mut self, start: Output, stack: &[Frame]) {
        if self.loops.len() >= TOLD {
            return;
        }
        let Some(from) = stack.iter().rposition(|frame| frame.output == start) else { return };
        // Along the flow, which the walk goes against.
        let hops: Vec<Hop> = stack[from..].iter().rev().map(|frame| frame.hops[frame.done - 1]).collect();
        if hops.iter().all(|hop| !self.told.contains(&hop.to.0)) {
            self.told.extend(hops.iter().map(|hop| hop.to.0));
            self.loops.push(hops);
        }
    }
}

fn describe(netlist: &Netlist, hops: &[Hop]) -> Diagnostic {
    let cells = if hops.len() == 1 { "one cell".to_owned() } else { format!("{} cells", hops.len()) };
    let mut diagnostic = Diagnostic::new("N024", format!("a combinational loop through {cells}"));
    for (hop, count) in hops.iter().zip(1..=HOPS) {
        let cell = &netlist.cells[hop.to.0.index()];
        let port = |direction, place: u32| cell.ports(direction).swap_remove(place as usize).name;
        let (input, output) = (port(Direction::Input, hop.input), port(Direction::Output, hop.to.1));
        let text = format!("hop {count}: from `{input}` to `{output}` of `{}`", cell.name);
        let way: Vec<_> = way(netlist, hop).into_iter().map(|net| format!("`{}`", netlist.net_name(net))).collect();
        diagnostic = diagnostic.at(cell.span, text).help(format!(
            "hop {count}: {} -> `{input}` of `{}` ({}) -> `{output}`, {}",
            way.join(" -> "),
            cell.name,
            cell.module(),
            netlist.sources.place(cell.span),
        ));
    }
    if hops.len() > HOPS {
        diagnostic = diagnostic.help(format!("and {} hops more, back to the first", hops.len() - HOPS));
    }
    diagnostic.help("a loop settles to nothing definite: break it with a block that holds state, such as a register")
}

/// The nets that a hop passes, along the flow.
fn way(netlist: &Netlist, hop: &Hop) -> Vec<NetId> {
    let (mut net, mut bit) = (hop.net, hop.bit);
    let mut way = vec![net];
    while way.len() < HOPS {
        let drives = &netlist.nets[net.index()].drives;
        let drive = drives.iter().find(|drive| (drive.low..drive.low + drive.width).contains(&bit));
        let Some((Source::Net { net: next, low }, first)) = drive.map(|drive| (drive.source, drive.low)) else { break };
        (net, bit) = (next, low + bit - first);
        way.push(net);
    }
    way.reverse();
    way
}
