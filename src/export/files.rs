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

/// How the first line of every file begins, by which they are known again.
pub const MARK: &str = "// Written by Stepwright";

const BLOCKS: &str = "blocks.v";
const BENCH: &str = "bench.v";

/// The names of the files of a circuit, in the order of [`files`]. A circuit file keeps its name, unless another one has
/// it.
#[must_use]
pub fn names(netlist: &Netlist) -> Vec<String> {
    let mut names = vec![BLOCKS.to_owned(), BENCH.to_owned()];
    for (path, _) in netlist.sources.iter() {
        let mut name = path.rsplit(['/', '\\']).next().unwrap_or(path).to_owned();
        while names.contains(&name) {
            name.insert_str(0, "circuit_");
        }
        names.push(name);
    }
    names
}

/// The circuit's own files as they are, `blocks.v` with the blocks they use, and `bench.v` that drives them through
/// `ticks` ticks of `stimulus`; before each a line that begins with [`MARK`].
#[must_use]
pub fn files(netlist: &Netlist, stimulus: &Stimulus, ticks: u64) -> Vec<File> {
    let own = netlist.sources.iter().map(|(_, text)| text.to_string());
    let texts = [verilog([netlist]), bench(netlist, stimulus, ticks)].into_iter().chain(own);
    let marked = |text| format!("{MARK}; `stepwright export` overwrites it.\n{text}");
    names(netlist).into_iter().zip(texts).map(|(name, text)| File { name, text: marked(text) }).collect()
}
