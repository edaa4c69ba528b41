//! Tables: chosen columns, sampled at the ticks at which a net is high, as text.

use std::collections::VecDeque;
use std::fmt;

use super::{Frame, Observer};
use crate::base::word::decode;
use crate::base::{Diagnostic, Report, Signal, Sources, ValueId};

/// The most digits shown behind the point: as many as words of up to 9 fraction bits need to be exact.
const MOST_DECIMALS: u32 = 9;

/// The heading of the tick.
const TICK: &str = "tick";

/// The most rows that are kept to be shown.
const MOST_ROWS: usize = 1 << 20;

/// Which ticks of a run are rows, and which signals columns.
#[derive(Clone, Debug)]
pub struct Rows {
    columns: Vec<String>,
    when: Vec<String>,
    after: u64,
    /// Rows that are due in ticks to come.
    due: VecDeque<u64>,
}

impl Rows {
    /// Rows of `columns`, names below the top module, at the ticks in which one of `when` is not 0, or all without any.
    #[must_use]
    pub fn new(columns: Vec<String>, when: Vec<String>) -> Self {
        Self { columns, when, after: 0, due: VecDeque::new() }
    }

    /// The same rows so many ticks later: what a pulse does shows only when it has landed.
    #[must_use]
    pub fn after(self, ticks: u64) -> Self {
        Self { after: ticks, ..self }
    }

    fn names(&self) -> impl Iterator<Item = &String> {
        self.columns.iter().chain(&self.when)
    }

    pub(super) fn wants(&self, name: &str) -> bool {
        self.names().any(|known| known == name)
    }

    /// The signals of columns, and the values of all: columns, then those that make a row.
    pub(super) fn find(&self, signals: &[Signal]) -> Result<(Vec<Signal>, Vec<ValueId>), Report> {
        let names: Vec<_> = signals.iter().map(Signal::name).collect();
        let (mut found, mut wrong) = (Vec::new(), Vec::new());
        for name in self.names() {
            match names.iter().position(|known| known == name) {
                Some(at) => found.push(&signals[at]),
                None => wrong.push(unknown(name, &names)),
            }
        }
        let again = self.columns.iter().enumerate().find(|(i, name)| self.columns[..*i].contains(name));
        wrong.extend(again.map(|(_, name)| {
            Diagnostic::new("W007", format!("the table has the column `{name}` twice")).help("name it once")
        }));
        if !wrong.is_empty() {
            return Err(Report::new(Sources::default(), wrong));
        }
        let values = found.iter().map(|signal| signal.value).collect();
        Ok((found.into_iter().take(self.columns.len()).cloned().collect(), values))
    }

    /// The words of the columns, if the tick is a row.
    pub(super) fn row<'f>(&mut self, frame: Frame<'f>) -> Option<&'f [u64]> {
        let (columns, when) = frame.words.split_at(self.columns.len());
        if when.is_empty() || when.iter().any(|&word| word != 0) {
            self.due.push_back(frame.tick.saturating_add(self.after));
        }
        self.due.pop_front_if(|due| *due <= frame.tick).map(|_| columns)
    }
}

/// `tick`, then the names of the columns; a signal that is called so itself has its whole path.
pub(super) fn headings(columns: &[Signal]) -> Vec<String> {
    let name = |signal: &Signal| match signal.name() {
        name if name == TICK => signal.path.join("."),
        name => name,
    };
    std::iter::once(TICK.to_owned()).chain(columns.iter().map(name)).collect()
}

/// A table that is filled tick by tick and shown with aligned columns.
///
/// One-bit nets are shown as `1` and `.`, words as decimal numbers, fixed-point words with their fraction.
#[derive(Clone, Debug)]
pub struct Table {
    what: Rows,
    columns: Vec<Signal>,
    rows: Vec<(u64, Vec<u64>)>,
}

impl Table {
    /// A table of those rows.
    #[must_use]
    pub fn new(what: Rows) -> Self {
        Self { what, columns: Vec::new(), rows: Vec::new() }
    }

    /// The headings, once the run has begun: `tick`, then the names of the columns.
    #[must_use]
    pub fn headings(&self) -> Vec<String> {
        headings(&self.columns)
    }

    /// The rows: the tick, and each column's number; that of a fixed-point column in units of its last bit.
    pub fn rows(&self) -> impl Iterator<Item = (u64, Vec<i128>)> + '_ {
        self.rows.iter().map(|(tick, words)| {
            let numbers =
                words.iter().zip(&self.columns).map(|(&word, column)| decode(word, column.width, column.signed));
            (*tick, numbers.collect())
        })
    }
}

impl Observer for Table {
    fn wants(&self, name: &str) -> bool {
        self.what.wants(name)
    }

    fn begin(&mut self, signals: &[Signal]) -> Result<Vec<ValueId>, Report> {
        let (columns, values) = self.what.find(signals)?;
        self.columns = columns;
        Ok(values)
    }

