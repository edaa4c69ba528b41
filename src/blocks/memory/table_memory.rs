//! Table memory: the sine or cosine pulse-rate table, computed when the circuit is built.
//!
//! ```text
//!   333: T[i] = R(S sin((i+1)h)) - R(S sin(i h)),  i = 0 .. N-1,  h = pi / 2N,  S = 2^SUM_BITS
//!   334: the same words in reverse order
//! ```

use crate::base::MemoryImage;
use crate::base::word::{clog2, mask};
use crate::blocks::sine::rounded_sine;
use crate::blocks::{Block, Builder, Description, Kind, Parameter, Parameters, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build).with_check(check);

static DESCRIPTION: Description = Description {
    name: "table_memory",
    kind: Kind::Memory,
    summary: "A read-only table of the differences of the sine or the cosine over a quarter turn.",
    doc: "Word i is R(S sin((i+1)h)) - R(S sin(i h)) with S = 2^SUM_BITS, N = ENTRIES, h = pi/2N, R rounding to the \
          nearest whole number; with REVERSED = 1 the words stand in reverse order, which makes it the table of the \
          cosine. Because neighbouring words share the rounded value between them, all words sum to S exactly: each \
          quarter gives exactly S pulses. Rounding each difference by itself does not (4098 instead of 4096). The sine is \
          computed in whole numbers of 2^-62, so that every machine gets the same words. Combinational.",
    source: "US 3,809,868, FIG. 10, tables 333 (sine) and 334 (cosine); the rule of differences is chosen",
    parameters: &[
        Parameter { name: "ENTRIES", default: 128, min: 2, max: 4096, doc: "words, a power of two" },
        Parameter { name: "WIDTH", default: 6, min: 1, max: 16, doc: "bits of a word" },
        Parameter { name: "SUM_BITS", default: 12, min: 1, max: 24, doc: "the words sum to 2^SUM_BITS" },
        Parameter { name: "REVERSED", default: 0, min: 0, max: 1, doc: "0: differences of the sine; 1: of the cosine" },
    ],
    ports: &[
        PortDescription::input("address", Width::Clog2(&Width::Param("ENTRIES")), "word number"),
        PortDescription::output("word", Width::Param("WIDTH"), "pulses during this entry"),
    ],
    clocked: false,
};

fn check(p: &Parameters) -> Result<(), String> {
    let entries = p.get("ENTRIES").unsigned_abs();
    if !entries.is_power_of_two() {
        let next = 1_u64 << clog2(entries);
        return Err(format!("ENTRIES is {entries}, but the counter of addresses needs a power of two: try {next}"));
    }
    let largest = differences(entries, p.get("SUM_BITS") as u32).into_iter().max().unwrap_or(0);
    let width = p.get("WIDTH") as u32;
    if largest > mask(width) {
        let enough = clog2(largest + 1);
        return Err(format!("the largest word is {largest}, which {width} bits do not hold: take WIDTH {enough}"));
    }
    Ok(())
}

fn build(b: &mut Builder) {
    let mut words = differences(u64::from(b.count("ENTRIES")), b.count("SUM_BITS"));
    if b.param("REVERSED") == 1 {
        words.reverse();
    }
    let image = MemoryImage::from_words(b.count("WIDTH"), words);
    let word = b.rom(image, b.input("address"));
    b.output("word", word);
}

/// The differences of the rounded sine over a quarter turn.
fn differences(entries: u64, sum_bits: u32) -> Vec<u64> {
    let rounded: Vec<u64> = (0..=entries).map(|i| rounded_sine(i, entries, sum_bits)).collect();
    rounded.windows(2).map(|pair| pair[1] - pair[0]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::blocks::bench::Bench;

    fn table(entries: i64, width: i64, sum_bits: i64, reversed: i64) -> Vec<u64> {
        let parameters = [("ENTRIES", entries), ("WIDTH", width), ("SUM_BITS", sum_bits), ("REVERSED", reversed)];
        let mut bench = Bench::new("table_memory", &parameters);
        let read = |address| {
            bench.set("address", address);
            bench.get("word")
        };
        (0..entries).map(read).collect()
    }

    #[test]
    fn the_words_are_the_differences_of_the_rounded_sine_and_sum_to_a_power_of_two() {
        for (entries, width, sum_bits) in [(128, 6, 12), (64, 7, 12), (32, 5, 9), (512, 6, 14), (1024, 6, 15)] {
            let h = std::f64::consts::FRAC_PI_2 / entries as f64;
            let at = |i: i64| ((1_i64 << sum_bits) as f64 * (i as f64 * h).sin()).round() as u64;
            let expected: Vec<u64> = (0..entries).map(|i| at(i + 1) - at(i)).collect();
            assert_eq!(table(entries, width, sum_bits, 0), expected);
            let backwards: Vec<u64> = expected.iter().rev().copied().collect();
            assert_eq!(table(entries, width, sum_bits, 1), backwards);
            assert_eq!(expected.iter().sum::<u64>(), 1 << sum_bits);
        }
    }

    #[test]
    fn no_rounding_of_a_recommended_table_is_near_a_tie() {
        for (entries, sum_bits) in [(128, 12), (64, 12), (32, 12), (32, 9), (32, 10), (512, 14), (1024, 15)] {
            for i in 1..entries {
                let sine = (f64::from(i) * std::f64::consts::FRAC_PI_2 / f64::from(entries)).sin();
                let scaled = sine * f64::from(1 << sum_bits);
                assert!((scaled.fract() - 0.5).abs() > 1e-6, "{i} of {entries}");
            }
        }
    }

    #[test]
    fn a_table_that_its_words_or_addresses_cannot_hold_is_refused() {
        let refusal = |entries, width| {
            let mut p = Parameters::defaults(&DESCRIPTION);
            p.set("ENTRIES", entries);
            p.set("WIDTH", width);
            BLOCK.check(&p).expect_err("refused")
        };
        assert!(refusal(100, 6).contains("try 128"));
        assert!(refusal(64, 6).contains("take WIDTH 7"));
    }
}
