//! Scaling multiplier: a whole number times a factor with fraction bits, to the nearest whole number.

use super::words::{clocked, narrow};
use crate::base::ValueId;
use crate::blocks::{Block, Builder, Description, Kind, Parameter, Parameters, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build).with_check(check);

static DESCRIPTION: Description = Description {
    name: "scaling_multiplier",
    kind: Kind::Arithmetic,
    summary: "Multiplies a word by a factor with fraction bits and rounds, at a strobe.",
    doc: "scaled(t+1) = strobe(t) ? word * factor / 2^FRACTION : scaled(t), to the nearest whole number, halves away from \
          zero, so that opposite words stay opposite. `overflow` is held with it and is 1 when it does not fit.",
    source: "US 3,809,868, FIG. 14, multipliers 470 to 476; the rounding is chosen",
    parameters: &[
        Parameter { name: "WIDTH", default: 16, min: 2, max: 30, doc: "bits of the word, the factor and the result" },
        Parameter { name: "FRACTION", default: 12, min: 1, max: 29, doc: "fraction bits of the factor" },
    ],
    ports: &[
        PortDescription::input("strobe", Width::BIT, "clocks the module"),
        PortDescription::input("word", Width::Param("WIDTH"), "the word to scale").signed(),
        PortDescription::input("factor", Width::Param("WIDTH"), "the factor").signed(),
        PortDescription::output("scaled", Width::Param("WIDTH"), "the product at the last strobe").signed(),
        PortDescription::output("overflow", Width::BIT, "that product did not fit"),
    ],
    clocked: true,
};

fn check(p: &Parameters) -> Result<(), String> {
    let (width, fraction) = (p.get("WIDTH"), p.get("FRACTION"));
    if fraction < width {
        Ok(())
    } else {
        Err(format!("a factor of {width} bits has less than {fraction} of fraction"))
    }
}

fn build(b: &mut Builder) {
    let (width, fraction) = (b.count("WIDTH"), b.count("FRACTION"));
    let wide = 2 * width + 1;
    let [word, factor] = ["word", "factor"].map(|name| b.sign_extend(b.input(name), wide));
    let product = b.mul(word, factor);
    let rounded = nearest(b, product, fraction);
    let result = narrow(b, rounded, width);
    clocked(b, result, "scaled");
}

/// The product without its fraction: half a count is added, and one unit of the fraction less when it is negative.
fn nearest(b: &mut Builder, product: ValueId, fraction: u32) -> ValueId {
    let wide = b.width(product);
    let half = b.constant(1 << (fraction - 1), wide);
    let below = b.constant((1 << (fraction - 1)) - 1, wide);
    let negative = b.sign(product);
    let step = b.mux(negative, below, half);
    let sum = b.add(product, step);
    b.slice(sum, fraction, wide - fraction)
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    #[test]
    fn every_small_product_goes_to_the_nearest_number_and_halves_away_from_zero() {
        let mut bench = Bench::new("scaling_multiplier", &[("WIDTH", 6), ("FRACTION", 3)]);
        bench.set("strobe", 1);
        for word in -32..32 {
            for factor in -32..32 {
                bench.set_all(&[("word", word), ("factor", factor)]);
                bench.tick();
                // f64::round takes halves away from zero.
                let exact = ((word * factor) as f64 / 8.0).round() as i64;
                let fits = (-32..32).contains(&exact);
                assert_eq!(bench.get("overflow"), u64::from(!fits), "{word} times {factor}/8");
                assert!(!fits || bench.get_signed("scaled") == exact, "{word} times {factor}/8");
            }
        }
    }

    #[test]
    fn a_factor_of_one_changes_nothing_and_the_result_stays_without_a_strobe() {
        let mut bench = Bench::new("scaling_multiplier", &[]);
        for word in [0, 1, -1, 32767, -32768] {
            bench.set_all(&[("strobe", 1), ("word", word), ("factor", 4096)]);
            bench.tick();
            bench.set_all(&[("strobe", 0), ("word", 5)]);
            bench.tick();
            assert_eq!((bench.get_signed("scaled"), bench.get("overflow")), (word, 0));
        }
    }
}
