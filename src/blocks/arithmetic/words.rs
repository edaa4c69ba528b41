//! What the arithmetic blocks share: sums, the passage to a narrower word, clocking, the pace of digit-by-digit units.

use crate::base::ValueId;
use crate::blocks::Builder;

/// The low `width` bits of a two's-complement word, and one bit that is 1 when the number does not fit them.
pub(super) fn narrow(b: &mut Builder, word: ValueId, width: u32) -> (ValueId, ValueId) {
    let wide = b.width(word);
    if width >= wide {
        return (b.sign_extend(word, width), b.bit(false));
    }
    let above = b.slice(word, width - 1, wide - width + 1);
    let ones = b.reduce_and(above);
    let some = b.reduce_or(above);
    let none = b.not(some);
    let fits = b.or(ones, none);
    (b.slice(word, 0, width), b.not(fits))
}

/// Holds `word` and `overflow` from the strobe on: the module's clocking point.
pub(super) fn clocked(b: &mut Builder, (word, overflow): (ValueId, ValueId), output: &str) {
    let strobe = b.input("strobe");
    for (name, next) in [(output, word), ("overflow", overflow)] {
        let value = capture(b, next, strobe);
        b.output(name, value);
    }
}

/// A register that takes `value` when `when` is 1.
pub(super) fn capture(b: &mut Builder, value: ValueId, when: ValueId) -> ValueId {
    let held = b.hold(b.width(value), 0);
    b.load(held, value, when, None)
}

/// The word shifted left by the width of `low`, with `low` in the place made free.
pub(super) fn append(b: &mut Builder, word: ValueId, low: ValueId) -> ValueId {
    let shift = b.width(low);
    if b.width(word) == shift {
        return low;
    }
    let kept = b.slice(word, 0, b.width(word) - shift);
    b.concat(kept, low)
}

/// Counts the digits a digit-by-digit unit still wants: builds its output `ready`, and returns whether the unit is
/// clocked in this tick.
pub(super) fn digit_counter(b: &mut Builder, start: ValueId, digits: u32) -> ValueId {
    let bits = u64::BITS - u64::from(digits).leading_zeros();
    let left = b.hold(bits, 0);
    let ready = b.is(left.q, 0);
    b.output("ready", ready);
    let working = b.not(ready);
    let clocked = b.or(start, working);
    let one = b.constant(1, bits);
    let fewer = b.sub(left.q, one);
    let all = b.constant(digits.into(), bits);
    let next = b.mux(start, all, fewer);
    b.load(left, next, clocked, None);
    clocked
}
