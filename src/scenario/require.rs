//! What inputs have to satisfy: comparisons between inputs and whole numbers, such as `minor_34 <= major_32`.

use std::fmt;

/// A comparison. `I` is how an input is named: by its name, or by its place once that is found.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Requirement<I = String> {
    /// What stands on the left.
    pub left: Term<I>,
    /// How the two compare.
    pub comparison: Comparison,
    /// What stands on the right.
    pub right: Term<I>,
}

/// One side of a comparison.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Term<I> {
    /// The whole number on an input; on a fixed-point port, its word.
    Input(I),
    /// A number.
    Number(i128),
}

/// How two numbers compare.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Comparison {
    /// `<`
    Less,
    /// `<=`
    AtMost,
    /// `>`
    More,
    /// `>=`
    AtLeast,
    /// `==`
    Equal,
    /// `!=`
    Different,
}

impl Comparison {
    /// All of them, each before any whose sign it begins with.
    const ALL: [Self; 6] = [Self::AtMost, Self::AtLeast, Self::Equal, Self::Different, Self::Less, Self::More];

    fn sign(self) -> &'static str {
        match self {
            Self::Less => "<",
            Self::AtMost => "<=",
            Self::More => ">",
            Self::AtLeast => ">=",
            Self::Equal => "==",
            Self::Different => "!=",
        }
    }
}

impl Requirement {
    /// Reads two inputs, or an input and a whole number, with one of `< <= > >= == !=` between them.
    ///
    /// # Errors
    /// A sentence that says what was expected.
    ///
    /// ```
    /// use stepwright::scenario::Requirement;
    /// assert_eq!(Requirement::parse("x<=-3").unwrap().to_string(), "x <= -3");
    /// assert!(Requirement::parse("x + 1 < y").is_err());
    /// ```
    pub fn parse(text: &str) -> Result<Self, String> {
        let parts = |comparison: Comparison| Some((text.split_once(comparison.sign())?, comparison));
        let Some(((left, right), comparison)) = Comparison::ALL.into_iter().find_map(parts) else {
            return Err(format!("`{text}` compares nothing: write two terms with < <= > >= == or != between them"));
        };
        Ok(Self { left: term(left)?, comparison, right: term(right)? })
    }
}

fn term(text: &str) -> Result<Term<String>, String> {
    let text = text.trim();
    if let Ok(number) = text.parse::<i64>() {
        return Ok(Term::Number(number.into()));
    }
    let is_name = text.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_')
        && text.chars().all(|c| c.is_ascii_alphanumeric() || "_$".contains(c));
    is_name.then(|| Term::Input(text.to_owned())).ok_or_else(|| {
        format!("`{text}` is neither the name of an input nor a whole number, and nothing is computed here")
    })
}

impl<I> Requirement<I> {
    /// The inputs in it.
    pub fn inputs(&self) -> impl Iterator<Item = &I> {
        [&self.left, &self.right].into_iter().filter_map(|term| match term {
            Term::Input(input) => Some(input),
            Term::Number(_) => None,
        })
    }

    /// The same comparison with inputs named in another way.
    pub fn map<J>(&self, mut name: impl FnMut(&I) -> J) -> Requirement<J> {
        let mut term = |term: &Term<I>| match term {
            Term::Input(input) => Term::Input(name(input)),
            Term::Number(number) => Term::Number(*number),
        };
        Requirement { left: term(&self.left), comparison: self.comparison, right: term(&self.right) }
    }

    /// Whether it holds for these numbers on the inputs.
    pub fn holds(&self, number: impl Fn(&I) -> i128) -> bool {
        let of = |term: &Term<I>| match term {
            Term::Input(input) => number(input),
            Term::Number(number) => *number,
        };
        let (left, right) = (of(&self.left), of(&self.right));
        match self.comparison {
            Comparison::Less => left < right,
            Comparison::AtMost => left <= right,
            Comparison::More => left > right,
            Comparison::AtLeast => left >= right,
            Comparison::Equal => left == right,
            Comparison::Different => left != right,
        }
    }
}

impl<I: fmt::Display> fmt::Display for Requirement<I> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {} {}", self.left, self.comparison.sign(), self.right)
    }
}

impl<I: fmt::Display> fmt::Display for Term<I> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Term::Input(input) => input.fmt(f),
            Term::Number(number) => number.fmt(f),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_comparison_holds_as_its_sign_says() {
        // For -1, 0 and 1 on `x`: whether `x SIGN 0`.
        let table = [
            ("<", [true, false, false]),
            ("<=", [true, true, false]),
            (">", [false, false, true]),
            (">=", [false, true, true]),
            ("==", [false, true, false]),
            ("!=", [true, false, true]),
        ];
        for (sign, holds) in table {
            let requirement = Requirement::parse(&format!("x {sign} 0")).expect(sign);
            assert_eq!([-1, 0, 1].map(|x| requirement.holds(|_| x)), holds, "{sign}");
        }
    }

    #[test]
    fn what_is_no_comparison_is_refused() {
        for wrong in ["", "x", "x = 1", "<= 3", "x <=", "x <= y <= z", "x => 1", "0.5 < x", "x-1 < 2", "a.b < 1"] {
            assert!(Requirement::parse(wrong).is_err(), "{wrong}");
        }
    }
}
