//! Prints the operations of FIG. 19 for the chain of docs/host.md, one a line. Run it with
//! `cargo run --example linked_chain`; with `-- --printed` it carries the slope M/K, as the patent prints it.

use stepwright::host::{Carry, Chain, Entry};

fn main() {
    let carry = if std::env::args().any(|word| word == "--printed") { Carry::AsPrinted } else { Carry::EndSlope };
    print!("{}", transcript(carry));
}

/// The chain: a section of case II, two that have no solution, one of case I.
#[must_use]
pub fn chain() -> Chain {
    Chain::new([0.0, 0.0], 4.0)
        .then(Entry::Two { p3: [20.0, 35.0], p1: [60.0, 50.0] })
        .then(Entry::Two { p3: [110.0, 55.0], p1: [150.0, 20.0] })
        .then(Entry::Two { p3: [160.0, 400.0], p1: [-50.0, 10.0] })
        .then(Entry::One { p1: [190.0, -30.0], s1: 0.0 })
}

/// Its operations.
#[must_use]
pub fn transcript(carry: Carry) -> String {
    chain().carrying(carry).flow().map(|step| format!("{step}\n")).collect()
}
