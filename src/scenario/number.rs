//! Numbers as people write them for a port: whole words, or real numbers for fixed-point ports.

use std::fmt;
use std::num::IntErrorKind;

use crate::base::word;

/// A number to be put on a port.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Number {
    /// A whole number: the word itself, also on a fixed-point port.
    Word(i128),
    /// A real number (written with a point or an exponent), for fixed-point ports.
    Real(f64),
}

impl Number {
    /// Reads decimal (also negative), `0x..`, `0b..`, or a real number such as `-0.5` or `1e-3`.
    ///
    /// # Errors
    /// A sentence that says what was expected.
    ///
    /// ```
    /// use stepwright::scenario::Number;
    /// assert_eq!(Number::parse("0x1f"), Ok(Number::Word(31)));
    /// assert_eq!(Number::parse("-12"), Ok(Number::Word(-12)));
    /// assert_eq!(Number::parse("0.5"), Ok(Number::Real(0.5)));
    /// assert!(Number::parse("twelve").is_err());
    /// ```
    pub fn parse(text: &str) -> Result<Self, String> {
        let expected = || format!("`{text}` is not a number: write decimal, 0x.., 0b.., or a real number such as 0.5");
        let (negative, digits) = match text.strip_prefix('-') {
            Some(rest) => (true, rest),
            None => (false, text.strip_prefix('+').unwrap_or(text)),
        };
        if digits.starts_with(['+', '-']) {
            return Err(expected());
        }
        let plain = digits.replace('_', "");
        let (radix, whole) = match plain.get(..2) {
            Some("0x" | "0X") => (16, &plain[2..]),
            Some("0b" | "0B") => (2, &plain[2..]),
            _ => (10, &plain[..]),
        };
        // A sign may stand before the base only.
        let whole = Some(whole).filter(|whole| !whole.starts_with(['+', '-']));
        let largest = if radix == 10 && plain.contains(['.', 'e', 'E']) {
            match plain.parse::<f64>() {
                Ok(real) if real.is_finite() => return Ok(Number::Real(if negative { -real } else { real })),
                Ok(_) => format!("real number is {:e}", f64::MAX),
                Err(_) => return Err(expected()),
            }
        } else {
            match whole.map(|whole| u64::from_str_radix(whole, radix)) {
                Some(Ok(whole)) => return Ok(Number::Word(if negative { -i128::from(whole) } else { whole.into() })),
                Some(Err(error)) if *error.kind() == IntErrorKind::PosOverflow => {
                    format!("whole number is {}", u64::MAX)
                }
                _ => return Err(expected()),
            }
        };
        Err(format!("`{text}` does not fit: the largest {largest}"))
    }

    /// The number itself.
    #[must_use]
    pub fn to_f64(self) -> f64 {
        match self {
            Number::Word(value) => value as f64,
            Number::Real(value) => value,
        }
    }

    /// The word of `width` bits that stands for this number; a real number is rounded to the nearest word,
    /// halves away from zero.
    ///
    /// # Errors
    /// A sentence that says what fits.
    pub fn encode(self, width: u32, signed: bool, fraction: Option<u32>) -> Result<u64, String> {
        let value = match (self, fraction) {
            (Number::Word(value), _) => value,
            (Number::Real(real), Some(fraction)) => (real * 2f64.powi(fraction as i32)).round() as i128,
            (Number::Real(_), None) => {
                return Err(format!("{self} is a real number, but the port holds whole numbers"));
            }
        };
        word::encode(value, width, signed).ok_or_else(|| {
            let (low, high) = word::range(width, signed);
            let kind = if signed { "signed" } else { "unsigned" };
            let reals = fraction.map_or_else(String::new, |fraction| {
                let unit = 2f64.powi(fraction as i32);
                format!(" (as real numbers {} to {})", low as f64 / unit, high as f64 / unit)
            });
            format!("{self} does not fit {width} {kind} bits, which hold {low} to {high}{reals}")
        })
    }
}

impl From<i32> for Number {
    fn from(value: i32) -> Self {
        Number::Word(value.into())
    }
}

impl From<i64> for Number {
    fn from(value: i64) -> Self {
        Number::Word(value.into())
    }
}

impl From<f64> for Number {
    fn from(value: f64) -> Self {
        Number::Real(value)
    }
}

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Number::Word(value) => write!(f, "{value}"),
            Number::Real(value) => write!(f, "{value:?}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn real_numbers_round_to_the_nearest_word() {
        let slope = |text: &str| Number::parse(text).unwrap().encode(32, true, Some(18)).unwrap();
        assert_eq!(slope("0.5"), 1 << 17);
        assert_eq!(slope("-1.0"), 0xFFFC_0000);
        assert_eq!(slope("0.4"), 104_858); // 104857.6
    }

    #[test]
    fn a_number_that_does_not_fit_is_refused_and_never_cut() {
        for (text, width, signed) in [("5000", 12, false), ("-1", 12, false), ("32768", 16, true), ("-32769", 16, true)]
        {
            assert!(Number::parse(text).unwrap().encode(width, signed, None).is_err(), "{text}");
        }
        assert!(Number::Real(8192.0).encode(32, true, Some(18)).is_err());
        assert!(Number::Real(1e300).encode(32, true, Some(18)).is_err());
        assert!(Number::Real(1.0).encode(32, true, None).is_err());
        assert_eq!(Number::Word(-32768).encode(16, true, None), Ok(0x8000));
    }

    #[test]
    fn a_number_that_is_too_large_is_called_so() {
        for text in ["18446744073709551616", "-99999999999999999999", "0x10000000000000000", "1e400", "-1.0e999"] {
            let said = Number::parse(text).expect_err(text);
            assert!(said.contains("does not fit"), "{said}");
        }
        assert_eq!(Number::parse("99999999999999999999.5"), Ok(Number::Real(1e20)));
    }

    #[test]
    fn what_is_no_number_is_refused() {
        for text in ["", "-", "--1", "0x", "0xg", "0b2", "1.2.3", "inf", "nan", "-+1", "0x+1", "0x-1", "0b+1", "e", "."]
        {
            assert!(Number::parse(text).is_err(), "{text}");
        }
    }
}
