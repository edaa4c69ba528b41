//! Reversible counter: counts up and down by two pulse lines, with preset and optional guard stages.
//!
//! ```text
//!             +--------+--------+
//!   up   ---->| guard  | count  |----> count
//!   down ---->| GUARD  | WIDTH  |
//!   preset -->| = half | =value |
//!             +--------+--------+
//!                  | carry, borrow: the pulses that reach `count`
//! ```

use crate::base::ValueId;
use crate::blocks::{Block, Builder, Description, Held, Kind, Parameter, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "reversible_counter",
    kind: Kind::Memory,
    summary: "Counts up or down by pulses on two lines, with preset and guard stages.",
    doc: "In the manner of the SN74193: a pulse on `up` or `down` counts at its trailing edge, that is at the end of the \
          first low tick behind it; edges on both lines at once leave the count as it is. `preset` loads \
          `preset_value` and wins. With GUARD > 0, so many lower stages stand before the counter, preset to half: a pulse \
          is then 1/2^GUARD of a count, and `count` is the rounded sum. `carry` and `borrow` are the pulses that reach \
          `count` (those of the input lines when GUARD is 0); they go to the incremental device. `overflow` is 1 while a \
          pulse would carry the count beyond its word: it wraps, which is an error to report.",
    source: "US 3,809,868, FIG. 9, counters 318, 320; SN74193 data sheet; the guard stages are chosen",
    parameters: &[
        Parameter { name: "WIDTH", default: 16, min: 2, max: 32, doc: "bits of the count" },
        Parameter { name: "GUARD", default: 0, min: 0, max: 3, doc: "guard stages below the count" },
    ],
    ports: &[
        PortDescription::input("preset", Width::BIT, "loads the preset value and sets the guard stages to half"),
        PortDescription::input("preset_value", Width::Param("WIDTH"), "count to start from").signed(),
        PortDescription::input("up", Width::BIT, "count-up line"),
        PortDescription::input("down", Width::BIT, "count-down line"),
        PortDescription::output("count", Width::Param("WIDTH"), "present count").signed(),
        PortDescription::output("carry", Width::BIT, "pulses that count up"),
        PortDescription::output("borrow", Width::BIT, "pulses that count down"),
        PortDescription::output("overflow", Width::BIT, "1 while a pulse carries beyond the word"),
    ],
    clocked: true,
};

fn build(b: &mut Builder) {
    let (width, guard) = (b.count("WIDTH"), b.count("GUARD"));
    let (up, down) = (b.input("up"), b.input("down"));
    let stages = b.hold(width + guard, half(guard));
    let count = b.slice(stages.q, guard, width);
    b.output("count", count);
    let (carry, borrow) = reaching(b, stages, [up, down]);
    b.output("carry", carry);
    b.output("borrow", borrow);
    let overflow = overflow(b, count, [carry, borrow]);
    b.output("overflow", overflow);
    let edges = [b.falls(up), b.falls(down)];
    step(b, stages, edges);
}

/// The guard stages' preset: half a count.
fn half(guard: u32) -> u64 {
    (1 << guard) >> 1
}

fn step(b: &mut Builder, stages: Held, [up, down]: [ValueId; 2]) {
    let (total, guard) = (b.width(stages.q), b.count("GUARD"));
    let one = b.constant(1, total);
    let (more, less) = (b.add(stages.q, one), b.sub(stages.q, one));
    let counted = b.mux(up, more, less);
    let mut value = b.input("preset_value");
    if guard > 0 {
        let low = b.constant(half(guard), guard);
        value = b.concat(value, low);
    }
    let preset = b.input("preset");
    let next = b.mux(preset, value, counted);
    let one_line = b.xor(up, down);
    let enable = b.or(preset, one_line);
    b.load(stages, next, enable, None);
}

