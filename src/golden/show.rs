//! How comparisons, causes and summaries read.

use std::fmt;

use super::{Cause, Changed, Comparison, Divergence, Summary};

/// How many names of a list are shown before "and so many more".
const MOST_NAMES: usize = 12;

/// Femtoseconds of a tick of ours.
const TICK: u64 = 1_000_000;

/// How many signals that follow from a cause are named.
const MOST_FOLLOWERS: usize = 4;

/// How many of the differing signals are shown with their values around.
const MOST_ROWS: usize = 6;

impl fmt::Display for Comparison {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.unit != TICK {
            writeln!(f, "a tick is {} here", time(self.unit))?;
        }
        if self.is_equal() {
            let ticks = self.span.end - self.span.start;
            writeln!(f, "equal: {} signals, {ticks} ticks", self.nets)?;
            return self.told(f);
        }
        if let Some(divergence) = &self.divergence {
            divergence.fmt(f)?;
        }
        if self.needs_all {
            names(f, "only in the expected waveform", &self.missing)?;
            names(f, "only in the other waveform", &self.extra)?;
        }
        names(f, "cannot be compared: it is a text, an event, or a number in one waveform only", &self.uncompared)?;
        if self.beyond {
            writeln!(f, "from tick {} on times are too large for the finer unit: not compared", self.span.end)?;
        }
        for (name, expected, got) in self.widths.iter().take(MOST_NAMES) {
            writeln!(f, "{name}: expected {expected} bits, got {got}")?;
        }
        if let Some((expected, got)) = &self.spans {
            let [a, b, c, d] = [expected.start, expected.end, got.start, got.end];
            writeln!(f, "expected ticks {a} up to {b}, got {c} up to {d} (a file that was cut off is shorter)")?;
        }
        if self.nets == 0 {
            writeln!(f, "the waveforms have no signal in common")?;
        } else if self.span.is_empty() {
            writeln!(f, "the waveforms have no tick in common")?;
        }
        self.told(f)
    }
}

impl Comparison {
    /// Signals that only one waveform has, where that is no difference.
    fn told(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let lists = [("the expected waveform", &self.missing), ("the other one", &self.extra)];
        for (whose, names) in lists.into_iter().filter(|(_, names)| !self.needs_all && !names.is_empty()) {
            let shown: Vec<_> = names.iter().take(MOST_NAMES).map(String::as_str).collect();
            let more = names.len() - shown.len();
            let more = if more > 0 { format!(" and {more} more") } else { String::new() };
            writeln!(f, "not compared, being only in {whose}: {}{more}", shown.join(", "))?;
        }
        Ok(())
    }
}

impl fmt::Display for Divergence {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let at = (self.tick - self.around.start) as usize;
        for net in self.nets.iter().take(MOST_NAMES) {
            let (expected, got) = (number(&net.expected[at], net.width), number(&net.got[at], net.width));
            writeln!(f, "tick {}: {} expected {expected}, got {got}", self.tick, net.name)?;
        }
        more(f, self.nets.len().saturating_sub(MOST_NAMES))?;
        self.table(f)
    }
}

impl Divergence {
    /// The values around, time from left to right as in a waveform.
    fn table(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let ticks: Vec<_> = self.around.clone().map(|tick| tick.to_string()).collect();
        let marks = self.around.clone().map(|tick| if tick == self.tick { "v" } else { "" });
        let nets = || self.nets.iter().take(MOST_ROWS);
        let longest = |cells: &[String]| cells.iter().map(String::len).max().unwrap_or(0);
        let width =
            nets().map(|net| longest(&net.expected).max(longest(&net.got))).max().unwrap_or(0).max(longest(&ticks));
        let title = nets().map(|net| net.name.len()).max().unwrap_or(0);
        line(f, [title, width], "", "", marks)?;
        line(f, [title, width], "tick", "", ticks.iter().map(String::as_str))?;
        for net in nets() {
            line(f, [title, width], &net.name, "expected", net.expected.iter().map(String::as_str))?;
            line(f, [title, width], "", "got", net.got.iter().map(String::as_str))?;
        }
        Ok(())
    }
}

fn line<'a>(
    f: &mut fmt::Formatter<'_>,
    [title, width]: [usize; 2],
    name: &str,
    whose: &str,
    cells: impl Iterator<Item = &'a str>,
) -> fmt::Result {
    let cells: String = cells.map(|cell| format!("  {cell:>width$}")).collect();
    writeln!(f, "{}", format!("  {name:<title$}  {whose:<8}{cells}").trim_end())
}

