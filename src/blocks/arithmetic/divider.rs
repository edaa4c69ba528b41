//! Divider: a clocked digit-by-digit unit, restoring, one quotient bit a tick.
//!
//! ```text
//!   remainder : work   <-  |numerator|, aligned so that the first quotient bit comes first
//!   each tick: shift (remainder : work) left; remainder >= |denominator|: subtract, quotient bit 1, otherwise 0;
//!   the bit enters work from the right. After WIDTH - 1 ticks work is the magnitude of the quotient.
//! ```

use super::words::{append, capture, digit_counter};
use crate::base::ValueId;
use crate::blocks::{Block, Builder, Description, Kind, Parameter, Parameters, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build).with_check(check);

static DESCRIPTION: Description = Description {
    name: "divider",
    kind: Kind::Arithmetic,
    summary: "Divides two's-complement words digit by digit, one quotient bit a tick.",
    doc: "A pulse at `start` takes both inputs (also while it works: it begins anew). `ready` is then 0 for WIDTH - 1 \
          ticks; from then on quotient = trunc(numerator * 2^FRACTION / denominator), truncated towards zero, so that \
          with fN and fD fraction bits the quotient has fN - fD + FRACTION. `overflow`, known one tick after `start` \
          and held, tells that the magnitude does not fit WIDTH - 1 bits, `zero_denominator` why, when that is the \
          reason; the quotient then means nothing.",
    source: "US 3,809,868, FIG. 3 and 5 to 7 (dividers 72, 120, 104, 154, 182, 206, 228, 230)",
    parameters: &[
        Parameter { name: "NUMERATOR_WIDTH", default: 32, min: 1, max: 62, doc: "bits of the numerator" },
        Parameter { name: "DENOMINATOR_WIDTH", default: 32, min: 1, max: 62, doc: "bits of the denominator" },
        Parameter { name: "FRACTION", default: 0, min: 0, max: 62, doc: "bits the numerator is shifted left by" },
        Parameter { name: "WIDTH", default: 33, min: 2, max: 63, doc: "bits of the quotient with its sign" },
    ],
    ports: &[
        PortDescription::input("start", Width::BIT, "takes the inputs and begins"),
        PortDescription::input("numerator", Width::Param("NUMERATOR_WIDTH"), "what is divided").signed(),
        PortDescription::input("denominator", Width::Param("DENOMINATOR_WIDTH"), "by what it is divided").signed(),
        PortDescription::output("quotient", Width::Param("WIDTH"), "the quotient, once ready").signed(),
        PortDescription::output("ready", Width::BIT, "0 while it works"),
        PortDescription::output("zero_denominator", Width::BIT, "the denominator was 0"),
        PortDescription::output("overflow", Width::BIT, "the quotient does not fit"),
    ],
    clocked: true,
};

fn check(parameters: &Parameters) -> Result<(), String> {
    let (digits, fraction) = (parameters.get("WIDTH") - 1, parameters.get("FRACTION"));
    if fraction > digits {
        return Err(format!("FRACTION is {fraction}, but the quotient has {digits} bits and a sign: widen WIDTH"));
    }
    Ok(())
}

fn build(b: &mut Builder) {
    let digits = b.count("WIDTH") - 1;
    let start = b.input("start");
    let (numerator, denominator) = (b.input("numerator"), b.input("denominator"));
    let (dividend, minus_n) = magnitude(b, numerator);
    let (divisor, minus_d) = magnitude(b, denominator);
    let (high, low) = split(b, dividend, digits);
    let width = b.width(high).max(b.width(divisor)) + 1;
    let (high, divisor) = (b.zero_extend(high, width), b.zero_extend(divisor, width));

    let zero = b.is(divisor, 0);
    let fits = b.less(high, divisor);
    let overflow = b.not(fits);
    let minus = b.xor(minus_n, minus_d);
    let [zero, overflow, minus] = [zero, overflow, minus].map(|flag| capture(b, flag, start));
    let divisor = capture(b, divisor, start);
    let work = digit_loop(b, start, [high, low], divisor, digits);

    let magnitude = b.zero_extend(work, digits + 1);
    let negated = b.negate(magnitude);
    let quotient = b.mux(minus, negated, magnitude);
    b.output("quotient", quotient);
    b.output("zero_denominator", zero);
    b.output("overflow", overflow);
}

/// The magnitude of a two's-complement word in as many bits, and its sign.
fn magnitude(b: &mut Builder, word: ValueId) -> (ValueId, ValueId) {
    let (minus, negated) = (b.sign(word), b.negate(word));
    (b.mux(minus, negated, word), minus)
}

