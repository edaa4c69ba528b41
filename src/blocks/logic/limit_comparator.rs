//! Limit comparator: whether a word is beyond its limit.
//!
//! ```text
//!   reference  --->[ < or > ]---> beyond
//!   comparison --->[        ]
//! ```

use crate::blocks::{Block, Builder, Description, Kind, Parameter, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "limit_comparator",
    kind: Kind::Logic,
    summary: "Tells whether a word is beyond a minimum or a maximum.",
    doc: "MAXIMUM 0: beyond = comparison < reference; MAXIMUM 1: beyond = comparison > reference. Two's complement, \
          combinational. A word equal to the limit is not beyond it.",
    source: "US 3,809,868, FIG. 16, comparators 492 to 498; that equality is inside is chosen",
    parameters: &[
        Parameter { name: "WIDTH", default: 16, min: 1, max: 64, doc: "bits of the words" },
        Parameter { name: "MAXIMUM", default: 0, min: 0, max: 1, doc: "0: the reference is a minimum; 1: a maximum" },
    ],
    ports: &[
        PortDescription::input("reference", Width::Param("WIDTH"), "the limit").signed(),
        PortDescription::input("comparison", Width::Param("WIDTH"), "the word to judge").signed(),
        PortDescription::output("beyond", Width::BIT, "the word is outside"),
    ],
    clocked: false,
};

fn build(b: &mut Builder) {
    let (reference, comparison) = (b.input("reference"), b.input("comparison"));
    let [low, high] = if b.param("MAXIMUM") == 1 { [reference, comparison] } else { [comparison, reference] };
    let beyond = b.less_signed(low, high);
    b.output("beyond", beyond);
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    #[test]
    fn every_pair_of_words_is_judged_and_the_limit_itself_is_inside() {
        for maximum in [0, 1] {
            let mut bench = Bench::new("limit_comparator", &[("WIDTH", 4), ("MAXIMUM", maximum)]);
            for reference in -8..8 {
                for comparison in -8..8 {
                    bench.set_all(&[("reference", reference), ("comparison", comparison)]);
                    let beyond = if maximum == 1 { comparison > reference } else { comparison < reference };
                    assert_eq!(bench.get("beyond"), u64::from(beyond), "{comparison} against {reference}");
                }
            }
        }
    }
}
