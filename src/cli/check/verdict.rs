//! What came of checking scenarios, as lines for a person or as one JSON object.

use std::collections::HashMap;
use std::path::{Path, PathBuf};

use serde_json::{Value, json};

use crate::cli::Ending;
use crate::cli::diff::cause;
use crate::cli::result::json as line;
use crate::golden::Cause;

/// What came of one scenario.
pub(super) struct Verdict {
    pub scenario: PathBuf,
    pub golden: PathBuf,
    pub kind: Kind,
    /// More about it, for a person.
    pub text: String,
    /// The expectations that failed.
    pub failed: Vec<String>,
    /// The first difference from the golden trace, as `diff` has it.
    pub first: Value,
    /// The nets that first went wrong.
    pub causes: Vec<Cause>,
}

/// How a scenario did.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    /// Its golden trace and expectations are met.
    Equal,
    /// Its golden trace has been written.
    Blessed,
    /// It did something else.
    Different,
    /// It is gone, and its golden trace is still there.
    Lost,
    /// It could not be run.
    Broken,
}

impl Kind {
    fn name(self) -> &'static str {
        match self {
            Self::Equal => "equal",
            Self::Blessed => "blessed",
            Self::Different => "different",
            Self::Lost => "lost",
            Self::Broken => "broken",
        }
    }
}

impl Verdict {
    pub fn new(scenario: &Path, golden: PathBuf, kind: Kind) -> Self {
        let scenario = scenario.to_owned();
        Self { scenario, golden, kind, text: String::new(), failed: Vec::new(), first: Value::Null, causes: Vec::new() }
    }

    /// The lines for a person.
    pub fn lines(&self) -> String {
        let (scenario, golden, text) = (self.scenario.display(), self.golden.display(), &self.text);
        match self.kind {
            Kind::Equal => format!("ok       {scenario} ({text})\n"),
            Kind::Blessed => format!("blessed  {scenario}\n{}\n", indented(text)),
            Kind::Different => format!("DIFFERS  {scenario}\n{}\n", indented(text)),
            Kind::Lost => format!("LOST     {golden}: its scenario is gone\n"),
            Kind::Broken => format!("BROKEN   {scenario}\n"),
        }
    }

    fn object(&self) -> Value {
        json!({
            "scenario": self.scenario,
            "golden": self.golden,
            "result": self.kind.name(),
            "failed": self.failed,
            "first": self.first,
            "causes": self.causes.iter().map(cause).collect::<Vec<_>>(),
            "text": self.text,
        })
    }
}

/// Adds to the text of every verdict its causes; where the first cause has been told already, that is all there is to
/// say.
pub(super) fn tell_causes_once(verdicts: &mut [Verdict]) {
    let mut told: HashMap<String, PathBuf> = HashMap::new();
    for verdict in verdicts {
        let Some(first) = verdict.causes.first() else { continue };
        match told.get(&first.place) {
            Some(before) if !first.place.is_empty() => {
                let again = format!("{} went wrong, which is told at {}", first.place, before.display());
                verdict.text = verdict.failed.iter().cloned().chain([again]).collect::<Vec<_>>().join("\n");
            }
            _ => {
                verdict.text =
                    verdict.causes.iter().fold(verdict.text.clone(), |text, cause| format!("{text}\n{cause}"));
                told.insert(first.place.clone(), verdict.scenario.clone());
            }
        }
    }
}

/// How many there are of each kind; a golden trace whose scenario is gone counts as a difference.
struct Tally {
    equal: usize,
    blessed: usize,
    different: usize,
    broken: usize,
}

impl Tally {
    fn of(verdicts: &[Verdict]) -> Self {
        let count = |kind| verdicts.iter().filter(|verdict| verdict.kind == kind).count();
        Self {
            equal: count(Kind::Equal),
            blessed: count(Kind::Blessed),
            different: count(Kind::Different) + count(Kind::Lost),
            broken: count(Kind::Broken),
        }
    }
}

/// The last line for a person.
pub(super) fn last_line(verdicts: &[Verdict]) -> String {
    let Tally { equal, blessed, different, broken } = Tally::of(verdicts);
    format!("{equal} equal, {blessed} blessed, {different} different, {broken} broken\n")
}

/// All of it as one JSON object.
pub(super) fn object(verdicts: &[Verdict]) -> String {
    let Tally { equal, blessed, different, broken } = Tally::of(verdicts);
    let scenarios: Vec<_> = verdicts.iter().map(Verdict::object).collect();
    let counts = json!({
        "equal": equal, "blessed": blessed, "different": different, "broken": broken, "scenarios": scenarios,
    });
    line("check", counts)
}

/// How the command ends.
pub(super) fn ending(verdicts: &[Verdict]) -> Ending {
    match Tally::of(verdicts) {
        Tally { different: 0, broken: 0, .. } => Ending::Done,
        Tally { broken: 0, .. } => Ending::Different,
        _ => Ending::Wrong,
    }
}

fn indented(text: &str) -> String {
    text.lines().map(|line| format!("    {line}")).collect::<Vec<_>>().join("\n")
}
