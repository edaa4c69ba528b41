//! Rank sequencer: clocks the modules of a figure from left to right, each rank when the one before is ready.
//!
//! ```text
//!   start  __|~|______________________________
//!   load   __|~|______________________________    the sources take the inputs
//!   rank0  ____|~|____________________________
//!   rank1  ______|~|__________________________    starts a digit-by-digit unit ...
//!   ready  ~~~~~~~~|_______|~~~~~~~~~~~~~~~~~~    ... which takes its time
//!   rank2  ________________|~|________________
//!   done   __________________|~~~~~~~~~~~~~~~~    until the next start
//! ```

use crate::base::ValueId;
use crate::blocks::{Block, Builder, Description, Held, Kind, Parameter, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "rank_sequencer",
    kind: Kind::Timing,
    summary: "Clocks ranks of modules one after another, and waits for units that take several ticks.",
    doc: "When `start` goes from 0 to 1 while nothing is under way, `load` is 1 in that same tick, and from the next on \
          a token visits the ranks: rank[i] is 1 for one tick, the first in which the token is there and `ready` is 1. \
          A unit clocked by rank[i] that takes long holds `ready` at 0 from the next tick on. `done` rises one tick \
          after the last rank and stays until the next load. A start while `busy` is ignored.",
    source: "US 3,809,868, description of FIG. 3: the modules are clocked in sequence from left to right such that each \
             has available all necessary inputs at the clocking point",
    parameters: &[Parameter { name: "RANKS", default: 6, min: 1, max: 64, doc: "number of ranks" }],
    ports: &[
        PortDescription::input("start", Width::BIT, "begins on its rising edge"),
        PortDescription::input("ready", Width::BIT, "no unit is at work"),
        PortDescription::output("load", Width::BIT, "clocks the sources"),
        PortDescription::output("rank", Width::Param("RANKS"), "clocks rank i"),
        PortDescription::output("busy", Width::BIT, "ranks are still to be clocked"),
        PortDescription::output("done", Width::BIT, "all ranks have been clocked since the last load"),
    ],
    clocked: true,
};

fn build(b: &mut Builder) {
    let (start, ready) = (b.input("start"), b.input("ready"));
    let before = b.delay(start);
    let token = b.hold(b.count("RANKS"), 0);
    let busy = b.reduce_or(token.q);
    let (low, idle) = (b.not(before), b.not(busy));
    let load = b.all(&[start, low, idle]);
    let rank = b.gate(ready, token.q);
    advance(b, token, ready, load);

    let last = b.sign(rank);
    let done = b.hold(1, 0);
    let settled = b.any(&[last, load]);
    let done = b.load(done, last, settled, None);
    for (name, value) in [("load", load), ("rank", rank), ("busy", busy), ("done", done)] {
        b.output(name, value);
    }
}

/// The token: into rank 0 at a load, one rank on whenever all is ready, out behind the last.
fn advance(b: &mut Builder, token: Held, ready: ValueId, load: ValueId) {
    let ranks = b.width(token.q);
    let one = b.constant(1, 1);
    let on = b.shift_left(token.q, one);
    let first = b.constant(1, ranks);
    let next = b.mux(load, first, on);
    let moves = b.or(load, ready);
    b.load(token, next, moves, None);
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    /// Runs so many ticks with `ready` as given; returns (load, rank, busy, done) of each tick.
    fn watch(bench: &mut Bench, start: &[i64], ready: &[i64]) -> Vec<(u64, u64, u64, u64)> {
        let ticks = start.iter().zip(ready);
        ticks
            .map(|(&start, &ready)| {
                bench.set_all(&[("start", start), ("ready", ready)]);
                let seen = (bench.get("load"), bench.get("rank"), bench.get("busy"), bench.get("done"));
                bench.tick();
                seen
            })
            .collect()
    }

    #[test]
    fn ranks_follow_one_another_tick_by_tick() {
        let mut bench = Bench::new("rank_sequencer", &[("RANKS", 3)]);
        let seen = watch(&mut bench, &[1, 0, 0, 0, 0, 0], &[1; 6]);
        let expected = [(1, 0, 0, 0), (0, 1, 1, 0), (0, 2, 1, 0), (0, 4, 1, 0), (0, 0, 0, 1), (0, 0, 0, 1)];
        assert_eq!(seen, expected);
    }

    #[test]
    fn a_rank_waits_until_all_is_ready() {
        let mut bench = Bench::new("rank_sequencer", &[("RANKS", 2)]);
        let seen = watch(&mut bench, &[1, 0, 0, 0, 0, 0], &[1, 1, 0, 0, 1, 1]);
        let ranks: Vec<u64> = seen.iter().map(|tick| tick.1).collect();
        assert_eq!(ranks, [0, 1, 0, 0, 2, 0]);
    }

    #[test]
    fn a_start_counts_on_its_rising_edge_and_not_while_busy() {
        let mut bench = Bench::new("rank_sequencer", &[("RANKS", 3)]);
        let held = watch(&mut bench, &[1; 8], &[1; 8]);
        assert_eq!(held.iter().filter(|tick| tick.0 == 1).count(), 1, "one load for one edge");
        assert_eq!(held[7].3, 1, "done stays");
        let again = watch(&mut bench, &[0, 1, 0, 1, 0, 0, 0], &[1; 7]);
        let loads: Vec<u64> = again.iter().map(|tick| tick.0).collect();
        assert_eq!(loads, [0, 1, 0, 0, 0, 0, 0], "the second edge falls into the busy time");
        assert_eq!(again.iter().map(|tick| tick.3).collect::<Vec<_>>(), [1, 1, 0, 0, 0, 1, 1]);
    }
}
