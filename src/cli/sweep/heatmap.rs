//! The heat map of a sweep: the two things that vary, against a column of its rows.

use super::SweepArguments;
use super::plan::Plan;
use super::rows::Rows;
use crate::base::{Diagnostic, Report};
use crate::plot::HeatMap;
use crate::simulation::Row;

/// Most cells: each is a rectangle of the picture.
const MOST_CELLS: u64 = 1 << 16;

/// A map that is filled row by row.
pub struct Heat {
    map: HeatMap,
    /// Columns of a CSV row: the two that vary, and the one that is shown.
    columns: [usize; 3],
    text: String,
}

impl Heat {
    /// The empty map of a sweep.
    ///
    /// # Errors
    /// `C008` not just two things vary, or no column is named; `C070` no such column; `C071` too many cells.
    pub fn of(arguments: &SweepArguments, plan: &Plan) -> Result<Self, Report> {
        if arguments.over.len() != 2 {
            let message = format!("a heat map is of two inputs or parameters, and {} vary", arguments.over.len());
            return Err(Diagnostic::new("C008", message).help("give just two --over").into());
        }
        if plan.all() > MOST_CELLS {
            let message = format!("a heat map has at most {MOST_CELLS} cells");
            return Err(Diagnostic::new("C071", message).help("narrow a range, or take every s-th value of it").into());
        }
        let Some(column) = arguments.column.as_deref().or(arguments.measure.first().map(|measure| measure.name()))
        else {
            let wrong = Diagnostic::new("C008", "a heat map shows a column, and none is named");
            return Err(wrong.help("add --column NAME, or --measure").into());
        };
        let part = plan.first();
        let header = plan.written(part, &part.batch(arguments)?, arguments).as_csv().header().unwrap_or_default();
        let names: Vec<_> = header.trim_end().split(',').collect();
        let Some(shown) = names.iter().position(|name| *name == column) else {
            let wrong = Diagnostic::new("C070", format!("the rows have no column `{column}`"));
            return Err(wrong
                .nearest(column, names.iter().copied())
                .help(format!("they have {}", names.join(", ")))
                .into());
        };
        let circuit = part.design().circuit().name();
        let map = HeatMap {
            title: format!("{column} of {circuit}"),
            x: names[0].to_owned(),
            y: names[1].to_owned(),
            of: column.to_owned(),
            command: command(arguments, column),
            cells: Vec::new(),
        };
        Ok(Self { map, columns: [0, 1, shown], text: String::new() })
    }

    /// Puts a row into the map; one whose column is no number has no cell.
    pub fn add(&mut self, rows: &Rows<'_>, row: Row<'_>) {
        self.text.clear();
        rows.as_csv().write(row, &mut self.text);
        let fields: Vec<_> = self.text.trim_end().split(',').collect();
        let cell = self.columns.map(|column| fields.get(column).and_then(|field| field.parse().ok()));
        if let [Some(x), Some(y), Some(number)] = cell {
            self.map.cells.push([x, y, number]);
        }
    }

    /// The map.
    pub fn drawn(self) -> HeatMap {
        self.map
    }
}

/// The command that makes the map, for its foot.
fn command(arguments: &SweepArguments, column: &str) -> String {
    let target = &arguments.target;
    let over = arguments.over.iter().map(|over| format!(" --over {over}"));
    let held = target.set.iter().map(|(name, value)| format!(" -s {name}={value}"));
    let parameters = target.param.iter().map(|(name, value)| format!(" -p {name}={value}"));
    let shown = if arguments.column.is_some() { "column" } else { "measure" };
    let words: String = over.chain(held).chain(parameters).collect();
    format!("stepwright sweep {}{words} --{shown} {column} --heatmap FILE.svg", target.target.display())
}
