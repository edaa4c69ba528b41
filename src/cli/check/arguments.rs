//! What can be typed after `check`.

use std::path::PathBuf;

use clap::Args;

use crate::cli::args::engine;
use crate::cli::completions;
use crate::simulation::EngineKind;

/// Arguments of `check`.
#[derive(Args, Debug)]
#[command(after_help = "Examples:\n  stepwright check\n  stepwright check su1522157/table1\n  \
    stepwright check ./mine    every scenario in a folder of yours\n  \
    stepwright check --since HEAD    name the net that a change made wrong, also where the golden trace lacks it\n  \
    stepwright check --bless brm3.toml    write or rewrite the golden trace and tell what changed\n\n\
    The golden trace of circuits/A/B.toml is traces/A/B.vcd; that of a scenario in no folder `circuits` is\n\
    B.golden.vcd beside it; the key `golden` of a scenario names another place. The variable STEPWRIGHT_BLESS=1\n\
    does what --bless does.")]
pub struct CheckArguments {
    /// Scenarios and folders, by their paths or below ./circuits; all of ./circuits when none is given
    #[arg(value_name = "SCENARIO|FOLDER", add = completions::scenarios())]
    pub scenarios: Vec<PathBuf>,
    /// Rewrite the golden traces and print what changed (refused when the variable CI is set)
    #[arg(long, conflicts_with = "since")]
    pub bless: bool,
    /// Where something differs, compare every net with the netlist of this revision, out of git
    #[arg(long, value_name = "REVISION")]
    pub since: Option<String>,
    /// Engine to run on
    #[arg(long, value_name = "NAME", default_value = "auto", value_parser = engine())]
    pub engine: EngineKind,
    /// Print one JSON object
    #[arg(long)]
    pub json: bool,
}
