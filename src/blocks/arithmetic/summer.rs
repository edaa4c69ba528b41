//! Summer: the sum of any number of two's-complement words, each with a polarity.
//!
//! ```text
//!   terms[0] --(+/-)--\
//!   terms[1] --(+/-)--->( sum )---> sum
//!   terms[2] --(+/-)--/
//! ```

use crate::blocks::{Block, Builder, Description, Kind, Parameter, Parameters, PortDescription, Width};

/// The block.
pub struct Summer;

static DESCRIPTION: Description = Description {
    name: "summer",
    kind: Kind::Arithmetic,
    summary: "Adds any number of words, each with its polarity.",
    doc: "sum = +/- terms[0] +/- terms[1] ..., combinational, in two's complement modulo 2^OUT_WIDTH. \
          `terms` is the concatenation of the input words, term 0 lowest; bit i of NEGATIVE set means that term i is \
          subtracted.",
    source: "US 3,809,868, FIG. 3 and 5 to 8 (summers with inverting and noninverting inputs)",
    parameters: &[
        Parameter { name: "WIDTH", default: 16, min: 1, max: 32, doc: "bits of each term" },
        Parameter { name: "TERMS", default: 2, min: 1, max: 4, doc: "number of terms" },
        Parameter { name: "OUT_WIDTH", default: 18, min: 1, max: 64, doc: "bits of the sum" },
        Parameter { name: "NEGATIVE", default: 0, min: 0, max: 15, doc: "bit i: term i is subtracted" },
    ],
    ports: &[
        PortDescription::input(
            "terms",
            Width::Mul(&Width::Param("TERMS"), &Width::Param("WIDTH")),
            "the terms, term 0 lowest",
        ),
        PortDescription::output("sum", Width::Param("OUT_WIDTH"), "their sum").signed(),
    ],
    clocked: false,
};

impl Block for Summer {
    fn description(&self) -> &'static Description {
        &DESCRIPTION
    }

    fn check(&self, parameters: &Parameters) -> Result<(), String> {
        let bits = parameters.get("TERMS") * parameters.get("WIDTH");
        if bits > 64 {
            return Err(format!(
                "TERMS * WIDTH is {bits}; at most 64 bits fit: use narrower words or a chain of summers"
            ));
        }
        if parameters.get("OUT_WIDTH") < parameters.get("WIDTH") {
            return Err("OUT_WIDTH is less than WIDTH: the sum would lose its top bits".into());
        }
        Ok(())
    }

    fn build(&self, b: &mut Builder) {
        let (width, out) = (b.count("WIDTH"), b.count("OUT_WIDTH"));
        let negative = b.param("NEGATIVE");
        let terms = b.input("terms");
        let mut sum = b.constant(0, out);
        for i in 0..b.count("TERMS") {
            let term = b.slice(terms, i * width, width);
            let term = b.sign_extend(term, out);
            sum = if negative >> i & 1 == 1 { b.sub(sum, term) } else { b.add(sum, term) };
        }
        b.output("sum", sum);
    }
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    #[test]
    fn each_term_counts_with_its_polarity() {
        let mut bench = Bench::new("summer", &[("WIDTH", 8), ("TERMS", 3), ("OUT_WIDTH", 12), ("NEGATIVE", 0b010)]);
        for (a, b, c) in [(1, 2, 3), (-128, 127, -128), (127, -128, 127), (0, 0, 0)] {
            bench.set("terms", (a & 255) | (b & 255) << 8 | (c & 255) << 16);
            assert_eq!(bench.get_signed("sum"), a - b + c);
        }
    }
}
