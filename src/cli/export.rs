//! `stepwright export`: a circuit as files that other tools read.

use std::fs;
use std::path::Path;
use std::sync::Arc;

use super::args::Target;
use super::prepare;
use super::{Ending, files, print};
use crate::base::Report;
use crate::compile::{Observe, compile};
use crate::engine::EngineKind;
use crate::export::{self, BenchInputs};
use crate::simulation;

pub(super) fn export(target: &Target, verilog: &Path) -> Result<Ending, Report> {
    let prepared = prepare::prepare(target)?;
    let stimulus = &prepared.stimulus;
    // The bench has no stop condition; how long the run lasts, a run tells.
    let program = Arc::new(compile(&prepared.netlist, &Observe { until: stimulus.stop.until, ..Observe::OUTPUTS }));
    let mut engine = EngineKind::Auto.build(Arc::clone(&program), stimulus.stop.ticks)?;
    let ticks = simulation::run(engine.as_mut(), &program, stimulus, None).ticks;
    let inputs = BenchInputs { initial: &stimulus.initial, changes: &stimulus.changes, ticks };
    fs::create_dir_all(verilog).map_err(|error| files::unwritable(verilog, &error))?;
    for file in export::files(&prepared.netlist, inputs) {
        let path = verilog.join(file.name);
        files::write_bytes(&path, file.text.as_bytes())?;
        print(&format!("{}\n", path.display()));
    }
    Ok(Ending::Done)
}
