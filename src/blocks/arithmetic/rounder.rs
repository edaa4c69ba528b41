//! Rounder: a fixed-point word to the nearest whole number, held from the strobe on.

use super::words::{clocked, narrow};
use crate::base::ValueId;
use crate::blocks::{Block, Builder, Description, Kind, Parameter, Parameters, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build).with_check(check);

static DESCRIPTION: Description = Description {
    name: "rounder",
    kind: Kind::Arithmetic,
    summary: "Rounds a fixed-point word to the nearest whole number at a strobe.",
    doc: "rounded(t+1) = strobe(t) ? the whole number nearest to a(t) / 2^FRACTION : rounded(t). HALVES decides where a \
          half goes. 0: up, also below zero, so that rounding commutes with the addition of a whole number, \
          round(a + n) = round(a) + n. 1: away from zero, so that it commutes with a change of sign, round(-a) = \
          -round(a). `overflow` is held with the result and is 1 when it does not fit WIDTH bits.",
    source: "chosen: US 3,809,868 leaves the passage from quotients to coefficient registers open",
    parameters: &[
        Parameter { name: "A_WIDTH", default: 40, min: 2, max: 62, doc: "bits of a" },
        Parameter { name: "FRACTION", default: 24, min: 1, max: 61, doc: "fraction bits of a" },
        Parameter { name: "WIDTH", default: 16, min: 1, max: 62, doc: "bits of the result" },
        Parameter { name: "HALVES", default: 0, min: 0, max: 1, doc: "0: halves go up; 1: away from zero" },
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
    let carry = if b.param("HALVES") == 1 { carry_away(b, a, fraction) } else { b.pick(a, fraction - 1) };
    let whole = b.slice(a, fraction, b.width(a) - fraction);
    let width = b.width(whole) + 1;
    let (whole, carry) = (b.sign_extend(whole, width), b.zero_extend(carry, width));
    let sum = b.add(whole, carry);
    let kept = b.count("WIDTH");
    let result = narrow(b, sum, kept);
    clocked(b, result, "rounded");
}

/// Whether the fraction carries into the whole part: the half bit, but not for just a half below zero.
fn carry_away(b: &mut Builder, a: ValueId, fraction: u32) -> ValueId {
    let (half_bit, negative) = (b.pick(a, fraction - 1), b.sign(a));
    let above_zero = b.not(negative);
    if fraction == 1 {
        return b.and(half_bit, above_zero);
    }
    let below_half = b.slice(a, 0, fraction - 1);
    let more = b.reduce_or(below_half);
    let carries = b.or(above_zero, more);
    b.and(half_bit, carries)
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    /// Every word of 8 bits against `nearest`, a function of the real number.
    fn rounds_like(fraction: i64, halves: i64, nearest: fn(f64) -> f64) {
        let parameters = [("A_WIDTH", 8), ("FRACTION", fraction), ("WIDTH", 4), ("HALVES", halves)];
        let mut bench = Bench::new("rounder", &parameters);
        bench.set("strobe", 1);
        for a in -128..128 {
            bench.set("a", a);
            bench.tick();
            let nearest = nearest(a as f64 / f64::from(1 << fraction)) as i64;
            let fits = (-8..8).contains(&nearest);
            assert_eq!(bench.get("overflow") == 1, !fits, "{a} / 2^{fraction}");
            assert!(!fits || bench.get_signed("rounded") == nearest, "{a} / 2^{fraction}");
        }
    }

    #[test]
    fn every_word_goes_to_the_nearest_whole_number_and_halves_go_up() {
        rounds_like(3, 0, |a| (a + 0.5).floor());
    }

    #[test]
    fn halves_go_away_from_zero_where_the_parameter_says_so() {
        for fraction in [1, 2, 3, 7] {
            rounds_like(fraction, 1, f64::round);
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
