//! Angle converter: the sine or the cosine of an angle from a look-up table, with straight lines between its words.
//!
//! ```text
//!   angle --[fold into the first quarter]--+--> piece -->[ table ]--- base, rise
//!                                          |                             |
//!                                          +--> rest --------(base + rise * rest)--[sign]--> value
//! ```

use crate::base::{MemoryImage, ValueId};
use crate::blocks::sine::rounded_sine;
use crate::blocks::{Block, Builder, Description, Kind, Parameter, PortDescription, Width};

/// Bits of an angle within its quarter turn.
const QUARTER_BITS: u32 = 14;

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "angle_converter",
    kind: Kind::Memory,
    summary: "Looks up the sine or the cosine of an angle.",
    doc: "value = about 2^FRACTION * sin(2 pi angle / 2^16), or the cosine with COSINE = 1, combinational, in two's \
          complement: 2^FRACTION is 1 exactly. The table holds the sine of a quarter turn at N + 1 points, N = \
          2^PIECE_BITS, rounded to FRACTION bits; between two points the value is interpolated linearly and rounded; \
          quadrant and symmetry give the rest. A chord lies below the arc by at most h^2 / 8, h = pi / 2N, which is the \
          error but for the rounding: 2.9e-7 for N = 1024. Quarter turns are exact, and a half turn more changes just the \
          sign. The sine is computed in whole numbers, so that every machine gets the same words.",
    source: "US 3,809,868, FIG. 12, converters 412 (cosine) and 414 (sine): a look up table system in the case of \
             digital inputs; its size and the interpolation are chosen",
    parameters: &[
        Parameter { name: "COSINE", default: 0, min: 0, max: 1, doc: "0: the sine, 1: the cosine" },
        Parameter { name: "PIECE_BITS", default: 10, min: 1, max: 13, doc: "a quarter has 2^PIECE_BITS pieces" },
        Parameter { name: "FRACTION", default: 24, min: 8, max: 24, doc: "fraction bits of the value" },
    ],
    ports: &[
        PortDescription::input("angle", Width::Fixed(16), "2^16 is a full turn"),
        PortDescription::output("value", Width::Add(&Width::Param("FRACTION"), &Width::Fixed(2)), "sine or cosine")
            .signed(),
    ],
    clocked: false,
};

fn build(b: &mut Builder) {
    let mut angle = b.input("angle");
    if b.param("COSINE") == 1 {
        let quarter = b.constant(1 << QUARTER_BITS, 16);
        angle = b.add(angle, quarter);
    }
    let level = first_quarter(b, angle);
    let magnitude = interpolated(b, level);
    let (negative, negated) = (b.sign(angle), b.negate(magnitude));
    let value = b.mux(negative, negated, magnitude);
    b.output("value", value);
}

/// The angle of the first quarter turn, both ends included, whose sine has the same magnitude.
fn first_quarter(b: &mut Builder, angle: ValueId) -> ValueId {
    let within = b.slice(angle, 0, QUARTER_BITS);
    let within = b.zero_extend(within, QUARTER_BITS + 1);
    let quarter = b.constant(1 << QUARTER_BITS, QUARTER_BITS + 1);
    let mirrored = b.sub(quarter, within);
    let falling = b.pick(angle, QUARTER_BITS);
    b.mux(falling, mirrored, within)
}

/// The sine of an angle of the first quarter, with room for a sign.
fn interpolated(b: &mut Builder, level: ValueId) -> ValueId {
    let (piece_bits, fraction) = (b.count("PIECE_BITS"), b.count("FRACTION"));
    let rest_bits = QUARTER_BITS - piece_bits;
    let (piece, rest) = (b.slice(level, rest_bits, piece_bits + 1), b.slice(level, 0, rest_bits));
    b.name("piece", piece);
    let points: Vec<u64> = (0..=1 << piece_bits).map(|i| rounded_sine(i, 1 << piece_bits, fraction)).collect();
    let rises = points.windows(2).map(|pair| pair[1] - pair[0]).chain([0]);
    let rises = MemoryImage::from_words(fraction, rises);
    let bases = MemoryImage::from_words(fraction + 1, points.iter().copied());
    let (base, rise) = (b.rom(bases, piece), b.rom(rises, piece));

    let width = fraction + rest_bits;
    let (rise, rest) = (b.zero_extend(rise, width), b.zero_extend(rest, width));
    let product = b.mul(rise, rest);
    let half = b.constant(1 << (rest_bits - 1), width);
    let nearest = b.add(product, half);
    let share = b.slice(nearest, rest_bits, fraction);
    let (base, share) = (b.zero_extend(base, fraction + 2), b.zero_extend(share, fraction + 2));
    b.add(base, share)
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_PI_2, PI};

    use crate::blocks::bench::Bench;

    /// All 65,536 values, as real numbers.
    fn values(parameters: &[(&str, i64)], fraction: i32) -> Vec<f64> {
        let mut bench = Bench::new("angle_converter", parameters);
        let value = |angle| {
            bench.set("angle", angle);
            bench.get_signed("value") as f64 / 2_f64.powi(fraction)
        };
        (0..1 << 16).map(value).collect()
    }

    fn worst_error(values: &[f64], truth: fn(f64) -> f64) -> f64 {
        let error = |(angle, value): (usize, &f64)| (value - truth(2.0 * PI * angle as f64 / 65536.0)).abs();
        values.iter().enumerate().map(error).fold(0.0, f64::max)
    }

    #[test]
    fn every_angle_has_its_sine_and_cosine_but_for_a_chord_and_two_roundings() {
        for (piece_bits, fraction) in [(10, 24), (6, 20), (13, 8)] {
            let bound = (FRAC_PI_2 / f64::from(1 << piece_bits)).powi(2) / 8.0 + 2_f64.powi(-fraction);
            for (cosine, truth) in [(0, f64::sin as fn(f64) -> f64), (1, f64::cos)] {
                let parameters = [("COSINE", cosine), ("PIECE_BITS", piece_bits), ("FRACTION", fraction.into())];
                let worst = worst_error(&values(&parameters, fraction), truth);
                assert!((bound / 4.0..bound).contains(&worst), "{worst}, but {bound} was expected");
            }
        }
    }

    #[test]
    fn quarter_turns_are_exact_and_a_half_turn_changes_the_sign() {
        for cosine in 0..2 {
            let values = values(&[("COSINE", cosine)], 24);
            let quarters = [0, 1, 2, 3].map(|quarter| values[quarter << 14]);
            assert_eq!(quarters, [[0.0, 1.0, 0.0, -1.0], [1.0, 0.0, -1.0, 0.0]][cosine as usize]);
            assert!((0..1 << 15).all(|angle| values[angle] == -values[angle + (1 << 15)]));
        }
    }

    #[test]
    fn no_word_of_the_table_is_near_a_tie() {
        for i in 1..1024 {
            let scaled = (f64::from(i) * FRAC_PI_2 / 1024.0).sin() * f64::from(1 << 24);
            assert!((scaled.fract() - 0.5).abs() > 1e-5, "{i}");
        }
    }
}
