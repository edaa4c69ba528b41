//! GTKWave save files: which rows to show, in which order, as bits, numbers or curves.
//!
//! GTKWave drops a name that the dump does not hold without a word, so that names here are built from the same
//! signals as the dump's, and a check with GTKWave itself (`.ci/gtkwave_check`) counts the rows it really shows.

use std::fmt::{self, Write};
use std::path::Path;

use super::{Frame, Item, Observer, Plan, Select};
use crate::base::{Report, Signal, ValueId};
use crate::files::{Out, unwritable};

const BITS: u32 = 0x28;
const HEX: u32 = 0x22;
const UNSIGNED: u32 = 0x24;
const SIGNED: u32 = 0x420;
const CURVE: u32 = 0x8000;
const FIXED_POINT: u32 = 0x4000_0000;
/// A row that gives its height to the curve above it.
const HEIGHT: u32 = 0x2_0000;
const OPEN_GROUP: u32 = 0x80_0200;
const CLOSED_GROUP: u32 = 0xC0_0200;
const END_OPEN_GROUP: u32 = 0x100_0200;
const END_CLOSED_GROUP: u32 = 0x140_1200;

/// Rows that a curve takes besides its own.
const CURVE_HEIGHT: usize = 3;

/// Orange.
const CURVE_COLOR: u32 = 2;

/// The widest unsigned word that is shown as a number; a wider one is read better in hex.
const WIDEST_NUMBER: u32 = 32;

/// Writes a save file for the waveform of some signals.
pub struct SaveFile<'o> {
    select: Select,
    dump: String,
    curves: Vec<String>,
    text: String,
    out: Option<Box<dyn Out + 'o>>,
}

impl<'o> SaveFile<'o> {
    /// The save file for the waveform `dump` (a file name as seen from the folder of the save file) of the signals of
    /// `select`; the words named in `curves`, below the top module, are drawn as curves though they have no fraction.
    #[must_use]
    pub fn new(select: Select, dump: String, curves: Vec<String>, out: Box<dyn Out + 'o>) -> Self {
        Self { select, dump, curves, text: String::new(), out: Some(out) }
    }
}

impl Observer for SaveFile<'_> {
    fn wants(&self, name: &str) -> bool {
        self.select.matches(name)
    }

    fn begin(&mut self, signals: &[Signal]) -> Result<Vec<ValueId>, Report> {
        let plan = Plan::new(&self.select.of(signals)?);
        self.text = SaveText { plan: &plan, dump: &self.dump, curves: &self.curves }.to_string();
        Ok(Vec::new())
    }

    fn tick(&mut self, _: Frame<'_>) -> Result<(), Report> {
        Ok(())
    }

    fn end(&mut self) -> Result<(), Report> {
        let Some(mut out) = self.out.take() else { return Ok(()) };
        let written = out.write_all(self.text.as_bytes());
        written.map_err(|error| unwritable(Path::new(&out.name()), &error))?;
        out.commit()
    }
}

/// The text of a save file, shown.
///
/// A group for each scope, in the order of the signals, what is inside the blocks closed; one-bit nets as bits,
/// words as numbers; fixed-point words and the nets named in `curves` as stepped curves.
///
/// ```
/// use stepwright::base::{Signal, ValueId};
/// use stepwright::trace::{Plan, SaveText};
///
/// let path = ["top", "summer_1", "f"].map(str::to_owned).to_vec();
/// let f = Signal { path, width: 16, signed: true, fraction: Some(3), value: ValueId::new(0) };
/// let save = SaveText { plan: &Plan::new(&[f]), dump: "run.vcd", curves: &[] };
/// assert!(save.to_string().contains("[fpshift_count] 3\n@40008420\n+{f} top.summer_1.f[15:0]\n"));
/// ```
#[derive(Clone, Copy, Debug)]
pub struct SaveText<'a> {
    /// What the dump holds.
    pub plan: &'a Plan,
    /// File name of the dump, as seen from the folder of the save file.
    pub dump: &'a str,
    /// Names, below the top module, of words to draw as curves though they have no fraction.
    pub curves: &'a [String],
}

