//! Tables: chosen columns, sampled at the ticks at which a net is high, as text.

use std::fmt;

use crate::base::word::decode;
use crate::base::{Diagnostic, Report, Signal, Sources, ValueId};

/// The most digits shown behind the point: as many as words of up to 9 fraction bits need to be exact.
const MOST_DECIMALS: u32 = 9;

/// A table that is filled tick by tick and shown with aligned columns.
///
/// One-bit nets are shown as `1` and `.`, words as decimal numbers, fixed-point words with their fraction.
///
/// ```
/// use stepwright::base::{Signal, ValueId};
/// use stepwright::trace::Table;
///
/// let signal = |net: &str, width, fraction, value| Signal {
///     path: vec!["top".to_owned(), net.to_owned()], width, signed: fraction > 0, fraction: Some(fraction),
///     value: ValueId::new(value),
/// };
/// let signals = [signal("f", 16, 3, 0), signal("step", 1, 0, 1)];
/// let mut table = Table::new(&signals, &["f".to_owned(), "step".to_owned()], &["step".to_owned()])?;
/// for (tick, words) in [[0u64, 1], [7, 0], [0xFFEB, 1]].iter().enumerate() {
///     table.sample(tick as u64, |id| words[id.index()]);
/// }
/// assert_eq!(table.to_string(), "\
/// tick       f  step
///    0   0.000     1
///    2  -2.625     1
/// ");
/// # Ok::<(), stepwright::base::Report>(())
/// ```
#[derive(Clone, Debug)]
pub struct Table {
    columns: Vec<Signal>,
    when: Vec<(String, ValueId)>,
    rows: Vec<(u64, Vec<u64>)>,
}

impl Table {
    /// A table of `columns`, names below the top module, sampled at the ticks at which one of `when` is
    /// not 0, or at all.
    ///
    /// # Errors
    /// `W003` for each name that no signal has, with the nearest one.
    pub fn new(signals: &[Signal], columns: &[String], when: &[String]) -> Result<Self, Report> {
        let mut wrong = Vec::new();
        let names: Vec<_> = signals.iter().map(Signal::name).collect();
        let mut find = |name: &str| {
            let at = names.iter().position(|known| known == name);
            if at.is_none() {
                wrong.push(unknown(name, &names));
            }
            at.map(|at| signals[at].clone())
        };
        let columns = columns.iter().filter_map(|name| find(name)).collect();
        let when = when.iter().filter_map(|name| Some((name.clone(), find(name)?.value))).collect();
        if wrong.is_empty() {
            Ok(Self { columns, when, rows: Vec::new() })
        } else {
            Err(Report::new(Sources::default(), wrong))
        }
    }

    /// Takes a row if this tick is one of the table's.
    pub fn sample(&mut self, tick: u64, read: impl Fn(ValueId) -> u64) {
        if self.when.is_empty() || self.when.iter().any(|(_, value)| read(*value) != 0) {
            self.rows.push((tick, self.columns.iter().map(|column| read(column.value)).collect()));
        }
    }

    /// How many rows there are.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.rows.len()
    }
}

fn unknown(name: &str, names: &[String]) -> Diagnostic {
    Diagnostic::new("W003", format!("the table asks for `{name}`, which is no signal of the circuit"))
        .nearest(name, names.iter().map(String::as_str))
}

fn cell(word: u64, signal: &Signal) -> String {
    match (signal.width, signal.fraction) {
        (1, None | Some(0)) => (if word == 0 { "." } else { "1" }).to_owned(),
        (_, fraction) => fixed_point(decode(word, signal.width, signal.signed), fraction.unwrap_or(0)),
    }
}

/// `number / 2^fraction`, rounded where it has too many digits.
fn fixed_point(number: i128, fraction: u32) -> String {
    let decimals = fraction.min(MOST_DECIMALS);
    let ten = 10i128.pow(decimals);
    // From 100 fraction bits on every word is less than the last digit shown.
    let scaled = if fraction < 100 { (number * ten + (1 << fraction >> 1)) >> fraction } else { 0 };
    let sign = if scaled < 0 { "-" } else { "" };
    let (whole, rest) = (scaled.abs() / ten, scaled.abs() % ten);
    match decimals {
        0 => format!("{sign}{whole}"),
        _ => format!("{sign}{whole}.{rest:0width$}", width = decimals as usize),
    }
}

