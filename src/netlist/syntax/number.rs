//! Numbers: decimal, or with a base and perhaps a size (IEEE 1364-2005, 3.5.1), in two-state logic.

use crate::base::word::{MAX_WIDTH, mask, of_letters};

/// A number as written.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(in crate::netlist) struct Literal {
    pub(in crate::netlist) value: u64,
    /// The size, when it is written.
    pub(in crate::netlist) width: Option<u32>,
    pub(in crate::netlist) signed: bool,
}

/// Why a number is refused, and what to write.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Refused {
    pub(super) message: String,
    pub(super) help: String,
}

fn refused<T>(message: impl Into<String>, help: impl Into<String>) -> Result<T, Refused> {
    Err(Refused { message: message.into(), help: help.into() })
}

/// Reads a decimal number without a base: signed, 32 bits.
pub(super) fn plain(digits: &str) -> Result<Literal, Refused> {
    let value = value_of(digits, 10)?;
    if value > i64::from(i32::MAX).unsigned_abs() {
        return refused(
            format!("the number {value} is beyond the 32 bits of a number without a size"),
            format!("give it a size: `64'd{value}`"),
        );
    }
    Ok(Literal { value, width: None, signed: true })
}

/// Reads `[size] ' [s] base digits`; the parts come without the quote and without white space between them.
pub(super) fn based(size: Option<&str>, signed: bool, base: char, digits: &str) -> Result<Literal, Refused> {
    let width = size.map(width_of).transpose()?;
    let radix = match base.to_ascii_lowercase() {
        'b' => 2,
        'o' => 8,
        'd' => 10,
        _ => 16,
    };
    let value = value_of(digits, radix)?;
    let room = width.unwrap_or(32);
    if value & !mask(room) != 0 {
        let needed = u64::BITS - value.leading_zeros();
        return refused(
            format!("this number needs {needed} bits, but has {room}"),
            format!("write the size {needed}, or a smaller number"),
        );
    }
    Ok(Literal { value, width, signed })
}

/// Reads a string, quotes included.
pub(super) fn string(token: &str) -> Result<Literal, Refused> {
    let letters = token.strip_prefix('"').and_then(|token| token.strip_suffix('"')).unwrap_or_default();
    match of_letters(letters) {
        Some(value) => Ok(Literal { value, width: Some(8 * letters.len() as u32), signed: false }),
        None => refused(
            "this string is no number of 64 bits",
            "a string is a number here, 8 bits a letter: 1 to 8 letters, digits or signs of ASCII",
        ),
    }
}

fn width_of(size: &str) -> Result<u32, Refused> {
    let width = value_of(size, 10).ok().and_then(|width| u32::try_from(width).ok());
    match width {
        Some(width) if (1..=MAX_WIDTH).contains(&width) => Ok(width),
        _ => refused("a number of no bits or too many", "a size is 1 to 64"),
    }
}

fn value_of(digits: &str, radix: u32) -> Result<u64, Refused> {
    let mut value: u64 = 0;
    for digit in digits.chars().filter(|&digit| digit != '_') {
        if matches!(digit, 'x' | 'X' | 'z' | 'Z' | '?') {
            return refused(
                format!("the digit `{digit}` is neither 0 nor 1"),
                "the logic here has two states: write a number of 0s and 1s",
            );
        }
        let Some(digit) = digit.to_digit(radix) else {
            return refused(format!("`{digit}` is no digit of base {radix}"), "the bases are 'b, 'o, 'd and 'h");
        };
        let next = value.checked_mul(u64::from(radix)).and_then(|v| v.checked_add(u64::from(digit)));
        let Some(next) = next else {
            return refused(
                "this number is beyond 64 bits",
                "words have at most 64 bits: put wider ones together with `{ }`",
            );
        };
        value = next;
    }
    Ok(value)
}
