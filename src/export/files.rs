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
    let blocks = File { name: BLOCKS.to_owned(), text: verilog([netlist]) };
    let bench = File { name: BENCH.to_owned(), text: bench(netlist, stimulus, ticks) };
    let mut files = vec![blocks, bench];
    for (path, text) in netlist.sources.iter() {
        let name = own_name(path, &files);
        files.push(File { name, text: text.to_string() });
    }
    files
}

/// A circuit file keeps its name, unless another one has it.
fn own_name(path: &str, others: &[File]) -> String {
    let mut name = path.rsplit(['/', '\\']).next().unwrap_or(path).to_owned();
    while others.iter().any(|other| other.name == name) {
        name.insert_str(0, "circuit_");
    }
    name
}
