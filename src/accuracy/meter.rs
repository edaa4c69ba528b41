//! A circuit with a meter behind it: segments in, frames out, many at once.

use std::ops::ControlFlow;
use std::sync::atomic::AtomicBool;

use super::{Claim, Frame, Printed, Segments, count};
use crate::base::word::{mask, signed};
use crate::base::{Diagnostic, Port, Report, StoppedBy};
use crate::scenario::Measure;
use crate::simulation::{Batch, Design, Row, Session};

/// A measuring circuit, made ready: the session's scenario has a table `[measure]`.
#[derive(Debug)]
pub struct Meter {
    design: Design,
    measure: Measure,
    columns: Columns,
}

/// Where in a row everything stands.
#[derive(Clone, Copy, Debug)]
struct Columns {
    major: usize,
    minor: usize,
    greatest: Output,
    left_major: Output,
    left_minor: Output,
    longest_run: Output,
    /// Quarters of a combined step.
    combined: u64,
}

#[derive(Clone, Copy, Debug)]
struct Output {
    place: usize,
    width: u32,
}

impl Output {
    fn signed(self, row: &Row<'_>) -> i64 {
        signed(row.outputs[self.place], self.width)
    }
}

impl Meter {
    /// The meter of a session.
    ///
    /// # Errors
    /// All that is wrong with circuit and scenario; `A001` a scenario without `[measure]`; `S010`, `S012` inputs and outputs
    /// that a meter needs and the circuit does not have; `A003` combined steps that are not 1 to 4 quarters long.
    pub fn of(session: Session) -> Result<Self, Report> {
        let design = session.elaborate()?;
        let Some(measure) = design.scenario().measure.clone() else {
            let message =
                format!("nothing measures `{}`: its scenario has no table [measure]", design.circuit().name());
            return Err(Diagnostic::new("A001", message).into());
        };
        let columns = Columns::find(&design.batch(), &measure)?;
        Ok(Self { design, measure, columns })
    }

    /// What it measures, and on which circuit.
    #[must_use]
    pub fn design(&self) -> &Design {
        &self.design
    }

    /// What frames are held against.
    #[must_use]
    pub fn claim(&self) -> Claim {
        let Measure { law, printed, end, .. } = self.measure;
        Claim { law, printed: printed.map(|[amplitude, degrees]| Printed { amplitude, degrees }), end }
    }

    /// The greatest projection that its inputs can hold.
    #[must_use]
    pub fn greatest_projection(&self) -> u64 {
        let width = |place: usize| self.design.inputs().nth(place).map_or(0, |net| net.width);
        mask(width(self.columns.major).min(width(self.columns.minor)))
    }

    /// The frame that a row of the design's batch tells of.
    #[must_use]
    pub fn frame(&self, row: &Row<'_>) -> Frame {
        self.columns.frame(row)
    }

    /// Runs all segments up to `max` from number `skip` on, and gives each frame to `sink`, in order, with how its run
    /// ended and how many ticks it had.
    ///
    /// # Errors
    /// `A002` a projection that the inputs cannot hold; `C067`; when the threads cannot be started.
    pub fn run(
        &self,
        max: u64,
        skip: u64,
        threads: Option<usize>,
        cancel: &AtomicBool,
        mut sink: impl FnMut(Frame, StoppedBy, u64) -> ControlFlow<()> + Send,
    ) -> Result<(), Report> {
        let most = self.greatest_projection();
        if max > most || count(max).is_none() {
            let message = format!("a projection of {max} is more than the circuit's inputs hold");
            return Err(Diagnostic::new("A002", message).help(format!("they hold up to {most}")).into());
        }
        let mut batch = self.design.batch().without_pulses().cancelled_by(cancel);
        if let Some(threads) = threads {
            batch = batch.threads(threads)?;
        }
        let mut segments = Segments::from(max, skip);
        let columns = self.columns;
        let feed = move |words: &mut [u64]| {
            let segment = segments.next();
            if let Some((major, minor)) = segment {
                (words[columns.major], words[columns.minor]) = (major, minor);
            }
            segment.is_some()
        };
        batch.run(feed, |row: Row<'_>| sink(columns.frame(&row), row.stopped_by, row.ticks)).map(|_| ())
    }
}

impl Columns {
    fn find(batch: &Batch<'_>, measure: &Measure) -> Result<Self, Report> {
        let quarters = measure.combined * 4.0;
        if ![1.0, 2.0, 3.0, 4.0].contains(&quarters) {
            let message = format!("a combined step of {} is not 1 to 4 quarters of a whole one", measure.combined);
            return Err(Diagnostic::new("A003", message).help("a deviation_meter counts quarters").into());
        }
        Ok(Self {
            major: batch.input(&measure.major.name)?.place(),
            minor: batch.input(&measure.minor.name)?.place(),
            greatest: output(batch, "greatest")?,
            left_major: output(batch, "left_major")?,
            left_minor: output(batch, "left_minor")?,
            longest_run: output(batch, "longest_run")?,
            combined: quarters as u64,
        })
    }

    fn frame(&self, row: &Row<'_>) -> Frame {
        let [left_major, left_minor] = [self.left_major, self.left_minor].map(|output| output.signed(row));
        let (major, minor) = (row.inputs[self.major], row.inputs[self.minor]);
        let gone = |projection: u64, left: i64| (4 * projection).saturating_add_signed(left.saturating_neg());
        let (along, across) = (gone(major, left_major), gone(minor, left_minor));
        Frame {
            major,
            minor,
            greatest: row.outputs[self.greatest.place],
            left_major,
            left_minor,
            steps: across / self.combined + along.saturating_sub(across) / 4,
            longest_run: row.outputs[self.longest_run.place],
        }
    }
}

fn output(batch: &Batch<'_>, name: &str) -> Result<Output, Diagnostic> {
    let found = batch.outputs().iter().position(|port| port.name == name);
    let output = |place: usize| Output { place, width: batch.outputs()[place].width };
    found.map(output).ok_or_else(|| {
        let names = batch.outputs().iter().map(|port: &Port| port.name.as_str());
        let wrong = Diagnostic::new("S012", format!("the circuit has no output `{name}`")).nearest(name, names);
        wrong.help("a measuring circuit has the outputs of its deviation_meter, under their names")
    })
}
