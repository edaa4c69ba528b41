//! Comparing two files of any size, and what is behind their differences.

use std::ops::Range;

use super::cause::{self, Cause};
use super::compare::{Comparison, around, divergence};
use super::cone::Cones;
use super::drivers::Drivers;
use super::how::How;
use super::input::Input;
use super::merge::merge;
use super::pairs::Pairs;
use super::read::cut;
use super::sample::Sampled;
use super::source::Source;
use super::{Edge, Waveform};
use crate::base::Report;

/// Compares two files of any size in memory that does not grow with their length; if their values differ, both are
/// read once more around the first difference.
///
/// # Errors
/// Those of [`super::read()`], and `W021` when there is no net to look at them by.
pub fn diff(expected: &Input, got: &Input, how: &How) -> Result<Comparison, Report> {
    Ok(Files([expected, got]).compare(how, None)?.comparison)
}

/// Compares two files as [`diff`] does, and tells of all differences which came first: of every signal that differs it
/// is found, at its first difference, whether something that drives it is or was wrong. Causes come the earliest
/// first, those whose drivers are known before others; both files are read once more for each.
///
/// ```
/// use stepwright::golden::{Driven, Driver, Drivers, How, Input, explain};
///
/// let header = "$scope module top $end $var wire 1 a d $end $var wire 1 b q $end $upscope $end $enddefinitions $end\n";
/// let expected = Input::bytes("golden", format!("{header}#0\n0a\n0b\n#4\n1a\n#5\n1b\n#9\n").into_bytes());
/// let got = Input::bytes("run", format!("{header}#0\n0a\n0b\n#9\n").into_bytes());
/// let by = vec![Driver { net: "top.d".into(), delayed: true }];
/// let drivers = Drivers::from([("top.q".into(), Driven { by, place: "register_3, FIG. 1".into(), is_net: true })]);
/// let (_, causes) = explain(&expected, &got, &How::default(), &drivers)?;
/// assert_eq!((causes[0].net.as_str(), causes[0].tick, causes.len()), ("top.d", 4, 1));
/// assert_eq!(causes[0].follows, ["top.q"]);
/// # Ok::<(), stepwright::base::Report>(())
/// ```
///
/// # Errors
/// Those of [`diff`].
pub fn explain(
    expected: &Input,
    got: &Input,
    how: &How,
    drivers: &Drivers,
) -> Result<(Comparison, Vec<Cause>), Report> {
    let Found { comparison, causes, .. } = Files([expected, got]).compare(how, Some(drivers))?;
    Ok((comparison, causes))
}

/// Compares a golden trace with a run as [`diff`] does, nothing forgiven.
///
/// # Errors
/// Those of [`diff`], and `W018` when the golden trace does not end with the time that closes every waveform of ours.
pub fn check(golden: &Input, run: &Input) -> Result<Comparison, Report> {
    match Files([golden, run]).compare(&How::default(), None)? {
        Found { comparison, is_closed: true, .. } => Ok(comparison),
        _ => Err(cut(golden.name()).into()),
    }
}

/// The two edges of a net at which two files are looked at: in each file the net of that dotted name, or else the
/// outermost of those whose names end in it. A file without such a net is compared tick by tick as it is.
///
/// # Errors
/// Those of opening the files, and `W021` when neither has such a net.
pub fn edges(inputs: [&Input; 2], net: &str, is_rising: bool) -> Result<[Option<Edge>; 2], Report> {
    let [mine, theirs] = [inputs[0].open()?, inputs[1].open()?];
    let edge = |source: &dyn Source| {
        let names = || source.declared().names.iter().map(|name| name.path.as_str());
        let is_it = |path: &&str| path.strip_suffix(net).is_some_and(|scope| scope.is_empty() || scope.ends_with('.'));
        let found = names().filter(is_it).min_by_key(|path| path.matches('.').count());
        found.map(|path| Edge { net: path.to_owned(), is_rising })
    };
    let edges = [edge(mine.as_ref()), edge(theirs.as_ref())];
    if edges == [None, None] {
        // What is near is told by whoever looks for it in the first file.
        Sampled::new(inputs[0].name(), mine, &Edge { net: net.to_owned(), is_rising })?;
    }
    Ok(edges)
}

/// The expected file and the other one.
struct Files<'a>([&'a Input; 2]);

/// What comparing them found.
struct Found {
    comparison: Comparison,
    causes: Vec<Cause>,
    /// Whether the expected file ends with a closing time.
    is_closed: bool,
}

impl Files<'_> {
    fn compare(&self, how: &How, drivers: Option<&Drivers>) -> Result<Found, Report> {
        let [mut expected, mut got] = [self.open(how, 0)?, self.open(how, 1)?];
        let pairs = Pairs::new(expected.declared(), got.declared(), how);
        let mut cones = drivers.map(|drivers| Cones::new(drivers, &pairs));
        let merged = merge(expected.as_mut(), got.as_mut(), &pairs, how, cones.as_mut())?;
        let is_closed = expected.is_closed();
        let units = [expected.declared().unit, got.declared().unit];
        // Readers hold buffers and threads.
        drop((expected, got));
        let look = |tick: u64| self.look(how, units, &around(tick, &merged.span));
        let causes = cones.map_or_else(|| Ok(Vec::new()), |cones| cause::causes(&pairs, &merged, cones, look))?;
        let waves = merged.first().map(look).transpose()?;
        let divergence = waves.and_then(|[mine, theirs]| divergence(&pairs, &merged, [&mine, &theirs]));
        let comparison = Comparison { divergence, ..Comparison::new(pairs, &merged, how, units) };
        Ok(Found { comparison, causes, is_closed })
    }

    fn open(&self, how: &How, side: usize) -> Result<Box<dyn Source>, Report> {
        let source = self.0[side].open()?;
        match &how.at[side] {
            Some(edge) => Ok(Box::new(Sampled::new(self.0[side].name(), source, edge)?)),
            None => Ok(source),
        }
    }

    /// What both say at the ticks of a window, in the finer unit.
    fn look(&self, how: &How, units: [u64; 2], window: &Range<u64>) -> Result<[Waveform; 2], Report> {
        let read = |side: usize| {
            let factor = units[side] / units[0].min(units[1]);
            let coarse = window.start / factor..window.end.div_ceil(factor);
            let mut source = self.open(how, side)?;
            Waveform::gather(self.0[side].name(), source.as_mut(), &coarse).map(|wave| wave.finer(factor))
        };
        Ok([read(0)?, read(1)?])
    }
}
