//! A waveform file that is written while a circuit runs.

use std::io;
use std::path::Path;

use super::writer::WaveWriter;
use super::{Format, Frame, Observer, Plan, Sampler, Select, Window};
use crate::base::{Report, Signal, ValueId};
use crate::files::{self, Out, Output};

/// Writes chosen signals as a waveform, in the format that the file's name tells.
pub struct Wave<'o> {
    format: &'static Format,
    name: String,
    select: Select,
    window: Window,
    state: State<'o>,
}

enum State<'o> {
    New(Box<dyn Out + 'o>),
    Running(Box<dyn WaveWriter<'o> + 'o>, Sampler),
    Over,
}

impl Wave<'static> {
    /// The waveform of all signals, into the file `path`; `-` is standard output. Nothing stands under that name
    /// before the waveform is whole.
    ///
    /// # Errors
    /// `W005` an ending that is no format's, `C003` a file that cannot be written.
    pub fn create(path: impl AsRef<Path>) -> Result<Self, Report> {
        let path = path.as_ref();
        Ok(Self::new(Format::of(path)?, Box::new(Output::create(path)?)))
    }
}

impl<'o> Wave<'o> {
    /// The waveform of all signals in a format of choice.
    #[must_use]
    pub fn new(format: &'static Format, out: Box<dyn Out + 'o>) -> Self {
        Self { format, name: out.name(), select: Select::all(), window: Window::ALL, state: State::New(out) }
    }

    /// The same waveform of just the signals of `select`.
    #[must_use]
    pub fn of(self, select: Select) -> Self {
        Self { select, ..self }
    }

    /// The same waveform of just the ticks of `window`.
    #[must_use]
    pub fn within(self, window: Window) -> Self {
        Self { window, ..self }
    }

    fn failed(&self, error: &io::Error) -> Report {
        files::unwritable(Path::new(&self.name), error).into()
    }
}

impl Observer for Wave<'_> {
    fn wants(&self, name: &str) -> bool {
        self.select.matches(name)
    }

    fn begin(&mut self, signals: &[Signal]) -> Result<Vec<ValueId>, Report> {
        let plan = Plan::new(&self.select.of(signals)?);
        let sampler = Sampler::new(&plan, self.window);
        let values = plan.slots().iter().map(|slot| slot.value).collect();
        let State::New(out) = std::mem::replace(&mut self.state, State::Over) else { return Ok(values) };
        let writer = (self.format.begin)(out, &plan).map_err(|error| self.failed(&error))?;
        self.state = State::Running(writer, sampler);
        Ok(values)
    }

    fn tick(&mut self, frame: Frame<'_>) -> Result<(), Report> {
        let State::Running(writer, sampler) = &mut self.state else { return Ok(()) };
        let Some(changes) = sampler.sample(frame) else { return Ok(()) };
        writer.tick(frame.tick, changes).map_err(|error| self.failed(&error))
    }

    fn end(&mut self) -> Result<(), Report> {
        let State::Running(writer, _) = std::mem::replace(&mut self.state, State::Over) else { return Ok(()) };
        writer.finish().map_err(|error| self.failed(&error))?.commit()
    }
}
