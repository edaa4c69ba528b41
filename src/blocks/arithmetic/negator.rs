//! Negator: the negative of a word.

use crate::blocks::{Block, Builder, Description, Kind, Parameter, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "negator",
    kind: Kind::Arithmetic,
    summary: "Gives the mathematical negative of a word.",
    doc: "negative = -word in two's complement, one bit wider, so that the least word has its negative, too. \
          Combinational.",
    source: "US 3,809,868, FIG. 13, logical negating circuits 442, 444, 446, 448",
    parameters: &[Parameter { name: "WIDTH", default: 16, min: 1, max: 63, doc: "bits of the word" }],
    ports: &[
        PortDescription::input("word", Width::Param("WIDTH"), "the word").signed(),
        PortDescription::output("negative", Width::Add(&Width::Param("WIDTH"), &Width::Fixed(1)), "its negative")
            .signed(),
    ],
    clocked: false,
};

fn build(b: &mut Builder) {
    let word = b.sign_extend(b.input("word"), b.count("WIDTH") + 1);
    let negative = b.negate(word);
    b.output("negative", negative);
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    #[test]
    fn every_word_has_its_negative() {
        let mut bench = Bench::new("negator", &[("WIDTH", 6)]);
        for word in -32..32 {
            bench.set("word", word);
            assert_eq!(bench.get_signed("negative"), -word);
        }
    }
}
