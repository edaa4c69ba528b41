//! Summers with two, three or four inputs, each with a polarity, and an output held from the strobe on.
//!
//! ```text
//!   a --(+/-)--\
//!   b --(+/-)---( sum )--[ register, strobe ]--> sum, overflow
//!   c --(+/-)--/
//! ```

use super::words::{clocked, narrow};
use crate::blocks::{Block, Builder, Description, Kind, Parameter, PortDescription, Width};

/// The summer of so many terms; Verilog's ports are fixed, so each number of inputs is a module of its own.
macro_rules! summer {
    ($name:literal, $summary:literal, $source:literal, width $width:literal, $($term:literal $bits:literal),+) => {
        Block::new(
            &Description {
                name: $name,
                kind: Kind::Arithmetic,
                summary: $summary,
                doc: "sum(t+1) = strobe(t) ? +/- a(t) +/- b(t) ... : sum(t), in two's complement. A bit of NEGATIVE set: \
                      that term enters at an inverting input; bit 0 is a, bit 1 b, and so on. Words are aligned by \
                      wiring: an integer meets a word of n fraction bits as {word, n'b0}. `overflow` is held with the \
                      sum and is 1 when it does not fit WIDTH bits. With the strobe always 1 it sums at every tick. \
                      `summer`, `summer_3` and `summer_4` have two, three and four terms; more are a chain.",
                source: $source,
                parameters: &[
                    $(Parameter { name: $bits, default: 16, min: 1, max: 62, doc: concat!("bits of ", $term) },)+
                    Parameter { name: "WIDTH", default: $width, min: 2, max: 64, doc: "bits of the sum" },
                    Parameter {
                        name: "NEGATIVE",
                        default: 0,
                        min: 0,
                        max: (1 << [$($term),+].len()) - 1,
                        doc: "mask of the inverting inputs, a is bit 0",
                    },
                ],
                ports: &[
                    PortDescription::input("strobe", Width::BIT, "clocks the module"),
                    $(PortDescription::input($term, Width::Param($bits), concat!("term ", $term)).signed(),)+
                    PortDescription::output("sum", Width::Param("WIDTH"), "the sum at the last strobe").signed(),
                    PortDescription::output("overflow", Width::BIT, "that sum did not fit"),
                ],
                clocked: true,
            },
            build,
        )
    };
}

/// Two terms.
pub static SUMMER: Block = summer!(
    "summer", "Adds two words, each with its polarity, at a strobe.",
    "US 3,809,868, FIG. 3 and 5 to 8 (summers with inverting and noninverting inputs)",
    width 17, "a" "A_WIDTH", "b" "B_WIDTH"
);

/// Three terms.
pub static SUMMER_3: Block = summer!(
    "summer_3", "Adds three words, each with its polarity, at a strobe.",
    "US 3,809,868, FIG. 5 to 7 (summers 114 and 210: E + F - 1)",
    width 18, "a" "A_WIDTH", "b" "B_WIDTH", "c" "C_WIDTH"
);

/// Four terms.
pub static SUMMER_4: Block = summer!(
    "summer_4", "Adds four words, each with its polarity, at a strobe.",
    "US 3,809,868, FIG. 4 (summers 88 and 90: two products, the coefficient inverted, the initial value)",
    width 18, "a" "A_WIDTH", "b" "B_WIDTH", "c" "C_WIDTH", "d" "D_WIDTH"
);

fn build(b: &mut Builder) {
    let negative = b.param("NEGATIVE");
    let words: Vec<_> = b.inputs().skip(1).collect();
    let widest = words.iter().map(|&word| b.width(word)).max().unwrap_or(1);
    // Up to four terms of `widest` bits: two more bits hold every sum.
    let mut sum = b.constant(0, widest + 2);
    for (i, &word) in words.iter().enumerate() {
        let term = b.sign_extend(word, widest + 2);
        sum = if negative >> i & 1 == 1 { b.sub(sum, term) } else { b.add(sum, term) };
    }
    let width = b.count("WIDTH");
    let result = narrow(b, sum, width);
    clocked(b, result, "sum");
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    /// The sum as it is known without the block.
    fn polar_sum(terms: &[i64], negative: i64) -> i64 {
        let polar = |(i, &term): (usize, &i64)| if negative >> i & 1 == 1 { -term } else { term };
        terms.iter().enumerate().map(polar).sum()
    }

    #[test]
    fn each_input_of_each_summer_counts_with_its_polarity() {
        let widths = [("A_WIDTH", 8), ("B_WIDTH", 6), ("C_WIDTH", 8), ("D_WIDTH", 7)];
        for (name, count) in [("summer", 2), ("summer_3", 3), ("summer_4", 4)] {
            for negative in 0..1 << count {
                let parameters = [&widths[..count], &[("WIDTH", 9), ("NEGATIVE", negative)]].concat();
                let mut bench = Bench::new(name, &parameters);
                bench.set("strobe", 1);
                for terms in [[1, 2, 3, 4], [-128, 31, -128, 63], [127, -32, 127, -64], [-128, -32, -128, -64], [0; 4]]
                {
                    for (term, value) in ["a", "b", "c", "d"].into_iter().zip(&terms[..count]) {
                        bench.set(term, *value);
                    }
                    bench.tick();
                    let truth = polar_sum(&terms[..count], negative);
                    let fits = (-256..256).contains(&truth);
                    assert_eq!(bench.get("overflow") == 1, !fits, "{name} {negative} {terms:?}");
                    assert!(!fits || bench.get_signed("sum") == truth, "{name} {negative} {terms:?}");
                }
            }
        }
    }

    #[test]
    fn the_sum_is_held_until_the_next_strobe() {
        let mut bench = Bench::new("summer", &[]);
        bench.set_all(&[("a", 5), ("b", 6), ("strobe", 1)]);
        assert_eq!(bench.get("sum"), 0, "nothing happens before the clocking point");
        bench.tick();
        bench.set_all(&[("a", 100), ("strobe", 0)]);
        bench.tick();
        assert_eq!(bench.get("sum"), 11);
    }

    #[test]
    fn overflow_tells_every_sum_that_does_not_fit() {
        let mut bench = Bench::new("summer", &[("A_WIDTH", 5), ("B_WIDTH", 5), ("WIDTH", 4), ("NEGATIVE", 2)]);
        bench.set("strobe", 1);
        for a in -16..16 {
            for b in -16..16 {
                bench.set_all(&[("a", a), ("b", b)]);
                bench.tick();
                assert_eq!(bench.get("overflow") == 1, !(-8..8).contains(&(a - b)), "{a} - {b}");
            }
        }
    }
}
