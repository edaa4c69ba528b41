//! `stepwright diff`: two waveform files, and where they first differ.

use std::path::Path;

use super::check::read_waveform;
use super::{Ending, print};
use crate::base::Report;
use crate::golden::{Signals, compare};

pub(super) fn diff(a: &Path, b: &Path) -> Result<Ending, Report> {
    let comparison = compare(&read_waveform(a)?, &read_waveform(b)?, Signals::All);
    print(&comparison.to_string())?;
    Ok(if comparison.is_equal() { Ending::Done } else { Ending::Different })
}