/// Which pulses reach the count through the guard stages.
fn reaching(b: &mut Builder, stages: Held, [up, down]: [ValueId; 2]) -> (ValueId, ValueId) {
    let guard = b.count("GUARD");
    if guard == 0 {
        return (up, down);
    }
    let low = b.slice(stages.q, 0, guard);
    b.name("guard", low);
    let (full, empty) = (b.reduce_and(low), b.is(low, 0));
    (b.and(up, full), b.and(down, empty))
}

fn overflow(b: &mut Builder, count: ValueId, [carry, borrow]: [ValueId; 2]) -> ValueId {
    let width = b.width(count);
    let (least, most) = (1 << (width - 1), (1 << (width - 1)) - 1);
    let (at_most, at_least) = (b.is(count, most), b.is(count, least));
    let (above, below) = (b.and(carry, at_most), b.and(borrow, at_least));
    b.or(above, below)
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    fn preset(guard: i64, value: i64) -> Bench {
        let mut bench = Bench::new("reversible_counter", &[("WIDTH", 8), ("GUARD", guard)]);
        bench.set_all(&[("preset", 1), ("preset_value", value)]);
        bench.tick();
        bench.set("preset", 0);
        bench
    }

    /// A pulse of two ticks on the lines given, and the gap after it.
    fn pulse(bench: &mut Bench, up: i64, down: i64) {
        for (up, down, ticks) in [(up, down, 2), (0, 0, 1)] {
            bench.set_all(&[("up", up), ("down", down)]);
            (0..ticks).for_each(|_| bench.tick());
        }
    }

    #[test]
    fn each_line_counts_its_way_and_both_together_cancel() {
        let mut bench = preset(0, -3);
        for (up, down, count) in [(1, 0, -2), (1, 0, -1), (0, 1, -2), (1, 1, -2), (0, 0, -2), (0, 1, -3)] {
            pulse(&mut bench, up, down);
            assert_eq!(bench.get_signed("count"), count);
        }
    }

    #[test]
    fn a_long_pulse_counts_once_at_the_end_of_the_tick_of_its_trailing_edge() {
        let mut bench = preset(0, 0);
        let mut seen = Vec::new();
        for up in [1, 1, 1, 0, 0, 1, 0] {
            bench.set("up", up);
            bench.tick();
            seen.push(bench.get_signed("count"));
        }
        assert_eq!(seen, [0, 0, 0, 1, 1, 1, 2]);
    }

    #[test]
    fn guard_stages_round_the_sum_of_fractions_and_send_a_pulse_for_each_step_of_the_count() {
        for guard in 0..=3 {
            let parts = f64::from(1 << guard);
            let mut bench = preset(guard, 5);
            let (mut fractions, mut sent) = (0, 5);
            for (i, way) in
                [1, 1, 1, -1, 1, 1, 1, 1, 1, -1, -1, -1, -1, -1, -1, -1, -1, -1].repeat(4).iter().enumerate()
            {
                bench.set_all(&[("up", i64::from(*way > 0)), ("down", i64::from(*way < 0))]);
                sent += bench.get("carry") as i64 - bench.get("borrow") as i64;
                bench.tick();
                bench.set_all(&[("up", 0), ("down", 0)]);
                assert_eq!((bench.get("carry"), bench.get("borrow")), (0, 0));
                bench.tick();
                fractions += way;
                let exact = 5.0 + f64::from(fractions) / parts;
                assert_eq!(bench.get_signed("count"), (exact + 0.5).floor() as i64, "GUARD {guard}, pulse {i}");
                assert_eq!(bench.get_signed("count"), sent);
            }
        }
    }

    #[test]
    fn a_pulse_beyond_either_end_of_the_word_is_reported_and_wraps() {
        for (start, up, after) in [(127, 1, -128), (-128, 0, 127)] {
            let mut bench = preset(0, start);
            bench.set_all(&[("up", up), ("down", 1 - up)]);
            assert_eq!(bench.get("overflow"), 1);
            pulse(&mut bench, up, 1 - up);
            assert_eq!((bench.get_signed("count"), bench.get("overflow")), (after, 0));
        }
    }
}