impl fmt::Display for Table {
    /// A heading and a line for each row; without rows the heading and a line that says so.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let headings = std::iter::once("tick".to_owned()).chain(self.columns.iter().map(Signal::name)).collect();
        let mut lines: Vec<Vec<String>> = vec![headings];
        lines.extend(self.rows.iter().map(|(tick, words)| {
            let cells = words.iter().zip(&self.columns).map(|(&word, signal)| cell(word, signal));
            std::iter::once(tick.to_string()).chain(cells).collect()
        }));
        let widths: Vec<_> =
            (0..=self.columns.len()).map(|i| lines.iter().map(|line| line[i].chars().count()).max()).collect();
        for line in &lines {
            let cells = line.iter().zip(&widths).map(|(text, width)| format!("{text:>0$}", width.unwrap_or(0)));
            writeln!(f, "{}", cells.collect::<Vec<_>>().join("  "))?;
        }
        if self.rows.is_empty() && !self.when.is_empty() {
            let names: Vec<_> = self.when.iter().map(|(name, _)| format!("`{name}`")).collect();
            writeln!(f, "(no row: {} was never high)", names.join(" or "))?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn signal(name: &str, width: u32, signed: bool, fraction: Option<u32>) -> Signal {
        Signal { path: vec!["top".into(), name.into()], width, signed, fraction, value: ValueId::new(0) }
    }

    #[test]
    fn the_words_of_table_1_are_printed_as_the_patent_prints_them() {
        // SU 1522157, table 1 as reconstructed: F in eighths.
        for (eighths, text) in [(3, "0.375"), (-21, "-2.625"), (9, "1.125"), (-15, "-1.875"), (27, "3.375")] {
            let word = (eighths as u64) & 0xFFFF;
            assert_eq!(cell(word, &signal("f", 16, true, Some(3))), text);
        }
    }

    proptest! {
        #[test]
        fn up_to_nine_fraction_bits_are_exact(number in -(1i64 << 40)..1 << 40, fraction in 0u32..=9) {
            // Such numbers are exact in an f64, and Rust prints an f64 correctly rounded.
            let value = number as f64 / f64::from(1u32 << fraction);
            prop_assert_eq!(fixed_point(number.into(), fraction), format!("{value:.*}", fraction as usize));
        }

        #[test]
        fn more_fraction_bits_are_rounded_to_half_of_the_last_digit(number: i64, fraction in 10u32..130) {
            let shown: f64 = fixed_point(number.into(), fraction).parse().unwrap();
            let value = number as f64 / 2f64.powi(fraction as i32);
            prop_assert!((shown - value).abs() <= 0.500_001e-9 + value.abs() * 1e-15, "{} {}", shown, value);
        }
    }

    #[test]
    fn unknown_names_are_told_together_with_the_nearest() {
        let signals = [signal("busy", 1, false, None)];
        let report = Table::new(&signals, &["bussy".to_owned(), "zzz".to_owned()], &["bsy".to_owned()]).unwrap_err();
        assert_eq!(report.diagnostics.iter().map(|wrong| wrong.code).collect::<Vec<_>>(), ["W003"; 3]);
        assert!(report.to_string().contains("did you mean `busy`?"), "{report}");
    }

    #[test]
    fn a_table_without_rows_says_why() {
        let mut table =
            Table::new(&[signal("busy", 1, false, None)], &["busy".to_owned()], &["busy".to_owned()]).unwrap();
        table.sample(0, |_| 0);
        assert_eq!(table.to_string(), "tick  busy\n(no row: `busy` was never high)\n");
    }

    #[test]
    fn pulses_are_points_and_ones_and_columns_align_right() {
        let signals = [signal("busy", 1, false, None), signal("n", 8, true, None)];
        let mut table = Table::new(&signals, &["busy".to_owned(), "n".to_owned()], &[]).unwrap();
        for (tick, word) in [(9, 0), (10, 0xFF)] {
            table.sample(tick, |_| word);
        }
        assert_eq!(table.to_string(), "tick  busy   n\n   9     .   0\n  10     1  -1\n");
    }
}
