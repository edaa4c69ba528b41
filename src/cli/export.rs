//! `stepwright export`: a circuit as files that other tools read.

use std::fs;
use std::path::Path;

use super::args::Target;
use super::{Ending, interrupt, print};
use crate::base::Report;
use crate::{export, files};

pub(super) fn export(target: &Target, verilog: &Path) -> Result<Ending, Report> {
    let design = target.session()?.elaborate()?;
    // The bench has no stop condition; how long the run lasts, a run tells.
    let ticks = design.start_with(Vec::new())?.cancelled_by(interrupt::flag()).finish()?.ticks;
    fs::create_dir_all(verilog).map_err(|error| files::unwritable(verilog, &error))?;
    for file in export::files(design.netlist(), design.stimulus(), ticks) {
        let path = verilog.join(file.name);
        files::write_bytes(&path, file.text.as_bytes())?;
        print(&format!("{}\n", path.display()))?;
    }
    Ok(Ending::Done)
}
