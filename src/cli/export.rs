//! `stepwright export`: a circuit as files that other tools read.

use std::fs::{self, File};
use std::io::Read;
use std::path::{Path, PathBuf};

use super::args::Target;
use super::{Ending, check_files, interrupt, print, say};
use crate::base::{Diagnostic, Report, Sources};
use crate::simulation::StoppedBy;
use crate::{export, files};

pub(super) fn export(target: &Target, verilog: &Path) -> Result<Ending, Report> {
    let design = target.session()?.elaborate()?;
    let paths: Vec<_> = export::names(design.netlist()).iter().map(|name| verilog.join(name)).collect();
    check_files(design.files().iter().map(PathBuf::as_path), paths.iter().map(PathBuf::as_path))?;
    spare_foreign(&paths)?;
    // The bench has no stop condition; how long the run lasts, a run tells.
    let outcome = design.start_with(Vec::new())?.cancelled_by(interrupt::flag()).finish()?;
    if outcome.stopped_by == StoppedBy::Interrupt {
        say("interrupted before anything was written");
        return Ok(Ending::Different);
    }
    fs::create_dir_all(verilog).map_err(|error| files::unwritable(verilog, &error))?;
    let written = export::files(design.netlist(), design.stimulus(), outcome.ticks);
    for (path, file) in paths.iter().zip(written) {
        files::write_bytes(path, file.text.as_bytes())?;
        print(&format!("{}\n", path.display()))?;
    }
    Ok(Ending::Done)
}

/// Refuses to overwrite what `export` has not written itself.
///
/// # Errors
/// `C032`, for each such file.
fn spare_foreign(paths: &[PathBuf]) -> Result<(), Report> {
    let foreign = paths.iter().filter(|path| path.is_file() && !is_ours(path));
    let refused = foreign.map(|path| {
        let message = format!("{} is there already, and `export` has not written it", path.display());
        Diagnostic::new("C032", message).help("export into another folder, or move the file away")
    });
    let refused: Vec<_> = refused.collect();
    if refused.is_empty() { Ok(()) } else { Err(Report::new(Sources::default(), refused)) }
}

fn is_ours(path: &Path) -> bool {
    let mut beginning = Vec::new();
    let most = export::MARK.len() as u64;
    let read = File::open(path).and_then(|file| file.take(most).read_to_end(&mut beginning));
    read.is_ok() && beginning == export::MARK.as_bytes()
}
