//! Checksum: folds a train of words into one, so that a single bit anywhere in it shows at the end.
//!
//! ```text
//!   sum(t+1) = rotate_left(sum(t), 1) xor word(t)
//! ```

use crate::blocks::{Block, Builder, Description, Kind, Parameter, Parameters, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build).with_check(check);

static DESCRIPTION: Description = Description {
    name: "checksum",
    kind: Kind::Memory,
    summary: "Folds a train of words, one a tick, into a single one.",
    doc: "sum(t+1) = sum rotated left by one digit, xor word; 0 at power-on. The word is widened with zeros.",
    source: "bench of this project",
    parameters: &[
        Parameter { name: "WIDTH", default: 8, min: 1, max: 32, doc: "bits of the word" },
        Parameter { name: "SUM_WIDTH", default: 32, min: 2, max: 64, doc: "bits of the sum" },
    ],
    ports: &[
        PortDescription::input("word", Width::Param("WIDTH"), "what is folded in"),
        PortDescription::output("sum", Width::Param("SUM_WIDTH"), "all words up to the tick before"),
    ],
    clocked: true,
};

fn check(parameters: &Parameters) -> Result<(), String> {
    if parameters.get("WIDTH") > parameters.get("SUM_WIDTH") {
        return Err("WIDTH is greater than SUM_WIDTH: the sum would lose bits of the word".into());
    }
    Ok(())
}

fn build(b: &mut Builder) {
    let width = b.count("SUM_WIDTH");
    let sum = b.hold(width, 0);
    let (top, rest) = (b.sign(sum.q), b.slice(sum.q, 0, width - 1));
    let rotated = b.concat(rest, top);
    let word = b.input("word");
    let word = b.zero_extend(word, width);
    let next = b.xor(rotated, word);
    let sum = b.load(sum, next, None, None);
    b.output("sum", sum);
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    #[test]
    fn a_bit_goes_round_and_meets_later_ones() {
        let mut bench = Bench::new("checksum", &[("WIDTH", 3), ("SUM_WIDTH", 4)]);
        // By hand: 0101; 1010 + 0001 = 1011; 0111 + 0000; 1110 + 0110 = 1000; 0001 + 0000.
        for (word, sum) in [(0b101, 0b0101), (0b001, 0b1011), (0, 0b0111), (0b110, 0b1000), (0, 0b0001)] {
            bench.set("word", word);
            bench.tick();
            assert_eq!(bench.get("sum"), sum);
        }
    }
}
