//! Order: the greater and the lesser of two words.
//!
//! ```text
//!   a --->[ >= ]---> greater, lesser
//!   b --->[    ]---> a_is_greater
//! ```

use crate::blocks::{Block, Builder, Description, Kind, Parameter, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "order",
    kind: Kind::Logic,
    summary: "Puts two words in order of size.",
    doc: "a_is_greater = a >= b; greater = a_is_greater ? a : b; lesser is the other one. Unsigned, combinational.",
    source: "SU 1522157: inputs 32, 34 and 35 of FIG. 1 want the projections so; bench of this project",
    parameters: &[Parameter { name: "WIDTH", default: 12, min: 1, max: 64, doc: "bits of a word" }],
    ports: &[
        PortDescription::input("a", Width::Param("WIDTH"), "one word"),
        PortDescription::input("b", Width::Param("WIDTH"), "the other"),
        PortDescription::output("greater", Width::Param("WIDTH"), "the greater of both"),
        PortDescription::output("lesser", Width::Param("WIDTH"), "the lesser of both"),
        PortDescription::output("a_is_greater", Width::BIT, "a >= b"),
    ],
    clocked: false,
};

fn build(b: &mut Builder) {
    let (first, second) = (b.input("a"), b.input("b"));
    let less = b.less(first, second);
    let greater = b.mux(less, second, first);
    let lesser = b.mux(less, first, second);
    let a_is_greater = b.not(less);
    b.output("greater", greater);
    b.output("lesser", lesser);
    b.output("a_is_greater", a_is_greater);
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    #[test]
    fn every_pair_of_small_words_comes_out_in_order() {
        let mut bench = Bench::new("order", &[("WIDTH", 3)]);
        for (a, b) in (0..64_u64).map(|i| (i / 8, i % 8)) {
            bench.set_all(&[("a", a as i64), ("b", b as i64)]);
            let got = (bench.get("greater"), bench.get("lesser"), bench.get("a_is_greater"));
            assert_eq!(got, (a.max(b), a.min(b), u64::from(a >= b)));
        }
    }
}
