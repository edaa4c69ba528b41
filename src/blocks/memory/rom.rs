//! Read-only memory: a table of a stated function.
//!
//! ```text
//!   address --->[ table ]---> word
//! ```

use crate::base::MemoryImage;
use crate::base::word::mask;
use crate::blocks::{Block, Builder, Description, Kind, Parameter, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "rom",
    kind: Kind::Memory,
    summary: "Holds the table of a function: squares, or a quarter wave of the sine.",
    doc: "word = table[address], combinational, for 2^ADDRESS addresses. FUNCTION 0: the square of the address, its \
          low WIDTH bits. FUNCTION 1: the sine over a quarter turn, (2^WIDTH - 1) * sin(address / 2^ADDRESS * 90 \
          degrees), rounded to the nearest whole number.",
    source: "the table memory of any textbook",
    parameters: &[
        Parameter { name: "ADDRESS", default: 7, min: 1, max: 12, doc: "bits of the address" },
        Parameter { name: "WIDTH", default: 8, min: 1, max: 32, doc: "bits of each word" },
        Parameter { name: "FUNCTION", default: 0, min: 0, max: 1, doc: "0: squares, 1: quarter wave of the sine" },
    ],
    ports: &[
        PortDescription::input("address", Width::Param("ADDRESS"), "which word"),
        PortDescription::output("word", Width::Param("WIDTH"), "the word there"),
    ],
    clocked: false,
};

fn build(b: &mut Builder) {
    let (address_bits, width) = (b.count("ADDRESS"), b.count("WIDTH"));
    let sine = b.param("FUNCTION") == 1;
    let entry = |address: u64| {
        if sine { quarter_sine(address, address_bits, width) } else { (address * address) & mask(width) }
    };
    let image = MemoryImage::from_words(width, (0..1 << address_bits).map(entry));
    let word = b.rom(image, b.input("address"));
    b.output("word", word);
}

fn quarter_sine(address: u64, address_bits: u32, width: u32) -> u64 {
    let angle = address as f64 / f64::from(1 << address_bits) * std::f64::consts::FRAC_PI_2;
    (mask(width) as f64 * angle.sin()).round() as u64
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    #[test]
    fn squares_differ_by_the_odd_numbers() {
        let mut bench = Bench::new("rom", &[("ADDRESS", 5), ("WIDTH", 10)]);
        let mut square = 0;
        for address in 0..32 {
            bench.set("address", address);
            assert_eq!(bench.get("word"), square);
            square += 2 * address as u64 + 1;
        }
    }

    #[test]
    fn a_square_too_wide_for_the_word_loses_its_top_bits() {
        let mut bench = Bench::new("rom", &[("ADDRESS", 5), ("WIDTH", 8)]);
        bench.set("address", 17);
        assert_eq!(bench.get("word"), 289 - 256);
    }

    #[test]
    fn sine_and_mirrored_sine_keep_the_law_of_pythagoras() {
        let mut bench = Bench::new("rom", &[("ADDRESS", 6), ("WIDTH", 12), ("FUNCTION", 1)]);
        let mut table = Vec::new();
        for address in 0..64 {
            bench.set("address", address);
            table.push(bench.get("word") as f64 / 4095.0);
        }
        assert_eq!(table[0], 0.0);
        assert_eq!((table[32] * 4095.0) as i64, 2896, "4095 * sin 45 degrees = 2895.6");
        for address in 1..64 {
            assert!(table[address] > table[address - 1]);
            let square = table[address].powi(2) + table[64 - address].powi(2);
            assert!((square - 1.0).abs() < 1.0 / 2048.0, "address {address}: {square}");
        }
    }
}
