//! Trajectory counter: how many pulses of four lines have been sent, that is the way travelled.

use crate::blocks::{Block, Builder, Description, Kind, Parameter, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "trajectory_counter",
    kind: Kind::Memory,
    summary: "Counts the pulses of several lines together and stays at its last state.",
    doc: "At the end of a tick the count grows by the number of lines that have risen in it, so each pulse counts once, \
          at its leading edge, however long it is held; pulses on several lines at once count each. It depends on the way \
          travelled, not on time. When the sum no longer fits, the count stays at all ones \
          (chosen: a wrap would take the words for the start of the stroke again).",
    source: "US 3,809,868, FIG. 10, counter 346",
    parameters: &[
        Parameter { name: "WIDTH", default: 12, min: 4, max: 32, doc: "bits of the count" },
        Parameter { name: "LINES", default: 4, min: 1, max: 8, doc: "pulse lines" },
    ],
    ports: &[
        PortDescription::input("clear", Width::BIT, "sets the count to 0; wins over counting"),
        PortDescription::input("lines", Width::Param("LINES"), "pulse lines"),
        PortDescription::output("count", Width::Param("WIDTH"), "pulses so far"),
    ],
    clocked: true,
};

fn build(b: &mut Builder) {
    let (width, lines) = (b.count("WIDTH"), b.input("lines"));
    let count = b.hold(width, 0);
    let mut sum = b.zero_extend(count.q, width + 1);
    for line in 0..b.count("LINES") {
        let line = b.pick(lines, line);
        let pulse = b.rises(line);
        let pulse = b.zero_extend(pulse, width + 1);
        sum = b.add(sum, pulse);
    }
    let beyond = b.sign(sum);
    let sum = b.slice(sum, 0, width);
    let full = b.constant(u64::MAX, width);
    let next = b.mux(beyond, full, sum);
    b.load(count, next, None, b.input("clear"));
    b.output("count", count.q);
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    #[test]
    fn every_pulse_on_any_line_counts_until_the_counter_is_full() {
        let mut bench = Bench::new("trajectory_counter", &[("WIDTH", 4)]);
        for (lines, count) in [(0b0001, 1), (0b1010, 3), (0, 3), (0b1111, 7), (0b1111, 11), (0b1111, 15), (0b0101, 15)]
        {
            for (lines, ticks) in [(lines, 3), (0, 1)] {
                bench.set("lines", lines);
                (0..ticks).for_each(|_| bench.tick());
                assert_eq!(bench.get("count"), count);
            }
        }
        bench.set("clear", 1);
        bench.tick();
        assert_eq!(bench.get("count"), 0);
    }

    #[test]
    fn a_pulse_counts_at_its_leading_edge() {
        let mut bench = Bench::new("trajectory_counter", &[]);
        let mut seen = Vec::new();
        for lines in [0b0001, 0b0001, 0b0101, 0b0100, 0, 0b0001] {
            bench.set("lines", lines);
            bench.tick();
            seen.push(bench.get("count"));
        }
        assert_eq!(seen, [1, 1, 2, 2, 2, 3]);
    }
}
