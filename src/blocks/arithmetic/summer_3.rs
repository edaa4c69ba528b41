//! Summer with three inputs, each with a polarity, and an output held from the strobe on.

use super::words::build_summer;
use crate::blocks::{Block, Builder, Description, Kind, Parameter, Parameters, PortDescription, Width};

/// The block.
pub struct Summer3;

static DESCRIPTION: Description = Description {
    name: "summer_3",
    kind: Kind::Arithmetic,
    summary: "Adds three words, each with its polarity, at a strobe.",
    doc: "sum(t+1) = strobe(t) ? +/- a(t) +/- b(t) +/- c(t) : sum(t), in two's complement. The bits of NEGATIVE name \
          the inverting inputs, a is bit 0. Words are aligned by wiring. `overflow` is held with the sum and is 1 when \
          it does not fit WIDTH bits.",
    source: "US 3,809,868, FIG. 5 to 7 (summers 114 and 210: E + F - 1)",
    parameters: &[
        Parameter { name: "A_WIDTH", default: 16, min: 1, max: 62, doc: "bits of a" },
        Parameter { name: "B_WIDTH", default: 16, min: 1, max: 62, doc: "bits of b" },
        Parameter { name: "C_WIDTH", default: 16, min: 1, max: 62, doc: "bits of c" },
        Parameter { name: "WIDTH", default: 18, min: 2, max: 64, doc: "bits of the sum" },
        Parameter { name: "NEGATIVE", default: 0, min: 0, max: 7, doc: "mask of the inverting inputs, a is bit 0" },
    ],
    ports: &[
        PortDescription::input("strobe", Width::BIT, "clocks the module"),
        PortDescription::input("a", Width::Param("A_WIDTH"), "first term").signed(),
        PortDescription::input("b", Width::Param("B_WIDTH"), "second term").signed(),
        PortDescription::input("c", Width::Param("C_WIDTH"), "third term").signed(),
        PortDescription::output("sum", Width::Param("WIDTH"), "the sum at the last strobe").signed(),
        PortDescription::output("overflow", Width::BIT, "that sum did not fit"),
    ],
    clocked: true,
};

impl Block for Summer3 {
    fn description(&self) -> &'static Description {
        &DESCRIPTION
    }

    fn check(&self, _: &Parameters) -> Result<(), String> {
        Ok(())
    }

    fn build(&self, b: &mut Builder) {
        build_summer(b, &["a", "b", "c"]);
    }
}

#[cfg(test)]
mod tests {
    use super::super::words::polar_sum;
    use crate::blocks::bench::Bench;

    #[test]
    fn each_input_counts_with_its_polarity() {
        for negative in 0..8 {
            let parameters = [("A_WIDTH", 8), ("B_WIDTH", 8), ("C_WIDTH", 8), ("WIDTH", 10), ("NEGATIVE", negative)];
            let mut bench = Bench::new("summer_3", &parameters);
            for terms in [[1, 2, 3], [-128, 127, -128], [127, -128, 127], [0, 0, 0]] {
                bench.set_all(&[("a", terms[0]), ("b", terms[1]), ("c", terms[2]), ("strobe", 1)]);
                bench.tick();
                let truth = polar_sum(&terms, negative);
                let fits = (-512..512).contains(&truth);
                assert_eq!(bench.get("overflow") == 1, !fits, "{terms:?}");
                assert!(!fits || i128::from(bench.get_signed("sum")) == truth, "{terms:?}");
            }
        }
    }
}
