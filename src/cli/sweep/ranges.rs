//! `NAME=RANGE`: the values an input takes, one after another.

use std::fmt;

use crate::scenario::Number;

/// An input and the values it takes.
#[derive(Clone, PartialEq, Debug)]
pub struct Over {
    /// The input's name.
    pub name: String,
    /// Its values, run after run.
    pub spans: Vec<Span>,
}

/// Some values in a row.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Span {
    /// One value.
    One(Number),
    /// `first`, `first + step`, and so on.
    Range {
        /// The first value.
        first: i128,
        /// How far from one to the next.
        step: i128,
        /// How many.
        count: u64,
    },
}

impl Span {
    /// How many values.
    pub fn count(&self) -> u64 {
        match self {
            Span::One(_) => 1,
            Span::Range { count, .. } => *count,
        }
    }

    /// The `i`-th value.
    pub fn value(&self, i: u64) -> Number {
        match *self {
            Span::One(number) => number,
            Span::Range { first, step, .. } => Number::Word(first + step * i128::from(i)),
        }
    }
}

impl Over {
    /// Reads `NAME=RANGE`: a list of numbers and of ranges `a..b`, `a..=b`, with `:s` for every `s`-th value.
    ///
    /// # Errors
    /// A sentence that says what was expected.
    pub fn parse(text: &str) -> Result<Self, String> {
        let (name, values) = text.split_once('=').ok_or("expected NAME=RANGE, as in x=0..10")?;
        let spans = values.split(',').map(|item| span(item.trim())).collect::<Result<_, _>>()?;
        Ok(Self { name: name.trim().to_owned(), spans })
    }

    /// How many values, if that can be counted.
    pub fn count(&self) -> Option<u64> {
        self.spans.iter().try_fold(0_u64, |sum, span| sum.checked_add(span.count()))
    }

    /// The `i`-th value.
    pub fn value(&self, mut i: u64) -> Option<Number> {
        for span in &self.spans {
            if i < span.count() {
                return Some(span.value(i));
            }
            i -= span.count();
        }
        None
    }
}

impl fmt::Display for Over {
    /// As it could have been typed.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, span) in self.spans.iter().enumerate() {
            let before = if i == 0 { format!("{}=", self.name) } else { ",".to_owned() };
            match *span {
                Span::One(number) => write!(f, "{before}{number}")?,
                Span::Range { first, step, count } => {
                    write!(f, "{before}{first}..={}:{step}", first + step * i128::from(count - 1))?;
                }
            }
        }
        Ok(())
    }
}

fn span(item: &str) -> Result<Span, String> {
    let Some((first, rest)) = item.split_once("..") else { return Number::parse(item).map(Span::One) };
    let (last, step) = rest.split_once(':').unwrap_or((rest, "1"));
    let (last, is_inclusive) = last.strip_prefix('=').map_or((last, false), |last| (last, true));
    let (first, last, step) = (whole(first)?, whole(last)?, whole(step)?);
    if step <= 0 {
        return Err(format!("the step of `{item}` must be at least 1"));
    }
    let end = last + i128::from(is_inclusive);
    if end <= first {
        let hint = if end == first { format!("; write {first}..={first} for that one value") } else { String::new() };
        return Err(format!("the range `{item}` is empty{hint}"));
    }
    let count = (end - first + step - 1) / step;
    let count = u64::try_from(count).map_err(|_| format!("the range `{item}` has too many values"))?;
    Ok(Span::Range { first, step, count })
}

fn whole(text: &str) -> Result<i128, String> {
    match Number::parse(text.trim())? {
        Number::Word(value) => Ok(value),
        Number::Real(_) => {
            Err(format!("`{text}` is not a whole number; ranges are of words, lists may be of real numbers"))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn values(text: &str) -> Vec<Number> {
        let over = Over::parse(text).expect("a range");
        (0..over.count().expect("countable")).map(|i| over.value(i).expect("a value")).collect()
    }

    fn words(words: &[i128]) -> Vec<Number> {
        words.iter().copied().map(Number::Word).collect()
    }

    #[test]
    fn two_dots_end_before_and_two_dots_equal_with_the_last_value() {
        assert_eq!(values("x=2..5"), words(&[2, 3, 4]));
        assert_eq!(values("x=2..=5"), words(&[2, 3, 4, 5]));
        assert_eq!(values("x=-1..=0x2:2"), words(&[-1, 1]));
        assert_eq!(values("x=0..=10:5"), words(&[0, 5, 10]));
        assert_eq!(values("x=0..10:5"), words(&[0, 5]));
    }

    #[test]
    fn lists_mix_numbers_and_ranges() {
        assert_eq!(values("x=7,1..3, -4"), words(&[7, 1, 2, -4]));
        assert_eq!(values("x=0.5"), [Number::Real(0.5)]);
    }

    #[test]
    fn what_is_shown_takes_the_same_values() {
        for text in ["x=7,1..3,-4", "x=0..=10:5", "x=0..10:5", "x=0.5,1.0"] {
            assert_eq!(values(&Over::parse(text).expect("a range").to_string()), values(text), "{text}");
        }
    }

    #[test]
    fn nonsense_is_refused_in_words() {
        for (text, said) in [("x", "NAME=RANGE"), ("x=3..3", "3..=3"), ("x=3..1", "empty"), ("x=0..9:0", "at least 1")]
        {
            let error = Over::parse(text).expect_err(text);
            assert!(error.contains(said), "{text}: {error}");
        }
        assert!(Over::parse("x=0.5..2").is_err());
        assert!(Over::parse("x=1,,2").is_err());
    }

    #[test]
    fn the_widest_range_counts_without_overflow() {
        assert_eq!(Over::parse("x=0..0xFFFFFFFFFFFFFFFF").expect("a range").count(), Some(u64::MAX));
        assert!(Over::parse("x=-18446744073709551615..=18446744073709551615").is_err());
        assert_eq!(Over::parse("x=0..0xFFFFFFFFFFFFFFFF,1").expect("a list").count(), None);
    }
}
