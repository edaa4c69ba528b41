//! Multiplexer: two channels, each opened by its own control.
//!
//! ```text
//!   x1 --[ & ]--+           a b | z
//!   a  --[   ]  |           0 0 | 0
//!               OR--> z     1 0 | x1
//!   x2 --[ & ]--+           0 1 | x2
//!   b  --[   ]              1 1 | x1 | x2
//! ```

use crate::blocks::{Block, Builder, Description, Kind, Parameter, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "multiplexer",
    kind: Kind::Routing,
    summary: "Passes one of two words, or none.",
    doc: "z = (a ? x1 : 0) | (b ? x2 : 0), combinational. Table 2 of the patent has the first three rows; with both \
          controls high the gates of FIG. 6 give the or of the words.",
    source: "SU 1522157, multiplexer 21 of FIG. 1, FIG. 6 and table 2",
    parameters: &[Parameter { name: "WIDTH", default: 16, min: 1, max: 64, doc: "bits of the words" }],
    ports: &[
        PortDescription::input("a", Width::BIT, "opens channel 1"),
        PortDescription::input("b", Width::BIT, "opens channel 2"),
        PortDescription::input("x1", Width::Param("WIDTH"), "word of channel 1"),
        PortDescription::input("x2", Width::Param("WIDTH"), "word of channel 2"),
        PortDescription::output("z", Width::Param("WIDTH"), "the word passed, 0 when both channels are closed"),
    ],
    clocked: false,
};

fn build(b: &mut Builder) {
    let channel = |b: &mut Builder, open, word| b.gate(b.input(open), b.input(word));
    let (first, second) = (channel(b, "a", "x1"), channel(b, "b", "x2"));
    let z = b.or(first, second);
    b.output("z", z);
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    #[test]
    fn the_rows_of_table_2_hold_for_every_word() {
        let mut bench = Bench::new("multiplexer", &[("WIDTH", 3)]);
        for (x1, x2) in (0..8).flat_map(|x1| (0..8).map(move |x2| (x1, x2))) {
            for (a, b, z) in [(0, 0, 0), (1, 0, x1), (0, 1, x2), (1, 1, x1 | x2)] {
                bench.set_all(&[("a", a), ("b", b), ("x1", x1), ("x2", x2)]);
                assert_eq!(bench.get("z"), z as u64);
            }
        }
    }
}