/// The dividend times 2^FRACTION, cut into its `digits` low bits and those above, at least one.
fn split(b: &mut Builder, dividend: ValueId, digits: u32) -> (ValueId, ValueId) {
    let fraction = b.count("FRACTION");
    let (below, width) = (digits - fraction, b.width(dividend));
    let taken = below.min(width);
    let high = if width > below { b.slice(dividend, below, width - below) } else { b.bit(false) };
    if below == 0 {
        return (high, b.constant(0, digits));
    }
    let low = b.slice(dividend, 0, taken);
    let low = b.zero_extend(low, digits);
    let shift = b.constant(fraction.into(), 6);
    (high, b.shift_left(low, shift))
}

/// The digits themselves: returns the work register.
fn digit_loop(b: &mut Builder, start: ValueId, [high, low]: [ValueId; 2], divisor: ValueId, digits: u32) -> ValueId {
    let clocked = digit_counter(b, start, digits);
    let (remainder, work) = (b.hold(b.width(divisor), 0), b.hold(digits, 0));
    let top = b.sign(work.q);
    let shifted = append(b, remainder.q, top);
    let too_small = b.less(shifted, divisor);
    let digit = b.not(too_small);
    let reduced = b.sub(shifted, divisor);
    let restored = b.mux(digit, reduced, shifted);
    let next = b.mux(start, high, restored);
    b.load(remainder, next, clocked, None);
    let grown = append(b, work.q, digit);
    let next = b.mux(start, low, grown);
    b.load(work, next, clocked, None);
    b.name("remainder", remainder.q);
    b.name("work", work.q)
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    /// Starts a division and waits; returns quotient, zero_denominator, overflow and the ticks it took.
    fn divide(bench: &mut Bench, numerator: i64, denominator: i64) -> (i64, u64, u64, u32) {
        bench.set_all(&[("numerator", numerator), ("denominator", denominator), ("start", 1)]);
        bench.tick();
        bench.set_all(&[("numerator", 0), ("denominator", 0), ("start", 0)]);
        let mut ticks = 0;
        while bench.get("ready") == 0 {
            bench.tick();
            ticks += 1;
        }
        (bench.get_signed("quotient"), bench.get("zero_denominator"), bench.get("overflow"), ticks)
    }

    #[test]
    fn every_small_quotient_is_right_and_every_other_one_flagged() {
        let widths = [("NUMERATOR_WIDTH", 7), ("DENOMINATOR_WIDTH", 5), ("FRACTION", 3), ("WIDTH", 7)];
        let mut bench = Bench::new("divider", &widths);
        for numerator in -64..64 {
            for denominator in -16..16 {
                let (quotient, zero, overflow, ticks) = divide(&mut bench, numerator, denominator);
                assert_eq!((zero == 1, ticks), (denominator == 0, 6));
                // Integer division of Rust truncates towards zero.
                let truth = (numerator * 8).checked_div(denominator).filter(|quotient| quotient.abs() < 64);
                assert_eq!(overflow == 1, truth.is_none(), "{numerator} / {denominator}");
                assert!(truth.is_none_or(|truth| truth == quotient), "{numerator} / {denominator}");
            }
        }
    }

    #[test]
    fn words_of_unlike_widths_divide_too() {
        for (n, d, fraction, width) in
            [(3, 20, 10, 12), (50, 33, 24, 40), (50, 50, 30, 31), (62, 3, 0, 63), (4, 4, 0, 9)]
        {
            let widths = [("NUMERATOR_WIDTH", n), ("DENOMINATOR_WIDTH", d), ("FRACTION", fraction), ("WIDTH", width)];
            let mut bench = Bench::new("divider", &widths);
            let (n_end, d_end, end) = (1_i64 << (n - 1), 1_i64 << (d - 1), 1_i128 << (width - 1));
            for numerator in [-n_end, -n_end / 3, -1, 0, 1, n_end / 7, n_end - 1] {
                for denominator in [-d_end, -d_end / 3 - 1, -1, 1, d_end / 2, d_end - 1] {
                    let truth = (i128::from(numerator) << fraction) / i128::from(denominator);
                    let (quotient, _, overflow, _) = divide(&mut bench, numerator, denominator);
                    assert_eq!(overflow == 1, truth.abs() >= end, "{numerator} / {denominator}");
                    assert!(overflow == 1 || i128::from(quotient) == truth, "{numerator} / {denominator}");
                }
            }
        }
    }

    #[test]
    fn a_start_while_it_works_begins_anew() {
        let mut bench = Bench::new("divider", &[]);
        bench.set_all(&[("numerator", 1000), ("denominator", 10), ("start", 1)]);
        (0..5).for_each(|_| bench.tick());
        assert_eq!(divide(&mut bench, 84, 2), (42, 0, 0, 32));
    }
}
