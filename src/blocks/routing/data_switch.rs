//! Data switch: passes the one of five words whose line is high.

use crate::blocks::{Block, Builder, Description, Kind, Parameter, PortDescription, Width};

const WORD: Width = Width::Param("WIDTH");

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "data_switch",
    kind: Kind::Routing,
    summary: "Passes the one of five words whose line is high.",
    doc: "word = (lines[0] ? a : 0) | (lines[1] ? b : 0) | ... | (lines[4] ? e : 0), combinational. Words of several \
          wires travel side by side as one concatenation.",
    source: "US 3,809,868, FIG. 1 and 11: selection of one of five conversions (switch 362)",
    parameters: &[Parameter { name: "WIDTH", default: 64, min: 1, max: 64, doc: "bits of the words" }],
    ports: &[
        PortDescription::input("lines", Width::Fixed(5), "which word passes, a lowest"),
        PortDescription::input("a", WORD, "first word"),
        PortDescription::input("b", WORD, "second word"),
        PortDescription::input("c", WORD, "third word"),
        PortDescription::input("d", WORD, "fourth word"),
        PortDescription::input("e", WORD, "fifth word"),
        PortDescription::output("word", WORD, "the selected one, 0 for none"),
    ],
    clocked: false,
};

fn build(b: &mut Builder) {
    let lines = b.input("lines");
    let mut word = b.constant(0, b.count("WIDTH"));
    for (line, name) in (0..).zip(["a", "b", "c", "d", "e"]) {
        let open = b.pick(lines, line);
        let passed = b.gate(open, b.input(name));
        word = b.or(word, passed);
    }
    b.output("word", word);
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    #[test]
    fn the_word_of_the_line_that_is_high_passes() {
        let mut bench = Bench::new("data_switch", &[("WIDTH", 5)]);
        let words = [("a", 17), ("b", 9), ("c", 30), ("d", 1), ("e", 22)];
        bench.set_all(&words);
        for (line, (_, word)) in words.into_iter().enumerate() {
            bench.set("lines", 1 << line);
            assert_eq!(bench.get("word"), word as u64);
        }
        bench.set("lines", 0);
        assert_eq!(bench.get("word"), 0);
    }
}
