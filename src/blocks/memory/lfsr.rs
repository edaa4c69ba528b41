//! LFSR: a linear-feedback shift register, which runs through pseudo-random words.
//!
//! ```text
//!   q(t+1) = q(t) >> 1 xor (q(t)[0] ? TAPS : 0)
//! ```

use crate::blocks::{Block, Builder, Description, Kind, Parameter, Parameters, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build).with_check(check);

static DESCRIPTION: Description = Description {
    name: "lfsr",
    kind: Kind::Memory,
    summary: "Runs through pseudo-random words, one a tick.",
    doc: "q(t+1) = (q >> 1) xor (q[0] ? TAPS : 0), in Galois' form; q(0) = SEED. With the taps of a primitive \
          polynomial q takes every value but 0 before it repeats: bit i - 1 of TAPS is the coefficient of x^i. \
          SEED and TAPS are cut to WIDTH bits; neither may then be 0.",
    source: "bench of this project; the default is x^31 + x^28 + 1, from the usual tables (Xilinx XAPP 052)",
    parameters: &[
        Parameter { name: "WIDTH", default: 31, min: 2, max: 31, doc: "bits of the word" },
        Parameter { name: "TAPS", default: 0x4800_0000, min: 1, max: 0x7FFF_FFFF, doc: "feedback polynomial" },
        Parameter { name: "SEED", default: 1, min: 1, max: 0x7FFF_FFFF, doc: "word at tick 0" },
    ],
    ports: &[PortDescription::output("q", Width::Param("WIDTH"), "the word")],
    clocked: true,
};

fn check(parameters: &Parameters) -> Result<(), String> {
    let width = parameters.get("WIDTH");
    for name in ["TAPS", "SEED"] {
        if parameters.get(name) % (1 << width) == 0 {
            return Err(format!("{name} has no 1 in its low {width} bits: the register would stand still at 0"));
        }
    }
    Ok(())
}

fn build(b: &mut Builder) {
    let width = b.count("WIDTH");
    let q = b.hold(width, u64::from(b.count("SEED")));
    let low = b.pick(q.q, 0);
    let rest = b.slice(q.q, 1, width - 1);
    let shifted = b.zero_extend(rest, width);
    let taps = b.constant(u64::from(b.count("TAPS")), width);
    let feedback = b.gate(low, taps);
    let next = b.xor(shifted, feedback);
    let q = b.load(q, next, None, None);
    b.output("q", q);
}

#[cfg(test)]
mod tests {
    use std::collections::HashSet;

    use crate::blocks::bench::Bench;

    #[test]
    fn primitive_polynomials_visit_every_word_but_zero() {
        // x^4 + x^3 + 1, x^5 + x^3 + 1, x^8 + x^6 + x^5 + x^4 + 1: XAPP 052, table 3.
        for (width, taps) in [(4, 0b1100), (5, 0b1_0100), (8, 0b1011_1000)] {
            let mut bench = Bench::new("lfsr", &[("WIDTH", width), ("TAPS", taps)]);
            let mut seen = HashSet::new();
            while seen.insert(bench.get("q")) {
                bench.tick();
            }
            assert_eq!(seen.len(), (1 << width) - 1);
            assert!(!seen.contains(&0));
            assert_eq!(bench.get("q"), 1, "back at the seed");
        }
    }
}
