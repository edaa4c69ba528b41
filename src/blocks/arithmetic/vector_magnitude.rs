//! Vector magnitude: about the square root of the sum of two squares, without squares or roots.

use std::f64::consts::PI;

use crate::base::ValueId;
use crate::blocks::{Block, Builder, Description, Kind, Parameter, PortDescription, Width};

/// Directions, evenly spread over 0 to 45 degrees, along which the vector is measured.
const DIRECTIONS: u32 = 4;
/// Fraction bits of their cosines and sines.
const FRACTION: u32 = 12;

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "vector_magnitude",
    kind: Kind::Arithmetic,
    summary: "Gives the length of a vector to a quarter of a per cent.",
    doc: "magnitude = about sqrt(x^2 + y^2), combinational. With a and b the larger and the smaller of |x| and |y|, it is \
          the largest of the projections a cos d + b sin d onto d = 5.6, 16.9, 28.1 and 39.4 degrees, scaled so that the \
          error is between -0.25 % and +0.25 %. The sum of squares itself would need words of twice the width.",
    source: "US 3,809,868, description of FIG. 4, compensator 102: the square root of the sum of the squares or \
             approximations thereto",
    parameters: &[Parameter { name: "WIDTH", default: 32, min: 2, max: 50, doc: "bits of x and y" }],
    ports: &[
        PortDescription::input("x", Width::Param("WIDTH"), "first component").signed(),
        PortDescription::input("y", Width::Param("WIDTH"), "second component").signed(),
        PortDescription::output(
            "magnitude",
            Width::Add(&Width::Param("WIDTH"), &Width::Fixed(1)),
            "length of the vector, without sign",
        ),
    ],
    clocked: false,
};

fn build(b: &mut Builder) {
    let width = b.count("WIDTH");
    let [x, y] = ["x", "y"].map(|name| {
        let word = b.input(name);
        let (sign, negated) = (b.sign(word), b.negate(word));
        b.mux(sign, negated, word)
    });
    let y_larger = b.less(x, y);
    let (large, small) = (b.mux(y_larger, y, x), b.mux(y_larger, x, y));
    let wide = width + FRACTION + 1;
    let (large, small) = (b.zero_extend(large, wide), b.zero_extend(small, wide));
    let mut longest = b.constant(0, wide);
    for (cosine, sine) in directions() {
        let projection = project(b, (large, cosine), (small, sine));
        let longer = b.less(longest, projection);
        longest = b.mux(longer, projection, longest);
    }
    let magnitude = b.slice(longest, FRACTION, width + 1);
    b.output("magnitude", magnitude);
}

fn project(b: &mut Builder, (large, cosine): (ValueId, u64), (small, sine): (ValueId, u64)) -> ValueId {
    let width = b.width(large);
    let (cosine, sine) = (b.constant(cosine, width), b.constant(sine, width));
    let (along, across) = (b.mul(large, cosine), b.mul(small, sine));
    b.add(along, across)
}

/// Cosine and sine of each direction, scaled, with [`FRACTION`] bits.
fn directions() -> impl Iterator<Item = (u64, u64)> {
    let half = PI / 4.0 / f64::from(DIRECTIONS) / 2.0;
    let scale = f64::from(1 << FRACTION) * 2.0 / (1.0 + half.cos());
    (0..DIRECTIONS).map(move |i| {
        let (sine, cosine) = (f64::from(2 * i + 1) * half).sin_cos();
        ((scale * cosine).round() as u64, (scale * sine).round() as u64)
    })
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    #[test]
    fn the_length_is_right_to_a_quarter_of_a_per_cent_in_every_direction() {
        let mut bench = Bench::new("vector_magnitude", &[("WIDTH", 24)]);
        for degree in 0..720 {
            let (sine, cosine) = (f64::from(degree) / 2.0).to_radians().sin_cos();
            let (x, y) = ((cosine * 8e6).round(), (sine * 8e6).round());
            bench.set_all(&[("x", x as i64), ("y", y as i64)]);
            let error = bench.get("magnitude") as f64 / x.hypot(y) - 1.0;
            assert!(error.abs() < 0.0027, "{error} at {} degrees", f64::from(degree) / 2.0);
        }
    }

    #[test]
    fn the_extremes_of_the_words_fit() {
        for width in [2, 8, 50] {
            let mut bench = Bench::new("vector_magnitude", &[("WIDTH", width)]);
            let least = -(1_i64 << (width - 1));
            bench.set_all(&[("x", least), ("y", least)]);
            let truth = (least as f64).hypot(least as f64);
            assert!((bench.get("magnitude") as f64 - truth).abs() <= 1.0 + truth * 0.003, "{width} bits");
        }
    }
}
