//! Binary counter: counts pulses, tells its overflow, and is cleared.

use crate::blocks::{Block, Builder, Description, Kind, Parameter, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "binary_counter",
    kind: Kind::Memory,
    summary: "Counts strobes modulo 2^WIDTH and gives an overflow that drives the next counter.",
    doc: "count(t+1) = clear ? 0 : step ? count + 1 : count. `overflow` = step while all bits are 1, so that counters \
          in a row step together.",
    source: "US 3,809,868, FIG. 10, counters 336, 335, 337",
    parameters: &[Parameter { name: "WIDTH", default: 6, min: 1, max: 32, doc: "bits of the count" }],
    ports: &[
        PortDescription::input("clear", Width::BIT, "sets the count to 0; wins over counting"),
        PortDescription::input("step", Width::BIT, "counts at the end of each tick in which it is 1"),
        PortDescription::output("count", Width::Param("WIDTH"), "present count"),
        PortDescription::output("overflow", Width::BIT, "1 while the count goes from its last state to 0"),
    ],
    clocked: true,
};

fn build(b: &mut Builder) {
    let width = b.count("WIDTH");
    let (step, clear) = (b.input("step"), b.input("clear"));
    let count = b.hold(width, 0);
    let one = b.constant(1, width);
    let next = b.add(count.q, one);
    b.load(count, next, step, clear);
    b.output("count", count.q);
    let last = b.reduce_and(count.q);
    let overflow = b.and(step, last);
    b.output("overflow", overflow);
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    #[test]
    fn it_counts_modulo_its_states_and_overflows_on_the_last() {
        let mut bench = Bench::new("binary_counter", &[("WIDTH", 2)]);
        bench.set("step", 1);
        for i in 0..12 {
            assert_eq!((bench.get("count"), bench.get("overflow")), (i % 4, u64::from(i % 4 == 3)));
            bench.tick();
        }
        bench.tick();
        bench.set_all(&[("step", 0)]);
        bench.tick();
        assert_eq!(bench.get("count"), 1);
        bench.set_all(&[("step", 1), ("clear", 1)]);
        bench.tick();
        assert_eq!(bench.get("count"), 0);
    }
}
