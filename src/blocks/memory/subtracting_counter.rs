//! Subtracting counter: counts down by weighted pulses, with fraction digits, and reports when it passes below zero.
//!
//! ```text
//!                   load  clear
//!                     |     |
//!   word ----------->[  count  ]---> count
//!   subtract[3] -1   [         ]---> overflow
//!   subtract[2] -1/2 [         ]
//!   subtract[1] -1/4 [         ]
//!   subtract[0] -1/8 [         ]        (FRACTION = 3)
//! ```

use crate::base::ValueId;
use crate::blocks::{Block, Builder, Description, Kind, Parameter, PortDescription, Width};

const COUNT: Width = Width::Add(&Width::Add(&Width::Param("WIDTH"), &Width::Param("FRACTION")), &Width::BIT);

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "subtracting_counter",
    kind: Kind::Memory,
    summary: "Counts down from a loaded whole number by pulses of several weights until it passes below zero.",
    doc: "count(t+1) = clear ? 0 : load ? word : count - subtract, in units of 2^-FRACTION. Clear wins over load, load \
          over counting. Bit i of `subtract` is a count input of weight 2^(i - FRACTION), so that the top one counts \
          whole steps; pulses at several inputs in one tick all count.\n\
          `overflow` is high for one tick: the first in which the count is below zero.",
    source: "SU 1522157, counter 14 of FIG. 1",
    parameters: &[
        Parameter { name: "WIDTH", default: 12, min: 1, max: 48, doc: "bits of the whole number" },
        Parameter { name: "FRACTION", default: 3, min: 0, max: 15, doc: "fraction bits below it" },
    ],
    ports: &[
        PortDescription::input("word", Width::Param("WIDTH"), "the whole number to load"),
        PortDescription::input("load", Width::BIT, "loads it"),
        PortDescription::input(
            "subtract",
            Width::Add(&Width::Param("FRACTION"), &Width::BIT),
            "count inputs, the least weight lowest",
        ),
        PortDescription::input("clear", Width::BIT, "sets the count to 0; wins over all else"),
        PortDescription::output("count", COUNT, "the content, with FRACTION fraction bits").signed(),
        PortDescription::output("overflow", Width::BIT, "the count has just passed below zero"),
    ],
    clocked: true,
};

fn build(b: &mut Builder) {
    let width = b.count("WIDTH") + b.count("FRACTION") + 1;
    let (word, load, clear) = (b.input("word"), b.input("load"), b.input("clear"));
    let count = b.hold(width, 0);

    let subtract = b.zero_extend(b.input("subtract"), width);
    let less = b.sub(count.q, subtract);
    let start = whole_number(b, word, width);
    let next = b.mux(load, start, less);

    let was_negative = b.sign(count.q);
    let is_negative = b.sign(next);
    let was_not = b.not(was_negative);
    let borrow = b.and(was_not, is_negative);
    let overflow = b.hold(1, 0);
    let overflow = b.load(overflow, borrow, None, clear);

    let count = b.load(count, next, None, clear);
    b.output("count", count);
    b.output("overflow", overflow);
}

/// `word` with zeros in its fraction digits and in the sign above it.
fn whole_number(b: &mut Builder, word: ValueId, width: u32) -> ValueId {
    let fraction = b.count("FRACTION");
    let word = if fraction == 0 {
        word
    } else {
        let zeros = b.constant(0, fraction);
        b.concat(word, zeros)
    };
    b.zero_extend(word, width)
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    fn loaded(word: i64) -> Bench {
        let mut bench = Bench::new("subtracting_counter", &[("WIDTH", 4), ("FRACTION", 3)]);
        bench.set_all(&[("word", word), ("load", 1)]);
        bench.tick();
        bench.set("load", 0);
        bench
    }

    #[test]
    fn each_input_counts_with_its_weight_and_several_at_once_all_count() {
        for pulses in 0..16 {
            let mut bench = loaded(9);
            assert_eq!(bench.get_signed("count"), 72, "nine whole steps in eighths");
            bench.set("subtract", pulses);
            bench.tick();
            let eighths: i64 = [1, 2, 4, 8].iter().enumerate().map(|(i, weight)| (pulses >> i & 1) * weight).sum();
            assert_eq!(bench.get_signed("count"), 72 - eighths);
        }
    }

    #[test]
    fn overflow_is_one_tick_and_comes_with_the_first_count_below_zero() {
        let mut bench = loaded(1);
        bench.set("subtract", 0b0010);
        let mut seen = Vec::new();
        for _ in 0..6 {
            seen.push((bench.get_signed("count"), bench.get("overflow")));
            bench.tick();
        }
        assert_eq!(seen, [(8, 0), (6, 0), (4, 0), (2, 0), (0, 0), (-2, 1)]);
        assert_eq!((bench.get_signed("count"), bench.get("overflow")), (-4, 0));
    }

    #[test]
    fn clear_wins_over_load_and_load_over_counting() {
        let mut bench = loaded(3);
        bench.set_all(&[("word", 5), ("load", 1), ("subtract", 8)]);
        bench.tick();
        assert_eq!(bench.get_signed("count"), 40);
        bench.set("clear", 1);
        bench.tick();
        assert_eq!(bench.get_signed("count"), 0);
    }

    #[test]
    fn a_clear_in_the_tick_of_the_borrow_leaves_no_overflow() {
        let mut bench = loaded(0);
        bench.set_all(&[("subtract", 1), ("clear", 1)]);
        bench.tick();
        assert_eq!((bench.get_signed("count"), bench.get("overflow")), (0, 0));
    }
}