    /// # Errors
    /// `W006` too many rows.
    fn tick(&mut self, frame: Frame<'_>) -> Result<(), Report> {
        let Some(words) = self.what.row(frame) else { return Ok(()) };
        if self.rows.len() == MOST_ROWS {
            let diagnostic = Diagnostic::new("W006", format!("the table has more than {MOST_ROWS} rows"));
            return Err(diagnostic.help("write it with --csv FILE, or choose its rows with --when NET").into());
        }
        self.rows.push((frame.tick, words.to_vec()));
        Ok(())
    }

    fn end(&mut self) -> Result<(), Report> {
        Ok(())
    }
}

fn unknown(name: &str, names: &[String]) -> Diagnostic {
    Diagnostic::new("W003", format!("the table asks for `{name}`, which is no signal of the circuit"))
        .nearest(name, names.iter().map(String::as_str))
}

pub(super) fn cell(word: u64, signal: &Signal) -> String {
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
        let mut lines: Vec<Vec<String>> = vec![self.headings()];
        lines.extend(self.rows.iter().map(|(tick, words)| {
            let cells = words.iter().zip(&self.columns).map(|(&word, signal)| cell(word, signal));
            std::iter::once(tick.to_string()).chain(cells).collect()
        }));
        let widths: Vec<_> =
            (0..lines[0].len()).map(|i| lines.iter().map(|line| line[i].chars().count()).max()).collect();
        for line in &lines {
            let cells = line.iter().zip(&widths).map(|(text, width)| format!("{text:>0$}", width.unwrap_or(0)));
            writeln!(f, "{}", cells.collect::<Vec<_>>().join("  "))?;
        }
        if self.rows.is_empty() && !self.what.when.is_empty() {
            let names: Vec<_> = self.what.when.iter().map(|name| format!("`{name}`")).collect();
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

    fn rows(columns: &[&str], when: &[&str]) -> Rows {
        let names = |names: &[&str]| names.iter().map(|name| (*name).to_owned()).collect();
        Rows::new(names(columns), names(when))
    }

    fn table(signals: &[Signal], columns: &[&str], when: &[&str], words: &[(u64, &[u64])]) -> Result<String, Report> {
        table_of(rows(columns, when), signals, words)
    }

    fn table_of(rows: Rows, signals: &[Signal], words: &[(u64, &[u64])]) -> Result<String, Report> {
        let mut table = Table::new(rows);
        table.begin(signals)?;
        for (tick, words) in words {
            table.tick(Frame { tick: *tick, words, before: None })?;
        }
        Ok(table.to_string())
    }

    #[test]
    fn unknown_names_are_told_together_with_the_nearest() {
        let signals = [signal("busy", 1, false, None)];
        let report = table(&signals, &["bussy", "zzz"], &["bsy"], &[]).unwrap_err();
        assert_eq!(report.diagnostics.iter().map(|wrong| wrong.code).collect::<Vec<_>>(), ["W003"; 3]);
        assert!(report.to_string().contains("did you mean `busy`?"), "{report}");
    }

    #[test]
    fn a_table_without_rows_says_why() {
        let text = table(&[signal("busy", 1, false, None)], &["busy"], &["busy"], &[(0, &[0, 0])]).unwrap();
        assert_eq!(text, "tick  busy\n(no row: `busy` was never high)\n");
    }

    #[test]
    fn pulses_are_points_and_ones_and_columns_align_right() {
        let signals = [signal("busy", 1, false, None), signal("n", 8, true, None)];
        let text = table(&signals, &["busy", "n"], &[], &[(9, &[0, 0]), (10, &[1, 0xFF])]).unwrap();
        assert_eq!(text, "tick  busy   n\n   9     .   0\n  10     1  -1\n");
    }

    #[test]
    fn only_ticks_in_which_a_chosen_net_is_high_are_rows() {
        let signals = [signal("f", 16, true, Some(3)), signal("step", 1, false, None)];
        let rows: [(u64, &[u64]); 3] = [(0, &[0, 1, 1]), (1, &[7, 0, 0]), (2, &[0xFFEB, 1, 1])];
        let text = table(&signals, &["f", "step"], &["step"], &rows).unwrap();
        assert_eq!(text, "tick       f  step\n   0   0.000     1\n   2  -2.625     1\n");
    }

    #[test]
    fn rows_can_show_what_a_pulse_has_done() {
        let signals = [signal("n", 8, false, None), signal("step", 1, false, None)];
        let ticks: [(u64, &[u64]); 6] =
            [(0, &[0, 1]), (1, &[0, 1]), (2, &[1, 0]), (3, &[2, 0]), (4, &[2, 1]), (5, &[3, 0])];
        let text = table_of(rows(&["n"], &["step"]).after(2), &signals, &ticks).unwrap();
        assert_eq!(text, "tick  n\n   2  1\n   3  2\n");
    }

    #[test]
    fn a_table_of_too_many_rows_says_how_to_have_them() {
        let mut table = Table::new(rows(&["n"], &[]));
        table.begin(&[signal("n", 8, false, None)]).unwrap();
        let mut tick = |tick| table.tick(Frame { tick, words: &[1], before: None });
        (0..MOST_ROWS as u64).for_each(|at| tick(at).unwrap());
        let report = tick(MOST_ROWS as u64).unwrap_err().to_string();
        assert!(report.contains("W006") && report.contains("--csv"), "{report}");
    }
}
