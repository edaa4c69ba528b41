//! A measurement with each set of parameters, one row each.

use std::fmt::Write;

use serde_json::{Map, Value, json};

use super::super::sweep::sets;
use super::{AccuracyArguments, Measured, of_circuit, session};
use crate::base::{Diagnostic, Report};

/// A row for each set of parameters.
pub struct Table {
    name: String,
    rows: Vec<Row>,
}

struct Row {
    /// Parameters, then what was measured.
    columns: Vec<(String, Value)>,
    is_good: bool,
}

/// Measures with every set of the parameters that vary.
///
/// # Errors
/// `C008` what is no parameter, and all that one measurement can meet.
pub fn over(arguments: &AccuracyArguments) -> Result<Table, Report> {
    if let Some(over) = arguments.over.iter().find(|over| !over.name.starts_with("p:")) {
        let message = format!("--over {}: accuracy takes all inputs there are by itself", over.name);
        return Err(Diagnostic::new("C008", message).help("put p: before the name of a parameter").into());
    }
    let sets = sets(&arguments.over, &arguments.param)?;
    let session = session(arguments)?;
    let mut table = Table { name: session.circuit().name().to_owned(), rows: Vec::new() };
    for (i, set) in sets.into_iter().enumerate() {
        let session = set.iter().fold(session.clone(), |session, (name, value)| session.parameter(name, *value));
        // Interrupted: what is whole is shown.
        let Some(measured) = of_circuit(arguments, session, i == 0)? else { break };
        let parameters = set.into_iter().map(|(name, value)| (name, value.into()));
        let summary = measured.summary().into_iter().map(|(name, value)| (name.to_owned(), value));
        table.rows.push(Row { columns: parameters.chain(summary).collect(), is_good: measured.is_good() });
    }
    Ok(table)
}

impl Table {
    fn header(&self) -> impl Iterator<Item = &str> {
        self.rows.first().into_iter().flat_map(|row| row.columns.iter().map(|(name, _)| name.as_str()))
    }

    fn lines(&self, separator: &str, mut cell: impl FnMut(usize, String) -> String) -> String {
        let mut text = String::new();
        let header = self.header().map(str::to_owned).collect::<Vec<_>>();
        let rows = self.rows.iter().map(|row| row.columns.iter().map(|(_, value)| shown(value)).collect::<Vec<_>>());
        for line in std::iter::once(header).chain(rows) {
            let cells: Vec<_> = line.into_iter().enumerate().map(|(column, text)| cell(column, text)).collect();
            // Writing into a string cannot fail.
            let _ = writeln!(text, "{}", cells.join(separator));
        }
        text
    }
}

/// Enough digits of a number for a table.
pub fn shown(value: &Value) -> String {
    match value {
        Value::Number(number) if number.is_f64() => format!("{:.6}", number.as_f64().unwrap_or(0.0)),
        Value::Null => String::new(),
        other => other.to_string(),
    }
}

impl Measured for Table {
    fn text(&self) -> String {
        let widths: Vec<_> = self.header().map(|name| name.len().max(9)).collect();
        format!("{}\n\n", self.name)
            + &self.lines("  ", |column, text| format!("{text:>width$}", width = widths[column]))
    }

    fn csv(&self) -> String {
        self.lines(",", |_, text| text)
    }

    fn json(&self) -> Value {
        let object = |row: &Row| Value::Object(row.columns.iter().cloned().collect::<Map<_, _>>());
        let rows: Vec<_> = self.rows.iter().map(object).collect();
        json!({ "format": 1, "command": "accuracy", "circuit": self.name, "rows": rows })
    }

    fn summary(&self) -> Vec<(&'static str, Value)> {
        Vec::new()
    }

    fn is_good(&self) -> bool {
        self.rows.iter().all(|row| row.is_good)
    }
}
