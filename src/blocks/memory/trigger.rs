//! Trigger: one bit that a set pulse makes 1 and a reset pulse makes 0.
//!
//! ```text
//!   set ---->[ q ]---> q
//!   reset -->[   ]---> q_inverse
//!
//!   set reset | q(t+1)
//!    0    0   |  q(t)
//!    1    0   |   1
//!    0    1   |   0
//!    1    1   |   0     reset wins
//! ```

use crate::blocks::{Block, Builder, Description, Kind, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "trigger",
    kind: Kind::Memory,
    summary: "Remembers which came last, a set pulse or a reset pulse.",
    doc: "q(t+1) = reset ? 0 : set ? 1 : q. Reset wins over set; 0 at power-on.",
    source: "SU 1522157, triggers 4 and 5 of FIG. 1",
    parameters: &[],
    ports: &[
        PortDescription::input("set", Width::BIT, "makes the trigger 1"),
        PortDescription::input("reset", Width::BIT, "makes it 0; wins over `set`"),
        PortDescription::output("q", Width::BIT, "true output"),
        PortDescription::output("q_inverse", Width::BIT, "inverse output"),
    ],
    clocked: true,
};

fn build(b: &mut Builder) {
    let (set, reset) = (b.input("set"), b.input("reset"));
    let q = b.hold(1, 0);
    let one = b.bit(true);
    let q = b.load(q, one, set, reset);
    let inverse = b.not(q);
    b.output("q", q);
    b.output("q_inverse", inverse);
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    #[test]
    fn the_trigger_follows_its_table_and_reset_wins() {
        let set_only = [(0, 0, 0, 0), (1, 0, 0, 1), (0, 1, 0, 1), (1, 1, 0, 1)];
        let with_reset = [(0, 0, 1, 0), (1, 0, 1, 0), (0, 1, 1, 0), (1, 1, 1, 0)];
        for (before, set, reset, after) in set_only.into_iter().chain(with_reset) {
            let mut bench = Bench::new("trigger", &[]);
            bench.set("set", before);
            bench.tick();
            bench.set_all(&[("set", set), ("reset", reset)]);
            assert_eq!(bench.get("q"), before as u64, "nothing changes within the tick");
            bench.tick();
            assert_eq!((bench.get("q"), bench.get("q_inverse")), (after, 1 - after), "{before} {set} {reset}");
        }
    }
}
