//! Pulse interleaver: merges two pulse trains that are never on at once, and tells when they were.
//!
//! ```text
//!   a --+--[OR]---> out
//!   b --+--[AND]--> coincident
//! ```

use crate::blocks::{Block, Builder, Description, Kind, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "pulse_interleaver",
    kind: Kind::Pulses,
    summary: "Merges two pulse trains into one and reports coincident pulses.",
    doc: "out = a or b. Two pulses at once would be counted as one, so their timing must prevent it; `coincident` = a \
          and b reports it if it happens, and must stay 0. Combinational.",
    source: "US 3,809,868, FIG. 9, pulse interleaving or summing networks 290, 292",
    parameters: &[],
    ports: &[
        PortDescription::input("a", Width::BIT, "first pulse train"),
        PortDescription::input("b", Width::BIT, "second pulse train"),
        PortDescription::output("out", Width::BIT, "both trains"),
        PortDescription::output("coincident", Width::BIT, "1 when a pulse is lost"),
    ],
    clocked: false,
};

fn build(b: &mut Builder) {
    let (first, second) = (b.input("a"), b.input("b"));
    let out = b.or(first, second);
    b.output("out", out);
    let coincident = b.and(first, second);
    b.output("coincident", coincident);
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    #[test]
    fn either_pulse_passes_and_both_at_once_are_reported() {
        let mut bench = Bench::new("pulse_interleaver", &[]);
        for (a, b, out, coincident) in [(0, 0, 0, 0), (0, 1, 1, 0), (1, 0, 1, 0), (1, 1, 1, 1)] {
            bench.set_all(&[("a", a), ("b", b)]);
            assert_eq!((bench.get("out"), bench.get("coincident")), (out, coincident));
        }
    }
}
