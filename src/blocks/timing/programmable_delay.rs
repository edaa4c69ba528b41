//! Programmable delay: busy for so many ticks after the trailing edge of each pulse.
//!
//! ```text
//!   pulse     __/--\__________/--\_________
//!   busy      _______/-----\_____/-----\     interval = 6
//! ```

use crate::blocks::{Block, Builder, Description, Kind, Parameter, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "programmable_delay",
    kind: Kind::Timing,
    summary: "Is busy for `interval` ticks after the trailing edge of each pulse.",
    doc: "falls = pulse was 1 in the tick before and is 0; remaining(t+1) = falls ? interval : remaining > 0 ? remaining \
          - 1 : 0; busy = remaining > 0. So the interval begins after the first low tick behind the pulse. An interval of 0 \
          is never busy. A pulse that ends while busy starts the interval anew.",
    source: "US 3,809,868, FIG. 10, delay circuits 341, 342",
    parameters: &[Parameter { name: "WIDTH", default: 8, min: 1, max: 32, doc: "bits of the interval" }],
    ports: &[
        PortDescription::input("pulse", Width::BIT, "pulse that triggers the delay"),
        PortDescription::input("interval", Width::Param("WIDTH"), "ticks of delay, read at the trailing edge"),
        PortDescription::output("busy", Width::BIT, "1 while the delay runs"),
        PortDescription::output("remaining", Width::Param("WIDTH"), "ticks left"),
    ],
    clocked: true,
};

fn build(b: &mut Builder) {
    let width = b.count("WIDTH");
    let remaining = b.hold(width, 0);
    let busy = b.reduce_or(remaining.q);
    let triggered = b.falls(b.input("pulse"));
    let one = b.constant(1, width);
    let less = b.sub(remaining.q, one);
    let next = b.mux(triggered, b.input("interval"), less);
    let runs = b.or(triggered, busy);
    b.load(remaining, next, runs, None);
    b.output("busy", busy);
    b.output("remaining", remaining.q);
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    #[test]
    fn it_is_busy_for_the_interval_after_the_trailing_edge() {
        for interval in [0, 1, 5, 255] {
            let mut bench = Bench::new("programmable_delay", &[]);
            bench.set_all(&[("interval", interval), ("pulse", 1)]);
            (0..3).for_each(|_| bench.tick());
            bench.set("pulse", 0);
            assert_eq!(bench.get("busy"), 0, "not before the trailing edge");
            bench.tick();
            for left in (1..=interval).rev() {
                assert_eq!((bench.get("busy"), bench.get("remaining")), (1, left as u64));
                bench.tick();
            }
            assert_eq!((bench.get("busy"), bench.get("remaining")), (0, 0));
            bench.tick();
            assert_eq!(bench.get("busy"), 0);
        }
    }
}
