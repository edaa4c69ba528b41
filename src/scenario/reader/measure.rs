//! The table `[measure]` of a scenario.

use super::{Number, Reader, Value};
use crate::scenario::model::{Law, Measure};

impl Reader {
    pub(super) fn measure(&mut self, value: &Value<'_>) -> Option<Measure> {
        let (mut of, mut major, mut minor, mut combined, mut end) = (None, None, None, None, None);
        let (mut law, mut printed) = (None, None);
        let table = self.table(value)?;
        self.keys_of("measure", table, |reader, key, value| match key {
            "of" => of = reader.text(value),
            "major" => major = reader.one_name(value),
            "minor" => minor = reader.one_name(value),
            "combined" => combined = reader.number(value).map(Number::to_f64),
            "end" => end = reader.number(value).map(Number::to_f64),
            "law" => law = reader.two(value, ["sin", "cos"]).map(|[sin, cos]| Law { sin, cos }),
            _ => printed = reader.two(value, ["amplitude", "degrees"]),
        });
        if ["of", "major", "minor", "combined", "law", "end"].iter().any(|key| !table.contains_key(*key)) {
            self.missing(value, "a [measure] needs `of`, `major`, `minor`, `combined`, `law` and `end`");
        }
        Some(Measure { of: of?, major: major?, minor: minor?, combined: combined?, law: law?, printed, end: end? })
    }

    /// A table of just two numbers of these names.
    fn two(&mut self, value: &Value<'_>, names: [&str; 2]) -> Option<[f64; 2]> {
        let mut numbers = [None; 2];
        let table = self.table(value)?;
        self.keys(table, &names, |reader, key, value| {
            let place = usize::from(key == names[1]);
            numbers[place] = reader.number(value).map(Number::to_f64);
        });
        if names.iter().any(|name| !table.contains_key(*name)) {
            self.missing(value, &format!("both `{}` and `{}` are needed here", names[0], names[1]));
        }
        Some([numbers[0]?, numbers[1]?])
    }
}
