//! Two-phase clock with hold: the two halves of a clock in turn, each of so many ticks, frozen while held.
//!
//! ```text
//!   run       __/--------------------------- ...
//!   hold      _________/-----\______________       HALF = 2
//!   phase_a     |A A|         . |A A|
//!   phase_b         |B B B B B B|   |B B|
//!   trailing    . 1 . . . . . 1 . 1 . 1
//! ```

use crate::base::ValueId;
use crate::base::word::clog2;
use crate::blocks::{Block, Builder, Description, Kind, Parameter, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "two_phase_clock",
    kind: Kind::Timing,
    summary: "Gives the two halves of a clock in turn; a hold freezes it in the half it is in.",
    doc: "While `run` is 1 the first half (`phase_a`) and the second half (`phase_b`) take turns, each HALF ticks long, \
          beginning with the first. A tick with `hold` = 1 does not count, so the half, and with it a pulse, stays on \
          until the hold is gone. `trailing` is 1 in the last tick of each half: that is when counters count. While `run` \
          is 0 the clock stands at the start of the first half and both phases are 0.",
    source: "US 3,809,868, FIG. 10, clock 329 with HOLD; two halves from the half-cycle delay of multiplier 327",
    parameters: &[Parameter { name: "HALF", default: 1, min: 1, max: 1024, doc: "ticks of each half" }],
    ports: &[
        PortDescription::input("run", Width::BIT, "enables the clock"),
        PortDescription::input("hold", Width::BIT, "freezes it in a pulse-on state"),
        PortDescription::output("phase_a", Width::BIT, "first half: pulses of the sine generator"),
        PortDescription::output("phase_b", Width::BIT, "second half: pulses of the cosine generator"),
        PortDescription::output("trailing", Width::BIT, "1 in the last tick of a half"),
    ],
    clocked: true,
};

fn build(b: &mut Builder) {
    let (run, hold) = (b.input("run"), b.input("hold"));
    let stopped = b.not(run);
    let free = b.not(hold);
    let counts = b.and(run, free);
    let trailing = last_tick(b, counts, stopped);
    b.output("trailing", trailing);

    let second = b.hold(1, 0);
    let first = b.not(second.q);
    b.load(second, first, trailing, stopped);
    let phase_a = b.and(run, first);
    b.output("phase_a", phase_a);
    let phase_b = b.and(run, second.q);
    b.output("phase_b", phase_b);
}

/// Counts the ticks of a half; 1 in the last of them.
fn last_tick(b: &mut Builder, counts: ValueId, stopped: ValueId) -> ValueId {
    let half = b.count("HALF");
    if half == 1 {
        return counts;
    }
    let width = clog2(half.into());
    let ticks = b.hold(width, 0);
    b.name("ticks", ticks.q);
    let at_end = b.is(ticks.q, u64::from(half) - 1);
    let (zero, one) = (b.constant(0, width), b.constant(1, width));
    let more = b.add(ticks.q, one);
    let next = b.mux(at_end, zero, more);
    b.load(ticks, next, counts, stopped);
    b.and(counts, at_end)
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    /// Phases as a line of text, a letter a tick, in capitals when trailing.
    fn line(bench: &mut Bench, ticks: usize, hold: impl Fn(usize) -> bool) -> String {
        let letter = |tick| {
            bench.set("hold", hold(tick).into());
            let letter = match (bench.get("phase_a"), bench.get("phase_b")) {
                (1, 0) => 'a',
                (0, 1) => 'b',
                (0, 0) => '-',
                phases => panic!("both phases: {phases:?}"),
            };
            let trailing = bench.get("trailing") == 1;
            bench.tick();
            if trailing { letter.to_ascii_uppercase() } else { letter }
        };
        (0..ticks).map(letter).collect()
    }

    #[test]
    fn the_halves_take_turns_and_end_with_a_trailing_edge() {
        for (half, expected) in [(1, "ABABABABABAB"), (2, "aAbBaAbBaAbB"), (3, "aaAbbBaaAbbB")] {
            let mut bench = Bench::new("two_phase_clock", &[("HALF", half)]);
            bench.set("run", 1);
            assert_eq!(line(&mut bench, 12, |_| false), expected);
        }
    }

    #[test]
    fn a_hold_stretches_the_half_it_falls_in() {
        let mut bench = Bench::new("two_phase_clock", &[("HALF", 2)]);
        bench.set("run", 1);
        assert_eq!(line(&mut bench, 14, |tick| (3..6).contains(&tick)), "aAbbbbBaAbBaAb");
    }

    #[test]
    fn stopped_it_stands_at_the_start_of_the_first_half() {
        let mut bench = Bench::new("two_phase_clock", &[("HALF", 2)]);
        bench.set("run", 1);
        assert_eq!(line(&mut bench, 3, |_| false), "aAb");
        bench.set("run", 0);
        assert_eq!(line(&mut bench, 2, |_| false), "--");
        bench.set("run", 1);
        assert_eq!(line(&mut bench, 4, |_| false), "aAbB");
    }
}
