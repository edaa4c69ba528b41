//! The waveform files of a run, written while it runs.

use std::io;
use std::path::{Path, PathBuf};

use super::args::RunArguments;
use super::files::{self, Output};
use crate::base::{Report, Signal, ValueId};
use crate::engine::Engine;
use crate::trace::{FstWriter, Plan, Sampler, VcdWriter, Window};

/// VCD and FST under way.
pub(super) struct Waves {
    sampler: Sampler,
    vcd: Option<(PathBuf, VcdWriter<Output>)>,
    fst: Option<(PathBuf, FstWriter<Output>)>,
    /// The first error of writing; later ones follow from it.
    failed: Option<Report>,
}

impl Waves {
    /// Opens what was asked for; `None` when nothing was.
    ///
    /// # Errors
    /// `C003`.
    pub fn open(arguments: &RunArguments, signals: &[Signal]) -> Result<Option<Self>, Report> {
        if arguments.vcd.is_none() && arguments.fst.is_none() {
            return Ok(None);
        }
        let plan = Plan::new(signals);
        let window = Window { from: arguments.from.unwrap_or(0), to: arguments.to.unwrap_or(u64::MAX) };
        Ok(Some(Self {
            sampler: Sampler::new(&plan, window),
            vcd: open(arguments.vcd.as_deref(), |out| VcdWriter::new(out, &plan))?,
            fst: open(arguments.fst.as_deref(), |out| FstWriter::new(out, &plan))?,
            failed: None,
        }))
    }

    /// The values that an engine has to watch before [`Waves::sample`].
    pub fn values(&self) -> &[ValueId] {
        self.sampler.values()
    }

    /// Takes the values of a tick.
    pub fn sample(&mut self, tick: u64, engine: &dyn Engine) {
        if self.failed.is_some() {
            return;
        }
        let Some(changes) = self.sampler.sample_all(tick, |words| engine.read(words)) else { return };
        let vcd = self.vcd.as_mut().map(|(path, vcd)| (path, vcd.tick(tick, changes)));
        let fst = self.fst.as_mut().map(|(path, fst)| (path, fst.tick(tick, changes)));
        for (path, result) in [vcd, fst].into_iter().flatten() {
            if let Err(error) = result {
                self.failed = Some(files::unwritable(path, &error).into());
            }
        }
    }

    /// Closes the files and gives them their names.
    ///
    /// # Errors
    /// `C003`, from here or from any tick before; no file is left behind then.
    pub fn finish(self) -> Result<(), Report> {
        if let Some(failed) = self.failed {
            return Err(failed);
        }
        if let Some((path, vcd)) = self.vcd {
            vcd.finish().map_err(|error| files::unwritable(&path, &error))?.finish()?;
        }
        if let Some((path, fst)) = self.fst {
            fst.finish().map_err(|error| files::unwritable(&path, &error))?.finish()?;
        }
        Ok(())
    }
}

fn open<W>(path: Option<&Path>, writer: impl FnOnce(Output) -> io::Result<W>) -> Result<Option<(PathBuf, W)>, Report> {
    let Some(path) = path else { return Ok(None) };
    let out = Output::create(path)?;
    let writer = writer(out).map_err(|error| files::unwritable(path, &error))?;
    Ok(Some((path.to_owned(), writer)))
}