impl fmt::Display for SaveText<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "[dumpfile] \"{}\"\n[timestart] 0", self.dump)?;
        let mut scopes = Vec::new();
        for item in self.plan.walk() {
            match item {
                Item::Open(name) => {
                    scopes.push(name);
                    let group = if is_inside_a_block(&scopes) { CLOSED_GROUP } else { OPEN_GROUP };
                    writeln!(f, "@{group:x}\n-{name}")?;
                }
                Item::Close => {
                    let group = if is_inside_a_block(&scopes) { END_CLOSED_GROUP } else { END_OPEN_GROUP };
                    writeln!(f, "@{group:x}\n-{}", scopes.pop().unwrap_or_default())?;
                }
                Item::Signal(signal, _) => f.write_str(&self.rows(signal))?,
            }
        }
        Ok(())
    }
}

impl SaveText<'_> {
    fn rows(&self, signal: &Signal) -> String {
        let fraction = signal.fraction.filter(|&fraction| fraction > 0);
        let is_curve = signal.width > 1 && (fraction.is_some() || self.curves.contains(&signal.name()));
        let mut flags = match signal.width {
            1 => BITS,
            _ if signal.signed => SIGNED,
            width if width <= WIDEST_NUMBER || is_curve => UNSIGNED,
            _ => HEX,
        };
        let mut rows = String::new();
        if is_curve {
            flags |= CURVE;
            rows += &format!("[color] {CURVE_COLOR}\n");
        }
        if let Some(fraction) = fraction.filter(|_| is_curve) {
            flags |= FIXED_POINT;
            rows += &format!("[fpshift_count] {fraction}\n");
        }
        rows +=
            &format!("@{flags:x}\n+{{{}}} {}\n", signal.path.last().map_or("", String::as_str), dumped_name(signal));
        if is_curve {
            rows += &format!("@{HEIGHT:x}\n{}", "-\n".repeat(CURVE_HEIGHT));
        }
        rows
    }
}

/// Whether a scope stands below the top module's own instances.
fn is_inside_a_block(scopes: &[&str]) -> bool {
    scopes.len() > 2
}

/// The name that GTKWave gives a signal of the dump.
fn dumped_name(signal: &Signal) -> String {
    let mut name = signal.path.join(".");
    if signal.width > 1 {
        let _ = write!(name, "[{}:0]", signal.width - 1);
    }
    name
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::ValueId;

    fn signal(path: &str, width: u32, signed: bool, fraction: Option<u32>) -> Signal {
        let path = path.split('.').map(str::to_owned).collect();
        Signal { path, width, signed, fraction, value: ValueId::new(0) }
    }

    #[test]
    fn rows_stand_in_groups_and_are_shown_as_what_they_are() {
        let signals = [
            signal("top.busy", 1, false, None),
            signal("top.x", 12, false, None),
            signal("top.n_4.sum", 8, true, Some(0)),
            signal("top.n_4.word", 40, false, None),
            signal("top.n_4.cell.q", 1, false, None),
            signal("top.f", 16, true, Some(3)),
        ];
        let plan = Plan::new(&signals);
        let text = SaveText { plan: &plan, dump: "a.vcd", curves: &["x".to_owned()] }.to_string();
        let expected = "[dumpfile] \"a.vcd\"\n[timestart] 0\n@800200\n-top\n@28\n+{busy} top.busy\n\
            [color] 2\n@8024\n+{x} top.x[11:0]\n@20000\n-\n-\n-\n\
            [color] 2\n[fpshift_count] 3\n@40008420\n+{f} top.f[15:0]\n@20000\n-\n-\n-\n\
            @800200\n-n_4\n@420\n+{sum} top.n_4.sum[7:0]\n@22\n+{word} top.n_4.word[39:0]\n\
            @c00200\n-cell\n@28\n+{q} top.n_4.cell.q\n@1401200\n-cell\n@1000200\n-n_4\n@1000200\n-top\n";
        assert_eq!(text, expected);
    }
}
