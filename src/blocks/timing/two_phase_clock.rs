//! Two-phase clock with hold: a pulse in each of the two halves of a clock in turn, with a gap after each.
//!
//! ```text
//!   run           /-----------------------------------
//!   hold      __________________/---------\___________       HALF = 3
//!   phase_a   __/---\_______/---------------\_______/--
//!   phase_b   ________/---\___________________/---\____
//!   trailing      |     |     .             |     |
//!   end_of_clock          |                         |
//! ```

use crate::base::word::clog2;
use crate::blocks::{Block, Builder, Description, Kind, Parameter, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "two_phase_clock",
    kind: Kind::Timing,
    summary: "Gives a pulse in each half of a clock in turn, and never two that touch; a hold keeps a pulse on.",
    doc: "While `run` is 1 the first and the second half take turns, each HALF ticks long, beginning with the first. A \
          half begins with a pulse, on `phase_a` in the first and on `phase_b` in the second, and ends with one tick in \
          which both are low. So every pulse has edges of its own, and two pulses never touch. A tick with `hold` = 1 does \
          not count: a pulse that is on stays on until the hold is gone. While `inhibit` is 1 no half begins: the clock \
          waits before the next pulse, with both phases low; a pulse that is on is not cut. While `fast` is 1 a half takes \
          two ticks, whatever HALF is; one that is under way is cut short behind its pulse. `trailing` is 1 in the last tick of a \
          pulse, `end_of_clock` in the last tick of the second half. While `run` is 0 the clock stands at the start of the \
          first half and both phases are low.",
    source: "US 3,809,868, FIG. 10, clock 329 with HOLD; two halves from the half-cycle delay of multiplier 327; the \
             gap of one tick is chosen",
    parameters: &[Parameter { name: "HALF", default: 2, min: 2, max: 1024, doc: "ticks of each half" }],
    ports: &[
        PortDescription::input("run", Width::BIT, "enables the clock"),
        PortDescription::input("hold", Width::BIT, "freezes it in a pulse-on state"),
        PortDescription::input("inhibit", Width::BIT, "no pulse begins"),
        PortDescription::input("fast", Width::BIT, "the shortest halves"),
        PortDescription::output("phase_a", Width::BIT, "pulses of the first half, for the sine generator"),
        PortDescription::output("phase_b", Width::BIT, "pulses of the second half, for the cosine generator"),
        PortDescription::output("trailing", Width::BIT, "1 in the last tick of a pulse"),
        PortDescription::output("end_of_clock", Width::BIT, "1 in the last tick of the second half"),
    ],
    clocked: true,
};

