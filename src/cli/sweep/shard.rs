//! A shard: one of N parts of a sweep, in a row and as even as can be. Its rows are computed, so that nobody has to list
//! them.

use std::ops::Range;

use crate::base::Diagnostic;

/// Where schedulers tell a job its number, and what the first one is called there: Slurm arrays, Kubernetes Indexed
/// Jobs, GNU parallel.
const NUMBERED: [(&str, u64); 3] = [("SLURM_ARRAY_TASK_ID", 0), ("JOB_COMPLETION_INDEX", 0), ("PARALLEL_SEQ", 1)];

/// A part of a sweep.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Shard {
    /// Its number, below `of`.
    pub index: u64,
    /// How many there are.
    pub of: u64,
}

impl Shard {
    /// A shard, if its number is below theirs.
    pub fn new(index: u64, of: u64) -> Option<Self> {
        (index < of).then_some(Self { index, of })
    }

    /// Reads `I/N`, `auto/N` or `auto`; the latter two ask the scheduler by its environment variables. With `auto/N` a
    /// task's number is the shard's, so that single tasks can be submitted again; `auto` has the array's size for N.
    ///
    /// # Errors
    /// `C080` no shard, `C081` variables that tell none.
    pub fn parse(text: &str, variable: impl Fn(&str) -> Option<String>) -> Result<Self, Diagnostic> {
        let number = |text: &str| text.parse().map_err(|_| no_shard(&format!("`{text}` is not a number")));
        let asked = |name: &str| match variable(name) {
            Some(value) => value.parse().map_err(|_| untold(&format!("{name} is `{value}`, which is not a number"))),
            None => Err(untold(&format!("{name} is not set"))),
        };
        let (index, of) = match text.split_once('/') {
            Some(("auto", of)) => (task(&variable, asked)?, number(of)?),
            Some((index, of)) => (number(index)?, number(of)?),
            None if text == "auto" => array(asked)?,
            None => return Err(no_shard(&format!("`{text}` is not of the form I/N"))),
        };
        Self::new(index, of).ok_or_else(|| match of {
            0 => no_shard("there cannot be 0 shards"),
            _ => no_shard(&format!("there is no shard {index} of {of}")),
        })
    }

    /// Its rows, of `all` of them.
    pub fn rows(self, all: u64) -> Range<u64> {
        let place = |index: u64| {
            let place = u128::from(all) * u128::from(index) / u128::from(self.of);
            u64::try_from(place).expect("an index of at most `of` gives at most all")
        };
        place(self.index)..place(self.index + 1)
    }
}

/// The number that the scheduler gives this job, from 0 on.
fn task(
    variable: &impl Fn(&str) -> Option<String>,
    asked: impl Fn(&str) -> Result<u64, Diagnostic>,
) -> Result<u64, Diagnostic> {
    let set: Vec<_> = NUMBERED.into_iter().filter(|(name, _)| variable(name).is_some()).collect();
    match set[..] {
        [(name, first)] => {
            asked(name)?.checked_sub(first).ok_or_else(|| untold(&format!("{name} is 0, and counts from {first}")))
        }
        [] => Err(untold(&format!("none of {} is set", NUMBERED.map(|(name, _)| name).join(", ")))),
        [(one, _), (other, _), ..] => Err(untold(&format!("both {one} and {other} are set"))),
    }
}

/// Number and size of a Slurm array. The size of one with holes, as when some tasks are submitted again, is not that of
/// the sweep.
fn array(asked: impl Fn(&str) -> Result<u64, Diagnostic>) -> Result<(u64, u64), Diagnostic> {
    let [task, count, first, last] =
        ["ID", "COUNT", "MIN", "MAX"].map(|name| asked(&format!("SLURM_ARRAY_TASK_{name}")));
    let (task, count, first, last) = (task?, count?, first?, last?);
    if last.checked_sub(first) != count.checked_sub(1) || !(first..=last).contains(&task) {
        let message = format!("the array has holes: {count} tasks from {first} to {last}");
        return Err(untold(&message));
    }
    Ok((task - first, count))
}

/// `C080`.
fn no_shard(why: &str) -> Diagnostic {
    Diagnostic::new("C080", format!("--shard: {why}")).help("write I/N with I from 0 to N-1, as 0/8 to 7/8, or auto/8")
}

/// `C081`.
fn untold(why: &str) -> Diagnostic {
    let diagnostic = Diagnostic::new("C081", format!("--shard: no scheduler tells a shard: {why}"));
    diagnostic.help(
        "write it as I/N; auto/N takes I from Slurm (--array=0-7), Kubernetes or GNU parallel, auto both from Slurm",
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shards_are_contiguous_even_and_cover_every_row_once() {
        for (all, of) in [(0, 1), (0, 3), (1, 3), (10, 3), (7, 7), (5, 8), (u64::MAX, 7), (u64::MAX, 1 << 40)] {
            let rows = |index| Shard::new(index, of).expect("a shard").rows(all);
            let some = (0..of.min(20)).chain(of.saturating_sub(20)..of);
            for index in some {
                let next = if index + 1 < of { rows(index + 1).start } else { all };
                assert_eq!(rows(index).end, next, "{index}/{of} of {all}");
                assert!((rows(index).end - rows(index).start).abs_diff(all / of) <= 1, "{index}/{of} of {all}");
            }
            assert_eq!(rows(0).start, 0);
        }
    }
}
