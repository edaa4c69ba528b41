//! Or network: four words of one letter become one, held from the strobe on.

use crate::blocks::{Block, Builder, Description, Kind, Parameter, PortDescription, Width};

const WORD: Width = Width::Param("WIDTH");

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "or_network",
    kind: Kind::Routing,
    summary: "Ors four words, of which at most one is not 0, at a strobe.",
    doc: "word(t+1) = strobe(t) ? a(t) | b(t) | c(t) | d(t) : word(t), bit by bit; 0 at power-on.",
    source: "US 3,809,868, FIG. 20, network 638: signals of the same letter designation are applied to an OR gate; that \
             it holds its output is chosen, as for every clocked module",
    parameters: &[Parameter { name: "WIDTH", default: 16, min: 1, max: 64, doc: "bits of the words" }],
    ports: &[
        PortDescription::input("strobe", Width::BIT, "clocks the module"),
        PortDescription::input("a", WORD, "first word"),
        PortDescription::input("b", WORD, "second word"),
        PortDescription::input("c", WORD, "third word"),
        PortDescription::input("d", WORD, "fourth word"),
        PortDescription::output("word", WORD, "their or at the last strobe"),
    ],
    clocked: true,
};

fn build(b: &mut Builder) {
    let held = b.hold(b.count("WIDTH"), 0);
    let mut joined = b.input("a");
    for name in ["b", "c", "d"] {
        joined = b.or(joined, b.input(name));
    }
    let word = b.load(held, joined, b.input("strobe"), None);
    b.output("word", word);
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    #[test]
    fn a_bit_of_any_word_is_in_the_result_from_the_strobe_on() {
        let mut bench = Bench::new("or_network", &[("WIDTH", 2)]);
        let mut before = 0;
        for words in 0..256_i64 {
            let [a, b, c, d] = [0, 2, 4, 6].map(|shift| words >> shift & 3);
            bench.set_all(&[("a", a), ("b", b), ("c", c), ("d", d), ("strobe", 1)]);
            assert_eq!(bench.get("word"), before, "nothing happens before the clocking point");
            bench.tick();
            before = (a | b | c | d) as u64;
            assert_eq!(bench.get("word"), before);
            bench.set("strobe", 0);
            bench.set("a", !a & 3);
            bench.tick();
            assert_eq!(bench.get("word"), before, "held between strobes");
        }
    }
}
