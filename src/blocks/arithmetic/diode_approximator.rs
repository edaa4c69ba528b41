//! Diode approximator: a quarter of a sine wave from straight pieces.
//!
//! ```text
//!   value
//!   2^BITS |               __--*      each * is a breakpoint: another diode begins to conduct
//!          |          _-*-'           and the slope falls
//!          |      _*-'
//!          |   .*'
//!          | /
//!        0 *----------------------- level
//!          0                    2^BITS
//! ```

use std::f64::consts::FRAC_PI_2;

use crate::base::{MemoryImage, ValueId};
use crate::blocks::{Block, Builder, Description, Kind, Parameter, PortDescription, Width};

static LEVEL: Width = Width::Add(&Width::Param("BITS"), &Width::Fixed(1));

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "diode_approximator",
    kind: Kind::Arithmetic,
    summary: "Shapes a level into a quarter of a sine wave made of straight pieces.",
    doc: "value = about 2^BITS * sin(pi/2 * level / 2^BITS), combinational, for a level from 0 to 2^BITS. There are N = \
          2^PIECE_BITS equal pieces; breakpoint i stands at level i/N * 2^BITS. Between two breakpoints on the curve a \
          chord would lie below it by the part s = 1 - cos(h/2) at most, h = pi/2N; the inner breakpoints are therefore \
          raised by about s/2. Both ends are exact, 0 and 2^BITS, so that the error is s/2 in all pieces but the last, \
          where it is 3/4 s: 0.09 % of full scale for 16 pieces.",
    source: "US 3,809,868, FIG. 4A, diode approximators 93 and 97; number and place of the breakpoints are chosen",
    parameters: &[
        Parameter { name: "BITS", default: 28, min: 8, max: 30, doc: "full scale of level and value is 2^BITS" },
        Parameter { name: "PIECE_BITS", default: 4, min: 0, max: 7, doc: "there are 2^PIECE_BITS straight pieces" },
    ],
    ports: &[
        PortDescription::input("level", LEVEL, "0 to 2^BITS, without sign"),
        PortDescription::output("value", LEVEL, "0 to 2^BITS, without sign"),
    ],
    clocked: false,
};

fn build(b: &mut Builder) {
    let (bits, piece_bits, level) = (b.count("BITS"), b.count("PIECE_BITS"), b.input("level"));
    let points = breakpoints(bits, 1 << piece_bits);
    let piece_width = bits - piece_bits;
    // With a single piece the address is the top bit, which is 0 below full scale.
    let piece = b.slice(level, piece_width, (piece_bits + 1).max(1));
    let within = b.slice(level, 0, piece_width);

    let (base, rise) = tables(b, &points, bits, piece);
    b.name("piece", piece);
    let width = bits + piece_width + 1;
    let (rise, within) = (b.zero_extend(rise, width), b.zero_extend(within, width));
    let product = b.mul(rise, within);
    let share = b.slice(product, piece_width, bits + 1);
    let value = b.add(base, share);
    b.output("value", value);
}

/// For the piece in work: the value at its left breakpoint, and how much higher the right one is. Full scale is one
/// more piece of no rise.
fn tables(b: &mut Builder, points: &[u64], bits: u32, piece: ValueId) -> (ValueId, ValueId) {
    let rises = points.windows(2).map(|pair| pair[1] - pair[0]).chain([0]);
    let bases = MemoryImage::from_words(bits + 1, points.iter().copied());
    let rises = MemoryImage::from_words(bits + 1, rises);
    (b.rom(bases, piece), b.rom(rises, piece))
}

/// The value at each breakpoint, both ends included.
fn breakpoints(bits: u32, pieces: u32) -> Vec<u64> {
    let half = FRAC_PI_2 / f64::from(pieces) / 2.0;
    let raised = 2.0 / (1.0 + half.cos());
    let full = (1_u64 << bits) as f64;
    let at = |piece: u32| match piece {
        0 => 0.0,
        last if last == pieces => full,
        inner => (full * raised * (f64::from(inner) * 2.0 * half).sin()).round(),
    };
    (0..=pieces).map(|piece| at(piece) as u64).collect()
}

#[cfg(test)]
mod tests {
    use std::f64::consts::FRAC_PI_2;

    use crate::blocks::bench::Bench;

    fn worst_error(piece_bits: i64) -> f64 {
        let mut bench = Bench::new("diode_approximator", &[("BITS", 20), ("PIECE_BITS", piece_bits)]);
        let full = f64::from(1 << 20);
        let error = |level: i64| {
            bench.set("level", level);
            bench.get("value") as f64 / full - (FRAC_PI_2 * level as f64 / full).sin()
        };
        (0..=1 << 20).step_by(61).map(error).map(f64::abs).fold(0.0, f64::max)
    }

    #[test]
    fn both_ends_are_exact() {
        for piece_bits in 0..=7 {
            let mut bench = Bench::new("diode_approximator", &[("PIECE_BITS", piece_bits)]);
            for end in [0, 1 << 28] {
                bench.set("level", end);
                assert_eq!(bench.get("value"), end as u64);
            }
        }
    }

    #[test]
    fn the_error_is_three_quarters_of_the_sagitta_of_a_chord() {
        for piece_bits in 2..=7 {
            let half = FRAC_PI_2 / f64::from(2 << piece_bits);
            let sagitta = 1.0 - half.cos();
            let worst = worst_error(piece_bits) / sagitta;
            assert!((0.65..0.85).contains(&worst), "{piece_bits}: {worst} of the sagitta");
        }
    }

    #[test]
    fn it_rises_everywhere_and_each_piece_less_steeply_than_the_one_before() {
        let mut bench = Bench::new("diode_approximator", &[("BITS", 16), ("PIECE_BITS", 3)]);
        let values: Vec<i64> = (0..=32)
            .map(|i| {
                bench.set("level", i << 11);
                bench.get("value") as i64
            })
            .collect();
        let rises: Vec<i64> = values.windows(2).map(|pair| pair[1] - pair[0]).collect();
        assert!(rises.iter().all(|&rise| rise > 0), "{rises:?}");
        assert!(rises.windows(2).all(|pair| pair[1] <= pair[0] + 1), "{rises:?}");
    }
}
