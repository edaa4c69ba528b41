//! Everything another simulator needs, as files of one folder.

use super::bench::bench;
use super::module::verilog;
use crate::base::Stimulus;
use crate::netlist::Netlist;

/// A text to be written into a file.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct File {
    /// File name without a folder.
    pub name: String,
    /// What it holds.
    pub text: String,
}

const BLOCKS: &str = "blocks.v";
const BENCH: &str = "bench.v";

/// The circuit's own files as they are, `blocks.v` with the blocks they use, and `bench.v` that drives them through
/// `ticks` ticks of `stimulus`.
#[must_use]
pub fn files(netlist: &Netlist, stimulus: &Stimulus, ticks: u64) -> Vec<File> {
    let circuit = netlist.sources.iter().map(|(path, text)| File { name: own_name(path), text: text.to_string() });
    let blocks = File { name: BLOCKS.to_owned(), text: verilog([netlist]) };
    let bench = File { name: BENCH.to_owned(), text: bench(netlist, stimulus, ticks) };
    [blocks, bench].into_iter().chain(circuit).collect()
}

/// A circuit file keeps its name, unless it is one of ours.
fn own_name(path: &str) -> String {
    let name = path.rsplit(['/', '\\']).next().unwrap_or(path);
    if [BLOCKS, BENCH].contains(&name) { format!("circuit_{name}") } else { name.to_owned() }
}
