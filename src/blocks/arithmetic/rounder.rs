//! Rounder: a fixed-point word to the nearest whole number, held from the strobe on.

use super::words::{clocked, narrow};
use crate::blocks::{Block, Builder, Description, Kind, Parameter, Parameters, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build).with_check(check);

static DESCRIPTION: Description = Description {
    name: "rounder",
    kind: Kind::Arithmetic,
    summary: "Rounds a fixed-point word to the nearest whole number at a strobe.",
    doc: "rounded(t+1) = strobe(t) ? floor(a(t) / 2^FRACTION + 1/2) : rounded(t). A half is rounded up, also below zero: \
          so rounding commutes with the addition of a whole number, round(a + n) = round(a) + n. `overflow` is held \
          with the result and is 1 when it does not fit WIDTH bits.",
    source: "chosen: US 3,809,868 leaves the passage from quotients to coefficient registers open",
    parameters: &[
        Parameter { name: "A_WIDTH", default: 40, min: 2, max: 62, doc: "bits of a" },
        Parameter { name: "FRACTION", default: 24, min: 1, max: 61, doc: "fraction bits of a" },
        Parameter { name: "WIDTH", default: 16, min: 1, max: 62, doc: "bits of the result" },
    ],
    ports: &[
        PortDescription::input("strobe", Width::BIT, "clocks the module"),
        PortDescription::input("a", Width::Param("A_WIDTH"), "the word to round").signed(),
        PortDescription::output("rounded", Width::Param("WIDTH"), "the whole number at the last strobe").signed(),
        PortDescription::output("overflow", Width::BIT, "that number did not fit"),
    ],
    clocked: true,
};

fn check(parameters: &Parameters) -> Result<(), String> {
    let (width, fraction) = (parameters.get("A_WIDTH"), parameters.get("FRACTION"));
    if fraction >= width {
        return Err(format!("FRACTION is {fraction}: nothing is left of a word of {width} bits"));
    }
    Ok(())
}

fn build(b: &mut Builder) {
    let (a, fraction) = (b.input("a"), b.count("FRACTION"));
    let half_bit = b.pick(a, fraction - 1);
    let whole = b.slice(a, fraction, b.width(a) - fraction);
    let width = b.width(whole) + 1;
    let (whole, carry) = (b.sign_extend(whole, width), b.zero_extend(half_bit, width));
    let sum = b.add(whole, carry);
    let kept = b.count("WIDTH");
    let result = narrow(b, sum, kept);
    clocked(b, result, "rounded");
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    #[test]
    fn every_word_goes_to_the_nearest_whole_number_and_halves_go_up() {
        let mut bench = Bench::new("rounder", &[("A_WIDTH", 8), ("FRACTION", 3), ("WIDTH", 4)]);
        bench.set("strobe", 1);
        for a in -128..128 {
            bench.set("a", a);
            bench.tick();
            let nearest = (a as f64 / 8.0 + 0.5).floor() as i64;
            let fits = (-8..8).contains(&nearest);
            assert_eq!(bench.get("overflow") == 1, !fits, "{a}/8");
            assert!(!fits || bench.get_signed("rounded") == nearest, "{a}/8");
        }
    }

    #[test]
    fn the_result_is_held_between_strobes() {
        let mut bench = Bench::new("rounder", &[]);
        bench.set_all(&[("a", 5 << 24), ("strobe", 1)]);
        bench.tick();
        bench.set_all(&[("a", 0), ("strobe", 0)]);
        bench.tick();
        assert_eq!(bench.get("rounded"), 5);
    }
}
