//! What a run is to make besides its result: waveforms, a save file, tables, a picture.

use std::path::PathBuf;

use super::args::RunArguments;
use crate::base::{Diagnostic, Report};
use crate::files::{Output, is_standard_output, seen_from};
use crate::scenario::{Axis, Plot, Scenario};
use crate::simulation::Design;
use crate::trace::{
    Coordinate, CsvTable, FORMATS, Format, Last, Observer, Path, Rows, SaveFile, Select, Table, Wave, When, Window,
};

/// The observers that were asked for. Table and path are looked at when the run is over.
pub(super) struct Observers {
    pub table: Option<Table>,
    pub path: Option<Path>,
    waves: Vec<(&'static Format, PathBuf)>,
    select: Select,
    window: Window,
    last: Option<u64>,
    when: Vec<String>,
    save: Option<PathBuf>,
    curves: Vec<String>,
    csv: Option<(PathBuf, Rows)>,
}

impl Observers {
    /// Those of the arguments and of the scenario.
    ///
    /// # Errors
    /// `W001` what is no glob, `W005` a waveform's ending, `C008` options that contradict each other.
    pub fn new(arguments: &RunArguments, design: &Design) -> Result<Self, Report> {
        let scenario = design.scenario();
        let window = Window { from: arguments.from.unwrap_or(0), to: arguments.to.unwrap_or(u64::MAX) };
        if window.from > window.to {
            let message = format!("--from {} is after --to {}: no tick is between them", window.from, window.to);
            return Err(Diagnostic::new("C008", message).help("--from is the first tick, --to the last one").into());
        }
        let (last, _) = design.stimulus().last_tick();
        if window.from > last {
            let message = format!("--from {} is after the last tick, which is {last} at most", window.from);
            return Err(Diagnostic::new("C008", message).help("run for longer, or begin earlier").into());
        }
        let plot = scenario.plot.as_ref().filter(|_| arguments.plot || !arguments.json);
        if arguments.plot && plot.is_none() {
            let diagnostic = Diagnostic::new("C008", "there is nothing to plot: the scenario has no [plot]");
            return Err(diagnostic.help("[plot] names two signals: x = \"x\", y = \"y\"").into());
        }
        let mut waves = Vec::new();
        for path in &arguments.wave {
            waves.push((Format::of(path)?, path.clone()));
        }
        for (ending, path) in [("vcd", &arguments.vcd), ("fst", &arguments.fst)] {
            let format = FORMATS.iter().find(|format| format.ending == ending);
            waves.extend(format.copied().zip(path.clone()));
        }
        Ok(Self {
            table: arguments.table.then(|| Table::new(rows(arguments, design))),
            path: plot.map(path_of),
            waves,
            select: selection(&arguments.trace, scenario)?,
            window,
            last: arguments.last,
            when: arguments.when.clone(),
            save: arguments.gtkw.clone(),
            curves: scenario.plot.iter().flat_map(Plot::names).map(str::to_owned).collect(),
            csv: arguments.csv.clone().map(|path| (path, rows(arguments, design))),
        })
    }

    /// All of them; files are opened here.
    ///
    /// # Errors
    /// `C003` a file that cannot be written.
    pub fn all(&mut self) -> Result<Vec<Box<dyn Observer + '_>>, Report> {
        let mut all: Vec<Box<dyn Observer>> = Vec::new();
        for (format, path) in &self.waves {
            let wave = Wave::new(format, Box::new(Output::create(path)?));
            let wave = wave.of(self.select.clone()).within(self.window);
            all.push(match (self.last, self.when.as_slice()) {
                (Some(ticks), _) => Box::new(Last::new(ticks, wave)),
                (None, []) => Box::new(wave),
                (None, nets) => Box::new(When::new(nets.to_vec(), wave)),
            });
        }
        if let (Some(path), Some((_, dump))) = (&self.save, self.waves.first()) {
            let out = Box::new(Output::create(path)?);
            all.push(Box::new(SaveFile::new(self.select.clone(), seen_from(path, dump), self.curves.clone(), out)));
        }
        if let Some((path, rows)) = &self.csv {
            all.push(Box::new(CsvTable::new(rows.clone(), Box::new(Output::create(path)?))));
        }
        all.extend(self.table.as_mut().map(|table| Box::new(table) as Box<dyn Observer>));
        all.extend(self.path.as_mut().map(|path| Box::new(path) as Box<dyn Observer>));
        Ok(all)
    }

    /// The files that they write.
    pub fn files(&self) -> impl Iterator<Item = &std::path::Path> {
        let waves = self.waves.iter().map(|(_, path)| path);
        waves.chain(&self.save).chain(self.csv.iter().map(|(path, _)| path)).map(PathBuf::as_path)
    }

    /// Whether standard output is taken by one of them.
    pub fn take_standard_output(&self) -> bool {
        self.files().any(is_standard_output)
    }
}

/// The signals to trace: what was typed, else what the scenario says, else all.
pub(super) fn selection(typed: &[String], scenario: &Scenario) -> Result<Select, Report> {
    let said: Vec<_> = scenario.trace.iter().map(|glob| glob.name.clone()).collect();
    match (typed, said.as_slice()) {
        ([], []) => Ok(Select::all()),
        ([], said) => Select::new(said),
        (typed, _) => Select::new(typed),
    }
}

/// What was typed, else the scenario's table; without one, every input and output at every tick.
fn rows(arguments: &RunArguments, design: &Design) -> Rows {
    let said = design.scenario().table.as_ref();
    let mut columns = arguments.columns.clone();
    if columns.is_empty() {
        columns = said.iter().flat_map(|table| &table.columns).map(|column| column.name.clone()).collect();
    }
    if columns.is_empty() {
        columns = design.inputs().chain(design.outputs()).map(|port| port.name.clone()).collect();
    }
    if !arguments.when.is_empty() {
        return Rows::new(columns, arguments.when.clone());
    }
    let when = said.iter().flat_map(|table| &table.when).map(|net| net.name.clone()).collect();
    Rows::new(columns, when).after(said.map_or(0, |table| table.after))
}

fn path_of(plot: &Plot) -> Path {
    let coordinate = |axis: &Axis| match axis {
        Axis::Signal(signal) => Coordinate::Signal(signal.name.clone()),
        Axis::Steps(steps) => Coordinate::Steps(steps.iter().map(|step| (step.name.clone(), step.value)).collect()),
    };
    Path::new([coordinate(&plot.x), coordinate(&plot.y)], plot.pen.as_ref().map(|pen| pen.name.clone()))
}
