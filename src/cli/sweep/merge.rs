//! `stepwright merge`: the files of shards become the file of the whole sweep.
//!
//! Nothing is run: the descriptions beside the parts tell what they are, and their lines are counted before any is
//! copied.

use std::fs::File;
use std::io::{self, Read, Seek, SeekFrom};
use std::ops::Range;
use std::path::{Path, PathBuf};

use clap::Args;

use super::description::Description;
use super::lines::Lines;
use super::rows::Format;
use super::shard::Shard;
use super::{check_files, ending};
use crate::base::{Diagnostic, Report, Sources};
use crate::cli::Ending;
use crate::files::{self, Out, Output};

/// Arguments of `merge`.
#[derive(Args, Debug)]
#[command(after_help = "Example:\n  \
    stepwright sweep su1522157/interpolator --over major_32=0..=4095 --shard 0/2 --out part0.csv\n  \
    stepwright sweep su1522157/interpolator --over major_32=0..=4095 --shard 1/2 --out part1.csv\n  \
    stepwright merge part*.csv --out all.csv\n\n\
    The file is that of the sweep without --shard, byte for byte. Beside each part stands its PART.sweep.")]
pub struct MergeArguments {
    /// Files that `sweep --shard` wrote, in any order
    #[arg(value_name = "PART", required = true)]
    pub parts: Vec<PathBuf>,
    /// Write the rows into this file
    #[arg(long, value_name = "FILE.csv|.jsonl")]
    pub out: PathBuf,
}

/// A file of rows that is a shard.
struct Part<'a> {
    path: &'a Path,
    sweep: Description,
    shard: Shard,
    /// How many rows all shards have.
    all: u64,
    lines: Lines,
}

pub fn merge(arguments: &MergeArguments) -> Result<Ending, Report> {
    let out = &arguments.out;
    let format = Format::of(Some(out))?;
    let described: Vec<_> = arguments.parts.iter().map(|part| Description::path(part)).collect();
    let reads = arguments.parts.iter().chain(&described).map(PathBuf::as_path);
    check_files(reads, [out.as_path(), Description::path(out).as_path()])?;
    let (mut parts, mut wrong) = (Vec::new(), Vec::new());
    for path in &arguments.parts {
        match Part::open(path, format) {
            Ok(part) => parts.push(part),
            Err(diagnostic) => wrong.push(diagnostic),
        }
    }
    parts.sort_by_key(|part| (part.rows().start, part.rows().end));
    let Some((first, others)) = parts.split_first() else { return Err(Report::new(Sources::default(), wrong)) };
    wrong.extend(others.iter().filter_map(|part| part.strange_to(first)));
    // Where a part is not known or of another sweep, what is missing is not known either.
    if wrong.is_empty() {
        wrong.extend(parts.iter().filter_map(Part::cut));
        wrong.extend(overlaps(&parts));
        wrong.extend(missing(&parts));
    }
    if !wrong.is_empty() {
        return Err(Report::new(Sources::default(), wrong));
    }
    write(&parts, out)?;
    if out.is_file() {
        first.sweep.write(out)?;
    }
    Ok(ending(parts.iter().map(|part| part.lines.at_limit).sum(), first.all))
}

impl<'a> Part<'a> {
    /// `C002`, `C066`, `C068`, `C083`.
    fn open(path: &'a Path, format: Format) -> Result<Self, Diagnostic> {
        if Format::of(Some(path))? != format {
            return Err(unfit(path, "is not of the format of the output").help("merging changes no format"));
        }
        let none = || unfit(path, "is no shard").help("merge files that `sweep --shard` wrote, as they are");
        let beside = |untold: Diagnostic| untold.help("the file that ends in .sweep belongs to a part: copy both");
        let (sweep, shard, all) = Description::of(path).map_err(beside)?.shard().ok_or_else(none)?;
        let lines = File::open(path).and_then(|file| Lines::of(file, format));
        let lines = lines.map_err(|error| files::unreadable(path, &files::reason(&error)))?;
        Ok(Self { path, sweep, shard, all, lines })
    }

    fn rows(&self) -> Range<u64> {
        self.shard.rows(self.all)
    }

    /// `C083` if it is of another sweep than the first part.
    fn strange_to(&self, first: &Self) -> Option<Diagnostic> {
        let said = [first.path, self.path].map(|path| format!("in {}", path.display()));
        let mut different = self.sweep.differences(&first.sweep, [&said[0], &said[1]]);
        if self.all != first.all {
            different.push(format!("rows of all shards: {} {}, {} {}", first.all, said[0], self.all, said[1]));
        }
        if self.lines.header != first.lines.header && self.cut().is_none() && first.cut().is_none() {
            different.push("the header".to_owned());
        }
        let wrong = unfit(self.path, &format!("is of another sweep than {}", first.path.display()));
        (!different.is_empty()).then(|| different.into_iter().fold(wrong, Diagnostic::help))
    }

