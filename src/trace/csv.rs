//! The rows of a table as CSV, written as they come, so that there may be any number of them.

use std::io::{self, Write};
use std::path::Path;

use super::table::{Rows, cell, headings};
use super::{Frame, Observer};
use crate::base::{Report, Signal, ValueId};
use crate::files::{Out, unwritable};

/// A table of a run as CSV: the heading, then a line a row. Cells are those of a [`super::Table`], but 0 for a point.
pub struct CsvTable<'o> {
    rows: Rows,
    columns: Vec<Signal>,
    name: String,
    writer: Option<::csv::Writer<Box<dyn Out + 'o>>>,
}

impl<'o> CsvTable<'o> {
    /// Those rows, into `out`.
    #[must_use]
    pub fn new(rows: Rows, out: Box<dyn Out + 'o>) -> Self {
        Self { rows, columns: Vec::new(), name: out.name(), writer: Some(::csv::Writer::from_writer(out)) }
    }

    fn write(&mut self, cells: impl Iterator<Item = String>) -> Result<(), Report> {
        let Some(writer) = &mut self.writer else { return Ok(()) };
        writer.write_record(cells).map_err(|error| {
            let error = match error.into_kind() {
                ::csv::ErrorKind::Io(error) => error,
                other => io::Error::other(format!("{other:?}")),
            };
            unwritable(Path::new(&self.name), &error).into()
        })
    }
}

impl Observer for CsvTable<'_> {
    fn wants(&self, name: &str) -> bool {
        self.rows.wants(name)
    }

    fn begin(&mut self, signals: &[Signal]) -> Result<Vec<ValueId>, Report> {
        let (columns, values) = self.rows.find(signals)?;
        self.write(headings(&columns).into_iter())?;
        self.columns = columns;
        Ok(values)
    }

    fn tick(&mut self, frame: Frame<'_>) -> Result<(), Report> {
        let Some(words) = self.rows.row(frame) else { return Ok(()) };
        let cells = words.iter().zip(&self.columns).map(|(&word, signal)| match cell(word, signal) {
            point if point == "." => "0".to_owned(),
            number => number,
        });
        let cells: Vec<_> = std::iter::once(frame.tick.to_string()).chain(cells).collect();
        self.write(cells.into_iter())
    }

    fn end(&mut self) -> Result<(), Report> {
        let Some(writer) = self.writer.take() else { return Ok(()) };
        let name = Path::new(&self.name);
        let mut out = writer.into_inner().map_err(|error| unwritable(name, error.error()))?;
        out.flush().map_err(|error| unwritable(name, &error))?;
        out.commit()
    }
}
