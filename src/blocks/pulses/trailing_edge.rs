//! Trailing edge: a strobe for each pulse, in the tick in which its line has gone low again.
//!
//! ```text
//!   lines    __/-----\_____/--\_____
//!   strobes  ________|-|______|-|___
//! ```

use crate::blocks::{Block, Builder, Description, Kind, Parameter, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "trailing_edge",
    kind: Kind::Pulses,
    summary: "Gives a strobe at the trailing edge of each pulse, line by line.",
    doc: "strobes(t) = lines(t-1) and not lines(t). A pulse may last any number of ticks and gives one strobe, so that \
          what adds up strobes counts pulses.",
    source: "chosen: how analyzer 338 of US 3,809,868, FIG. 10, takes the pulses of lines 304, 306, 314, 316",
    parameters: &[Parameter { name: "WIDTH", default: 4, min: 1, max: 64, doc: "lines" }],
    ports: &[
        PortDescription::input("lines", Width::Param("WIDTH"), "pulses"),
        PortDescription::output("strobes", Width::Param("WIDTH"), "a tick for each"),
    ],
    clocked: true,
};

fn build(b: &mut Builder) {
    let strobes = b.falls(b.input("lines"));
    b.output("strobes", strobes);
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    #[test]
    fn each_pulse_gives_one_strobe_whatever_its_length() {
        let mut bench = Bench::new("trailing_edge", &[("WIDTH", 2)]);
        for (lines, strobes) in [(0b01, 0), (0b11, 0), (0b11, 0), (0b10, 0b01), (0b01, 0b10), (0, 0b01), (0, 0)] {
            bench.set("lines", lines);
            assert_eq!(bench.get("strobes"), strobes);
            bench.tick();
        }
    }
}
