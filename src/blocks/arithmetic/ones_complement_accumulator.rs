//! One's-complement accumulator: an adding register whose carry out of the top digit comes back in at the bottom.
//!
//! ```text
//!   first  --+
//!            OR--> [ + ]---> [ sum ]--+--> sum, sign
//!   second --+      ^ |               |
//!                   | +--carry--+     |
//!                   +--<--------+-----+
//! ```

use crate::base::ValueId;
use crate::blocks::{Block, Builder, Description, Kind, Parameter, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "ones_complement_accumulator",
    kind: Kind::Arithmetic,
    summary: "Adds words in true or inverted code to its content, with end-around carry.",
    doc: "sum(t+1) = clear ? 0 : sum (+) (first | second), where (+) adds the carry out of the top digit back in at \
          the bottom: one's complement, so that a word is subtracted by adding its inverse. An operand is given for \
          one tick and is 0 at all others; the two share the adder's input, so at most one may be given in a tick.\n\
          The top digit is the sign. A number plus its inverse is all ones, and no digit then makes a carry: with \
          MINUS_ZERO = 0 the ring settles with a carry, and the result is plus zero (sign 0); with MINUS_ZERO = 1 it \
          settles without, and the result is minus zero, whose sign is 1. `value` is the content as a \
          two's-complement number (0 for either zero).",
    source: "SU 1522157, adder 1 of FIG. 1",
    parameters: &[
        Parameter { name: "WIDTH", default: 16, min: 2, max: 64, doc: "bits of the content, sign included" },
        Parameter { name: "MINUS_ZERO", default: 0, min: 0, max: 1, doc: "1: a + ~a is minus zero; 0: plus zero" },
    ],
    ports: &[
        PortDescription::input("first", Width::Param("WIDTH"), "first operand, 0 when none is given"),
        PortDescription::input("second", Width::Param("WIDTH"), "second operand, 0 when none is given"),
        PortDescription::input("clear", Width::BIT, "sets the content to plus zero; wins over the operands"),
        PortDescription::output("sum", Width::Param("WIDTH"), "the content in one's complement"),
        PortDescription::output("value", Width::Param("WIDTH"), "the content as a two's-complement number").signed(),
        PortDescription::output("sign", Width::BIT, "top digit of the content"),
        PortDescription::output("sign_inverse", Width::BIT, "its complement"),
    ],
    clocked: true,
};

fn build(b: &mut Builder) {
    let width = b.count("WIDTH");
    let sum = b.hold(width, 0);
    let (first, second, clear) = (b.input("first"), b.input("second"), b.input("clear"));
    let operand = b.or(first, second);
    let operand = b.name("operand", operand);
    let next = add_around(b, sum.q, operand);
    let sum = b.load(sum, next, None, clear);
    let sign = b.sign(sum);
    let sign_inverse = b.not(sign);
    let negative = b.zero_extend(sign, width);
    let value = b.add(sum, negative);
    b.output("sum", sum);
    b.output("value", value);
    b.output("sign", sign);
    b.output("sign_inverse", sign_inverse);
}

/// The one's-complement sum of two words.
fn add_around(b: &mut Builder, augend: ValueId, addend: ValueId) -> ValueId {
    let sum = b.add(augend, addend);
    // A sum that wrapped round is less than either operand.
    let mut carry = b.less(sum, augend);
    if b.param("MINUS_ZERO") == 0 {
        let every_digit_passes_a_carry_on = b.reduce_and(sum);
        carry = b.or(carry, every_digit_passes_a_carry_on);
    }
    let carry = b.name("end_around_carry", carry);
    let carry = b.zero_extend(carry, b.width(sum));
    b.add(sum, carry)
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    const WIDTH: i64 = 5;
    const LIMIT: i64 = 15;

    /// The one's-complement word of a number.
    fn word(number: i64) -> i64 {
        if number < 0 { !-number & 31 } else { number }
    }

    /// An accumulator that holds `number`.
    fn holding(number: i64, minus_zero: i64) -> Bench {
        let mut bench = Bench::new("ones_complement_accumulator", &[("WIDTH", WIDTH), ("MINUS_ZERO", minus_zero)]);
        bench.set("first", word(number));
        bench.tick();
        bench
    }

    #[test]
    fn every_sum_within_the_range_is_the_sum_of_the_numbers() {
        for minus_zero in [0, 1] {
            for a in -LIMIT..=LIMIT {
                for b in (-LIMIT..=LIMIT).filter(|b| (a + b).abs() <= LIMIT) {
                    let mut bench = holding(a, minus_zero);
                    bench.set_all(&[("first", 0), ("second", word(b))]);
                    bench.tick();
                    assert_eq!(bench.get_signed("value"), a + b, "{a} + {b}");
                    let negative = a + b < 0 || minus_zero == 1 && a + b == 0 && a != 0;
                    assert_eq!(bench.get("sign"), u64::from(negative), "sign of {a} + {b}");
                    assert_eq!(bench.get("sign_inverse"), u64::from(!negative));
                }
            }
        }
    }

    #[test]
    fn a_number_plus_its_inverse_is_plus_zero_or_minus_zero_as_chosen() {
        for (minus_zero, zero) in [(0, 0b00000), (1, 0b11111)] {
            for a in 0..=LIMIT {
                let mut bench = holding(a, minus_zero);
                bench.set_all(&[("first", 0), ("second", !a & 31)]);
                bench.tick();
                assert_eq!((bench.get("sum"), bench.get_signed("value")), (zero, 0), "{a} - {a}");
            }
        }
    }

    #[test]
    fn clear_wins_over_an_operand() {
        let mut bench = holding(9, 0);
        bench.set("clear", 1);
        bench.tick();
        assert_eq!(bench.get("sum"), 0);
    }
}
