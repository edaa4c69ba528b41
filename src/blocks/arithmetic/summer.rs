//! Summer with two inputs, each with a polarity, and an output held from the strobe on.
//!
//! ```text
//!   a --(+/-)--\
//!               >( sum )--[ register, strobe ]--> sum, overflow
//!   b --(+/-)--/
//! ```

use super::words::build_summer;
use crate::blocks::{Block, Builder, Description, Kind, Parameter, Parameters, PortDescription, Width};

/// The block.
pub struct Summer;

static DESCRIPTION: Description = Description {
    name: "summer",
    kind: Kind::Arithmetic,
    summary: "Adds two words, each with its polarity, at a strobe.",
    doc: "sum(t+1) = strobe(t) ? +/- a(t) +/- b(t) : sum(t), in two's complement. Bit 0 of NEGATIVE set: a enters at an \
          inverting input; bit 1: b. Words are aligned by wiring: an integer meets a word of n fraction bits as \
          {word, n'b0}. `overflow` is held with the sum and is 1 when it does not fit WIDTH bits. With the strobe \
          always 1 it sums at every tick. More inputs: `summer_3`, `summer_4`, or a chain.",
    source: "US 3,809,868, FIG. 3 and 5 to 8 (summers with inverting and noninverting inputs)",
    parameters: &[
        Parameter { name: "A_WIDTH", default: 16, min: 1, max: 62, doc: "bits of a" },
        Parameter { name: "B_WIDTH", default: 16, min: 1, max: 62, doc: "bits of b" },
        Parameter { name: "WIDTH", default: 17, min: 2, max: 64, doc: "bits of the sum" },
        Parameter { name: "NEGATIVE", default: 0, min: 0, max: 3, doc: "mask of the inverting inputs, a is bit 0" },
    ],
    ports: &[
        PortDescription::input("strobe", Width::BIT, "clocks the module"),
        PortDescription::input("a", Width::Param("A_WIDTH"), "first term").signed(),
        PortDescription::input("b", Width::Param("B_WIDTH"), "second term").signed(),
        PortDescription::output("sum", Width::Param("WIDTH"), "the sum at the last strobe").signed(),
        PortDescription::output("overflow", Width::BIT, "that sum did not fit"),
    ],
    clocked: true,
};

impl Block for Summer {
    fn description(&self) -> &'static Description {
        &DESCRIPTION
    }

    fn check(&self, _: &Parameters) -> Result<(), String> {
        Ok(())
    }

    fn build(&self, b: &mut Builder) {
        build_summer(b, &["a", "b"]);
    }
}

#[cfg(test)]
mod tests {
    use super::super::words::polar_sum;
    use crate::blocks::bench::Bench;

    #[test]
    fn each_input_counts_with_its_polarity() {
        for negative in 0..4 {
            let parameters = [("A_WIDTH", 8), ("B_WIDTH", 6), ("WIDTH", 10), ("NEGATIVE", negative)];
            let mut bench = Bench::new("summer", &parameters);
            for terms in [[1, 2], [-128, 31], [127, -32], [-128, -32], [0, 0]] {
                bench.set_all(&[("a", terms[0]), ("b", terms[1]), ("strobe", 1)]);
                bench.tick();
                assert_eq!(i128::from(bench.get_signed("sum")), polar_sum(&terms, negative));
                assert_eq!(bench.get("overflow"), 0);
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