fn build(b: &mut Builder) {
    let [run, hold, inhibit, fast] = ["run", "hold", "inhibit", "fast"].map(|input| b.input(input));
    let stopped = b.not(run);
    let half = u64::from(b.count("HALF"));
    let ticks = b.hold(clog2(half), 0);
    b.name("ticks", ticks.q);
    let [at_start, last_on, off] = [0, half - 2, half - 1].map(|tick| b.is(ticks.q, tick));
    let was_on = b.hold(1, 0);
    let was_off = b.not(was_on.q);
    let waits = b.all(&[inhibit, at_start, was_off]);
    let frozen = b.or(hold, waits);
    let free = b.not(frozen);
    let counts = b.and(run, free);
    let in_pulse = b.not(off);
    let cut = b.and(fast, in_pulse);
    let ends = b.or(last_on, cut);
    let [zero, one, gap] = [0, 1, half - 1].map(|tick| b.constant(tick, b.width(ticks.q)));
    let more = b.add(ticks.q, one);
    let later = b.mux(ends, gap, more);
    let next = b.mux(off, zero, later);
    b.load(ticks, next, counts, stopped);
    let trailing = b.and(counts, ends);
    b.output("trailing", trailing);

    let end_of_half = b.and(counts, off);
    let second = b.hold(1, 0);
    let first = b.not(second.q);
    b.load(second, first, end_of_half, stopped);
    let end_of_clock = b.and(second.q, end_of_half);
    b.output("end_of_clock", end_of_clock);

    let low = b.any(&[stopped, off, waits]);
    let on = b.not(low);
    b.load(was_on, on, None, None);
    for (phase, in_half) in [("phase_a", first), ("phase_b", second.q)] {
        let pulse = b.and(on, in_half);
        b.output(phase, pulse);
    }
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    /// Phases as a line of text, a letter a tick: a and b, in capitals when trailing; `-` when both are low, `|` when
    /// the clock is over.
    fn line(bench: &mut Bench, ticks: usize) -> String {
        let letter = |_| {
            let seen = ["phase_a", "phase_b", "trailing", "end_of_clock"].map(|port| bench.get(port));
            bench.tick();
            match seen {
                [1, 0, 0, 0] => 'a',
                [1, 0, 1, 0] => 'A',
                [0, 1, 0, 0] => 'b',
                [0, 1, 1, 0] => 'B',
                [0, 0, 0, 0] => '-',
                [0, 0, 0, 1] => '|',
                _ => panic!("phases, trailing, end: {seen:?}"),
            }
        };
        (0..ticks).map(letter).collect()
    }

    fn running(half: i64) -> Bench {
        let mut bench = Bench::new("two_phase_clock", &[("HALF", half)]);
        bench.set("run", 1);
        bench
    }

    #[test]
    fn each_half_has_a_pulse_and_one_low_tick_after_it() {
        for (half, expected) in [(2, "A-B|A-B|A-B|"), (3, "aA-bB|aA-bB|"), (6, "aaaaA-bbbbB|")] {
            assert_eq!(line(&mut running(half), 12), expected);
        }
    }

    #[test]
    fn a_hold_keeps_the_pulse_on_that_it_meets_and_a_gap_a_gap() {
        for (half, before, expected) in [(2, 0, "aaaA-B|"), (2, 1, "A----B|"), (3, 4, "aA-bbbbB|"), (3, 5, "aA-bB---|")]
        {
            let mut bench = running(half);
            let mut seen = line(&mut bench, before);
            bench.set("hold", 1);
            seen += &line(&mut bench, 3);
            bench.set("hold", 0);
            seen += &line(&mut bench, expected.len() - seen.len());
            assert_eq!(seen, expected);
        }
    }

    #[test]
    fn an_inhibited_clock_begins_no_pulse_and_cuts_none() {
        for (before, expected) in [(0, "---aA-bB|"), (1, "aA--bB|"), (2, "aA---bB|"), (5, "aA-bB|--aA-")] {
            let mut bench = running(3);
            let mut seen = line(&mut bench, before);
            bench.set("inhibit", 1);
            seen += &line(&mut bench, 3);
            bench.set("inhibit", 0);
            seen += &line(&mut bench, expected.len() - seen.len());
            assert_eq!(seen, expected);
        }
    }

    #[test]
    fn a_pulse_that_a_hold_keeps_on_is_not_cut_by_an_inhibit() {
        let mut bench = running(3);
        bench.set("hold", 1);
        assert_eq!(line(&mut bench, 2), "aa");
        bench.set("inhibit", 1);
        assert_eq!(line(&mut bench, 2), "aa");
        bench.set("hold", 0);
        assert_eq!(line(&mut bench, 6), "aA----");
    }

    #[test]
    fn fast_halves_are_two_ticks_and_a_pulse_under_way_is_cut_short_but_not_a_gap() {
        // Where `fast` rises, and what is seen with it from there on.
        for (before, expected) in [(0, "A-B|A-"), (1, "aA-B|A"), (3, "aaaA-B"), (4, "aaaA-B|"), (7, "aaaA-bbB|A")] {
            let mut bench = running(5);
            let mut seen = line(&mut bench, before);
            bench.set("fast", 1);
            seen += &line(&mut bench, expected.len() - seen.len());
            assert_eq!(seen, expected, "{before}");
        }
        let mut bench = running(5);
        bench.set("fast", 1);
        assert_eq!(line(&mut bench, 1), "A");
        bench.set("fast", 0);
        assert_eq!(line(&mut bench, 6), "-bbbB|");
    }

    #[test]
    fn stopped_it_stands_at_the_start_of_the_first_half() {
        let mut bench = running(3);
        assert_eq!(line(&mut bench, 4), "aA-b");
        bench.set("run", 0);
        assert_eq!(line(&mut bench, 2), "--");
        bench.set("run", 1);
        assert_eq!(line(&mut bench, 6), "aA-bB|");
    }
}
