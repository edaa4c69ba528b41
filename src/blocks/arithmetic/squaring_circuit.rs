//! Squaring circuit: a multiplier with both inputs tied together.

use crate::base::word::MAX_WIDTH;
use crate::blocks::{Block, Builder, Description, Kind, Parameter, Parameters, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build).with_check(check);

static DESCRIPTION: Description = Description {
    name: "squaring_circuit",
    kind: Kind::Arithmetic,
    summary: "Squares a two's-complement word at a strobe.",
    doc: "square(t+1) = strobe(t) ? floor(a(t)^2 / 2^DROP) : square(t). `overflow` is held with it and is 1 when it does \
          not fit WIDTH bits (the top one is the sign).",
    source: "US 3,809,868, FIG. 5 to 7 (squaring circuits 124, 188, 208)",
    parameters: &[
        Parameter { name: "A_WIDTH", default: 16, min: 1, max: 42, doc: "bits of a" },
        Parameter { name: "DROP", default: 0, min: 0, max: 63, doc: "low bits of the square that are cut" },
        Parameter { name: "WIDTH", default: 32, min: 1, max: 64, doc: "bits of the square kept" },
    ],
    ports: &[
        PortDescription::input("strobe", Width::BIT, "clocks the module"),
        PortDescription::input("a", Width::Param("A_WIDTH"), "the word to square").signed(),
        PortDescription::output("square", Width::Param("WIDTH"), "the square at the last strobe").signed(),
        PortDescription::output("overflow", Width::BIT, "that square did not fit"),
    ],
    clocked: true,
};

fn check(parameters: &Parameters) -> Result<(), String> {
    let (bits, drop) = (2 * parameters.get("A_WIDTH"), parameters.get("DROP"));
    if drop < bits - i64::from(MAX_WIDTH) {
        return Err(format!("the square has {bits} bits: DROP must cut all above 64"));
    }
    if drop >= bits {
        return Err(format!("DROP is {drop}: nothing is left of a square of {bits} bits"));
    }
    Ok(())
}

fn build(b: &mut Builder) {
    let [width, drop, kept] = ["A_WIDTH", "DROP", "WIDTH"].map(|name| b.param(name));
    let parameters = [("A_WIDTH", width), ("B_WIDTH", width), ("DROP", drop), ("WIDTH", kept)];
    let (strobe, a) = (b.input("strobe"), b.input("a"));
    let square = b.block("multiplier", "multiplier", &parameters, &[("strobe", strobe), ("a", a), ("b", a)]);
    b.output("square", square[0]);
    b.output("overflow", square[1]);
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    #[test]
    fn squares_are_exact_and_cut_downwards() {
        let mut bench = Bench::new("squaring_circuit", &[("A_WIDTH", 8), ("DROP", 2), ("WIDTH", 13)]);
        bench.set("strobe", 1);
        for a in -128..128 {
            bench.set("a", a);
            bench.tick();
            let expected = a * a / 4;
            assert_eq!(bench.get("overflow") == 1, expected >= 4096, "{a}");
            assert!(expected >= 4096 || bench.get_signed("square") == expected, "{a}");
        }
    }

    #[test]
    fn a_word_of_42_bits_can_be_squared() {
        let mut bench = Bench::new("squaring_circuit", &[("A_WIDTH", 42), ("DROP", 30), ("WIDTH", 54)]);
        bench.set("strobe", 1);
        for a in [-(1_i64 << 41), -1, 0, 1, 987_654_321_987, (1 << 41) - 1] {
            bench.set("a", a);
            bench.tick();
            assert_eq!(i128::from(bench.get_signed("square")), (i128::from(a) * i128::from(a)) >> 30, "{a}");
        }
    }
}
