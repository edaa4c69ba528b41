//! What blessing changes: the summary that is printed when a golden trace is rewritten.

use std::ops::Range;

use super::{Changed, How, Input, check, diff};
use crate::base::Report;

/// The differences between an old golden trace and the new one; shown, it is a report for a person.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Summary {
    /// Whether there was no golden trace before.
    pub is_new: bool,
    /// How many signals the new one holds.
    pub signals: usize,
    /// The ticks it tells about.
    pub span: Range<u64>,
    /// The ticks the old one told about, when they differ.
    pub old_span: Option<Range<u64>>,
    /// Signals that are new.
    pub added: Vec<String>,
    /// Signals that are gone.
    pub removed: Vec<String>,
    /// Signals whose width differs: name, old and new bits.
    pub widths: Vec<(String, u32, u32)>,
    /// Signals whose values differ, the earliest first.
    pub changed: Vec<Changed>,
}

impl Summary {
    /// What becomes different when the run `new` takes the place of `old`. Both are only read through.
    ///
    /// # Errors
    /// Those of [`super::check`] when `new` could not be checked against itself, and those of [`super::diff()`].
    pub fn of(old: Option<&Input>, new: &Input) -> Result<Self, Report> {
        let own = check(new, new)?;
        let mut summary = Self {
            is_new: old.is_none(),
            signals: own.nets,
            span: own.span,
            old_span: None,
            added: Vec::new(),
            removed: Vec::new(),
            widths: Vec::new(),
            changed: Vec::new(),
        };
        if let Some(old) = old {
            let comparison = diff(old, new, &How::default())?;
            summary.changed = comparison.changed;
            summary.old_span = comparison.spans.map(|(old, _)| old);
            (summary.removed, summary.added, summary.widths) =
                (comparison.missing, comparison.extra, comparison.widths);
        }
        Ok(summary)
    }

    /// Whether the new trace says what the old one said.
    #[must_use]
    pub fn is_unchanged(&self) -> bool {
        let same_signals = self.added.is_empty() && self.removed.is_empty() && self.widths.is_empty();
        !self.is_new && same_signals && self.old_span.is_none() && self.changed.is_empty()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn wave(names: [&str; 2], body: &str) -> Input {
        let [a, b] = names;
        let header = format!("$scope module t $end $var wire 4 ! {a} $end $var wire 1 ? {b} $end $upscope $end ");
        Input::bytes("test", format!("{header}$enddefinitions $end\n{body}").into_bytes())
    }

    #[test]
    fn signals_that_come_go_and_change_are_told_with_tick_and_count() {
        let old = wave(["a", "b"], "#0\nb1 !\n0?\n#4\n1?\n#10\n");
        let new = wave(["a", "c"], "#0\nb1 !\n0?\n#5\nb11 !\n#7\nb1 !\n#9\nb0 !\n#11\n");
        let summary = Summary::of(Some(&old), &new).unwrap();
        assert_eq!(
            summary.to_string(),
            "t.c: added\nt.b: removed\nticks 0 up to 10 became 0 up to 11\nt.a: changed at 3 ticks, first at tick 5\n"
        );
    }

    #[test]
    fn a_first_golden_and_one_that_stays_are_told_as_such() {
        let wave = wave(["a", "b"], "#0\nb1 !\n0?\n#10\n");
        assert_eq!(Summary::of(None, &wave).unwrap().to_string(), "new: 2 signals, 10 ticks\n");
        let same = Summary::of(Some(&wave), &wave).unwrap();
        assert!(same.is_unchanged());
        assert_eq!(same.to_string(), "unchanged: 2 signals, 10 ticks\n");
    }
}