/// A word as [`super::Value`] shows it, with its number.
fn number(shown: &str, width: u32) -> String {
    match u64::from_str_radix(shown, 16) {
        Ok(word) if (2..=64).contains(&width) => {
            let signed = crate::base::word::signed(word, width);
            if signed < 0 { format!("0x{shown} ({word}, signed {signed})") } else { format!("0x{shown} ({word})") }
        }
        _ => shown.to_owned(),
    }
}

/// Femtoseconds as the largest unit of which they are a whole number.
fn time(femtoseconds: u64) -> String {
    let units = [(1_000_000_000, "us"), (1_000_000, "ns"), (1000, "ps"), (1, "fs")];
    let fits = units.into_iter().find(|(unit, _)| femtoseconds.is_multiple_of(*unit));
    fits.map_or_else(String::new, |(unit, name)| format!("{} {name}", femtoseconds / unit))
}

fn names(f: &mut fmt::Formatter<'_>, what: &str, names: &[String]) -> fmt::Result {
    for name in names.iter().take(MOST_NAMES) {
        writeln!(f, "{name}: {what}")?;
    }
    more(f, names.len().saturating_sub(MOST_NAMES))
}

fn more(f: &mut fmt::Formatter<'_>, count: usize) -> fmt::Result {
    if count > 0 { writeln!(f, "and {count} more") } else { Ok(()) }
}

impl fmt::Display for Cause {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Cause { net, tick, inputs, untraced, .. } = self;
        let (expected, got) = self.values();
        write!(f, "{net} first went wrong, at tick {tick}: expected {expected}, got {got}")?;
        f.write_str(match (inputs, untraced) {
            (0, 0) => "; nothing drives it",
            (0, _) => "; nothing traced drives it",
            (_, 0) => " while its drivers are right",
            _ => " while its nearest traced drivers are right",
        })?;
        match self.place.as_str() {
            "" => writeln!(f)?,
            place => writeln!(f, " ({place})")?,
        }
        if *untraced > 0 {
            writeln!(f, "  nets between that are not traced, of which one may be wrong: {untraced}")?;
        }
        let follows = &self.follows;
        for name in follows.iter().take(MOST_FOLLOWERS) {
            writeln!(f, "  {name} follows")?;
        }
        if follows.len() > MOST_FOLLOWERS {
            writeln!(f, "  and {} more follow", follows.len() - MOST_FOLLOWERS)?;
        }
        self.around.table(f)
    }
}

impl Cause {
    /// The expected value and the other one.
    #[must_use]
    pub fn values(&self) -> (&str, &str) {
        let at = (self.tick - self.around.around.start) as usize;
        self.around.nets.first().map_or(("-", "-"), |net| (&net.expected[at], &net.got[at]))
    }
}

impl fmt::Display for Summary {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Summary { signals, span, .. } = self;
        if self.is_new {
            return writeln!(f, "new: {signals} signals, {} ticks", span.end - span.start);
        }
        if self.is_unchanged() {
            return writeln!(f, "unchanged: {signals} signals, {} ticks", span.end - span.start);
        }
        names(f, "added", &self.added)?;
        names(f, "removed", &self.removed)?;
        for (name, old, new) in self.widths.iter().take(MOST_NAMES) {
            writeln!(f, "{name}: {old} bits became {new}")?;
        }
        more(f, self.widths.len().saturating_sub(MOST_NAMES))?;
        if let Some(old) = &self.old_span {
            writeln!(f, "ticks {} up to {} became {} up to {}", old.start, old.end, span.start, span.end)?;
        }
        for changed in self.changed.iter().take(MOST_NAMES) {
            let Changed { name, first, ticks } = changed;
            writeln!(f, "{name}: changed at {ticks} ticks, first at tick {first}")?;
        }
        more(f, self.changed.len().saturating_sub(MOST_NAMES))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_word_is_shown_in_hex_and_as_the_numbers_it_may_mean() {
        assert_eq!(number("1d", 8), "0x1d (29)");
        assert_eq!(number("ffd", 12), "0xffd (4093, signed -3)");
        assert_eq!(number("1", 1), "1");
        assert_eq!(number("3", 2), "0x3 (3, signed -1)");
        assert_eq!(number("0x11", 4), "0x11");
        assert_eq!(number("-", 4), "-");
    }

    #[test]
    fn a_long_list_is_cut_with_a_count() {
        let missing: Vec<_> = (0..MOST_NAMES + 3).map(|i| format!("n{i}")).collect();
        let text = Comparison { nets: 1, unit: TICK, span: 0..1, needs_all: true, missing, ..Comparison::default() }
            .to_string();
        assert_eq!(text.lines().count(), MOST_NAMES + 1);
        assert!(text.ends_with("and 3 more\n"), "{text}");
    }
}
