//! Word gate: passes a word, or 0.

use crate::blocks::{Block, Builder, Description, Kind, Parameter, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "word_gate",
    kind: Kind::Routing,
    summary: "Passes a word while it is open, otherwise 0.",
    doc: "passed = open ? word : 0, combinational: an and gate for each bit.",
    source: "US 3,809,868, FIG. 20, gates 620, 622, 624",
    parameters: &[Parameter { name: "WIDTH", default: 16, min: 1, max: 64, doc: "bits of the word" }],
    ports: &[
        PortDescription::input("open", Width::BIT, "passes the word"),
        PortDescription::input("word", Width::Param("WIDTH"), "the word"),
        PortDescription::output("passed", Width::Param("WIDTH"), "the word or 0"),
    ],
    clocked: false,
};

fn build(b: &mut Builder) {
    let passed = b.gate(b.input("open"), b.input("word"));
    b.output("passed", passed);
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    #[test]
    fn a_word_passes_only_while_the_gate_is_open() {
        let mut bench = Bench::new("word_gate", &[("WIDTH", 5)]);
        for word in 0..32 {
            for (open, passed) in [(0, 0), (1, word)] {
                bench.set_all(&[("open", open), ("word", word)]);
                assert_eq!(bench.get("passed"), passed as u64);
            }
        }
    }
}
