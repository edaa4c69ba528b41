//! `stepwright diff`: two waveform files, and where they first differ.

use std::path::Path;

use super::{Ending, print};
use crate::base::Report;
use crate::golden::{self, How, Input};

pub(super) fn diff(a: &Path, b: &Path) -> Result<Ending, Report> {
    let found = golden::diff(&Input::file(a), &Input::file(b), &How::default())?;
    print(&found.comparison.to_string())?;
    Ok(if found.comparison.is_equal() { Ending::Done } else { Ending::Different })
}
