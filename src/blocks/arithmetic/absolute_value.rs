//! Absolute value: a signed word as its magnitude and its sign.
//!
//! ```text
//!   word --->[ |word| ]---> magnitude, is_negative, too_large
//! ```

use crate::blocks::{Block, Builder, Description, Kind, Parameter, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "absolute_value",
    kind: Kind::Arithmetic,
    summary: "Splits a signed word into its magnitude and its sign.",
    doc: "magnitude = |word|, is_negative = word < 0, combinational. The most negative word, -2^WIDTH, has no magnitude of \
          WIDTH bits: `too_large` is 1, and the magnitude reads 0.",
    source: "SU 1522157: inputs 32 and 34 of FIG. 1 want absolute projections",
    parameters: &[Parameter { name: "WIDTH", default: 12, min: 1, max: 63, doc: "bits of the magnitude" }],
    ports: &[
        PortDescription::input("word", Width::Add(&Width::Param("WIDTH"), &Width::BIT), "the word").signed(),
        PortDescription::output("magnitude", Width::Param("WIDTH"), "its absolute value"),
        PortDescription::output("is_negative", Width::BIT, "its sign"),
        PortDescription::output("too_large", Width::BIT, "the word is -2^WIDTH"),
    ],
    clocked: false,
};

fn build(b: &mut Builder) {
    let (word, width) = (b.input("word"), b.count("WIDTH"));
    let is_negative = b.sign(word);
    let opposite = b.negate(word);
    let magnitude = b.mux(is_negative, opposite, word);
    let too_large = b.sign(magnitude);
    let magnitude = b.slice(magnitude, 0, width);
    b.output("magnitude", magnitude);
    b.output("is_negative", is_negative);
    b.output("too_large", too_large);
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    #[test]
    fn every_word_has_its_magnitude_and_the_most_negative_has_none() {
        let mut bench = Bench::new("absolute_value", &[("WIDTH", 4)]);
        for word in -16_i64..16 {
            bench.set("word", word);
            let (magnitude, too_large) = if word == -16 { (0, 1) } else { (word.unsigned_abs(), 0) };
            let seen = (bench.get("magnitude"), bench.get("is_negative"), bench.get("too_large"));
            assert_eq!(seen, (magnitude, u64::from(word < 0), too_large), "{word}");
        }
    }
}