    /// `C084` if it has not just the rows of its shard.
    fn cut(&self) -> Option<Diagnostic> {
        let Range { start, end } = self.rows();
        let (wanted, Lines { rows, is_torn, bytes, .. }) = (end - start, &self.lines);
        let is_headless = *bytes == 0 && Format::of(Some(self.path)).is_ok_and(|format| format == Format::Csv);
        if *rows == wanted && !is_torn && !is_headless {
            return None;
        }
        let torn = if *is_torn { " and a piece of a line" } else { "" };
        let Shard { index, of } = self.shard;
        let message = format!("{} has {rows} rows{torn}, and shard {index}/{of} has {wanted}", self.path.display());
        let diagnostic = Diagnostic::new("C084", message);
        Some(diagnostic.help(format!("run it to its end: the same sweep with --shard {index}/{of} and --resume")))
    }
}

/// `C083`.
fn unfit(path: &Path, why: &str) -> Diagnostic {
    Diagnostic::new("C083", format!("{} {why}", path.display()))
}

/// `C085` for each part that begins before the one in front of it ends.
fn overlaps(parts: &[Part<'_>]) -> Vec<Diagnostic> {
    let overlap = |pair: &[&Part<'_>]| {
        let (one, other) = (pair[0], pair[1]);
        (other.rows().start < one.rows().end).then(|| {
            let message = format!("{} and {} have rows in common", one.path.display(), other.path.display());
            Diagnostic::new("C085", message).help("leave one of them out")
        })
    };
    let filled: Vec<_> = filled(parts).collect();
    filled.windows(2).filter_map(overlap).collect()
}

/// `C086` with all that is missing, as `sbatch --array` takes it where the parts are of one number of shards.
fn missing(parts: &[Part<'_>]) -> Option<Diagnostic> {
    let (all, of) = (parts[0].all, parts[0].shard.of);
    let (mut next, mut next_shard) = (0, 0);
    let (mut rows, mut shards) = (Vec::new(), Vec::new());
    let there = filled(parts).map(|part| (part.rows(), part.shard.index));
    for (there, index) in there.chain([(all..all, of)]) {
        if next < there.start {
            rows.push(format!("{next} to {}", there.start - 1));
            let last = index.saturating_sub(1);
            shards.push(if last > next_shard { format!("{next_shard}-{last}") } else { next_shard.to_string() });
        }
        next = next.max(there.end);
        next_shard = index.saturating_add(1);
    }
    let is_of_one = parts.iter().all(|part| part.shard.of == of);
    (!rows.is_empty()).then(|| {
        let rows = rows.join(", ");
        let shards = shards.join(",");
        if is_of_one {
            let diagnostic = Diagnostic::new("C086", format!("shards {shards} of {of} are missing (rows {rows})"));
            diagnostic.help(format!("run just these, as with sbatch --array={shards} and --shard auto/{of}"))
        } else {
            Diagnostic::new("C086", format!("rows {rows} are missing")).help("name the parts that have them")
        }
    })
}

/// Parts that have rows: with more shards than rows some have none.
fn filled<'p>(parts: &'p [Part<'p>]) -> impl Iterator<Item = &'p Part<'p>> {
    parts.iter().filter(|part| !part.rows().is_empty())
}

/// Writes the header once and all rows.
fn write(parts: &[Part<'_>], out: &Path) -> Result<(), Report> {
    let mut output = Output::create(out)?;
    let header = parts[0].lines.header.as_deref().unwrap_or_default();
    io::Write::write_all(&mut output, header).map_err(|error| files::unwritable(out, &error))?;
    for part in parts {
        let skipped = header.len() as u64;
        let rows = File::open(part.path).and_then(|mut file| {
            file.seek(SeekFrom::Start(skipped))?;
            Ok(file.take(part.lines.bytes - skipped))
        });
        let mut rows = rows.map_err(|error| files::unreadable(part.path, &files::reason(&error)))?;
        let copied = io::copy(&mut rows, &mut output).map_err(|error| files::unwritable(out, &error))?;
        if copied != part.lines.bytes - skipped {
            return Err(files::unreadable(part.path, "it became shorter while it was read").into());
        }
    }
    Box::new(output).commit()
}
