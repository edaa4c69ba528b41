//! Square rooter: a clocked digit-by-digit unit, restoring, one bit of the root a tick.
//!
//! ```text
//!   each tick: remainder := 4 remainder + the next two bits of the radicand
//!              remainder >= 4 root + 1: subtract that, root := 2 root + 1; otherwise root := 2 root
//! ```

use super::words::{append, capture, digit_counter};
use crate::base::ValueId;
use crate::blocks::{Block, Builder, Description, Kind, Parameter, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "square_rooter",
    kind: Kind::Arithmetic,
    summary: "Extracts a square root digit by digit, one bit a tick.",
    doc: "A pulse at `start` takes the radicand (also while it works: it begins anew). `ready` is then 0 for PAIRS + \
          EXTRA ticks; from then on root = floor(sqrt(radicand) * 2^EXTRA), so that with 2f fraction bits in the \
          radicand the root has f + EXTRA. `negative`, known one tick after `start` and held, tells that the radicand \
          was negative; the root then means nothing.",
    source: "US 3,809,868, FIG. 5 to 7 (square-root circuits 116, 192, 216)",
    parameters: &[
        Parameter { name: "PAIRS", default: 16, min: 1, max: 31, doc: "pairs of bits of the radicand below its sign" },
        Parameter { name: "EXTRA", default: 0, min: 0, max: 30, doc: "further bits of the root" },
    ],
    ports: &[
        PortDescription::input("start", Width::BIT, "takes the radicand and begins"),
        PortDescription::input(
            "radicand",
            Width::Add(&Width::Mul(&Width::Fixed(2), &Width::Param("PAIRS")), &Width::Fixed(1)),
            "whose root is wanted",
        )
        .signed(),
        PortDescription::output("root", Width::Add(&Width::Param("PAIRS"), &Width::Param("EXTRA")), "once ready"),
        PortDescription::output("ready", Width::BIT, "0 while it works"),
        PortDescription::output("negative", Width::BIT, "the radicand was negative"),
    ],
    clocked: true,
};

fn build(b: &mut Builder) {
    let (pairs, digits) = (b.count("PAIRS"), b.count("PAIRS") + b.count("EXTRA"));
    let (start, radicand) = (b.input("start"), b.input("radicand"));
    let sign = b.sign(radicand);
    let negative = capture(b, sign, start);
    b.output("negative", negative);

    let clocked = digit_counter(b, start, digits);
    let rest = b.hold(2 * pairs, 0);
    let (taken, zeros) = (b.slice(radicand, 0, 2 * pairs), b.constant(0, 2));
    let pair = b.slice(rest.q, 2 * pairs - 2, 2);
    let shifted = append(b, rest.q, zeros);
    let next = b.mux(start, taken, shifted);
    b.load(rest, next, clocked, None);

    let root = root_registers(b, start, clocked, pair, digits);
    b.output("root", root);
}

/// Remainder and root; returns the root.
fn root_registers(b: &mut Builder, start: ValueId, clocked: ValueId, pair: ValueId, digits: u32) -> ValueId {
    let not_start = b.not(start);
    let (root, remainder) = (b.hold(digits, 0), b.hold(digits + 2, 0));
    let grown = append(b, remainder.q, pair);
    let one = b.constant(1, 2);
    let trial = b.concat(root.q, one);
    let too_small = b.less(grown, trial);
    let digit = b.not(too_small);
    let reduced = b.sub(grown, trial);
    let restored = b.mux(digit, reduced, grown);
    let next = b.gate(not_start, restored);
    b.load(remainder, next, clocked, None);
    let longer = append(b, root.q, digit);
    let next = b.gate(not_start, longer);
    b.load(root, next, clocked, None);
    b.name("remainder", remainder.q);
    root.q
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    fn root_of(bench: &mut Bench, radicand: i64) -> (u64, u64, u32) {
        bench.set_all(&[("radicand", radicand), ("start", 1)]);
        bench.tick();
        bench.set_all(&[("radicand", 0), ("start", 0)]);
        let mut ticks = 0;
        while bench.get("ready") == 0 {
            bench.tick();
            ticks += 1;
        }
        (bench.get("root"), bench.get("negative"), ticks)
    }

    /// What the root is by definition: the largest whole number whose square is not above.
    fn is_root(root: u64, radicand: u128) -> bool {
        let root = u128::from(root);
        root * root <= radicand && radicand < (root + 1) * (root + 1)
    }

    #[test]
    fn every_small_root_is_the_largest_whose_square_is_not_above() {
        let mut bench = Bench::new("square_rooter", &[("PAIRS", 5), ("EXTRA", 2)]);
        for radicand in 0..1024 {
            let (root, negative, ticks) = root_of(&mut bench, radicand);
            assert!(is_root(root, (radicand as u128) << 4), "{radicand}");
            assert_eq!((negative, ticks), (0, 7));
        }
    }

    #[test]
    fn a_negative_radicand_is_flagged_and_the_next_one_is_not() {
        let mut bench = Bench::new("square_rooter", &[("PAIRS", 5)]);
        for (radicand, negative) in [(-1, 1), (0, 0), (-1024, 1), (1023, 0)] {
            assert_eq!(root_of(&mut bench, radicand).1, negative, "{radicand}");
        }
    }

    #[test]
    fn long_words_have_roots_too() {
        for (pairs, extra) in [(31, 0), (30, 0), (21, 14), (1, 30), (1, 0)] {
            let mut bench = Bench::new("square_rooter", &[("PAIRS", pairs), ("EXTRA", extra)]);
            let end = 1_i64 << (2 * pairs);
            for radicand in [0, 1, 2, 3, end / 3, end / 2 + 1, end - 2, end - 1].into_iter().filter(|&r| r < end) {
                let root = root_of(&mut bench, radicand).0;
                assert!(is_root(root, (radicand as u128) << (2 * extra)), "{radicand} with {extra} further bits");
            }
        }
    }
}
