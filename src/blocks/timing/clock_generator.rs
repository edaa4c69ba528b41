//! Clock generator: a strobe of one tick at regular intervals.
//!
//! ```text
//!   tick     0 1 2 3 4 5 6 7 8
//!   strobe  |-|_____|-|_____|-|     PERIOD = 4
//! ```

use crate::base::word::clog2;
use crate::blocks::{Block, Builder, Description, Kind, Parameter, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "clock_generator",
    kind: Kind::Timing,
    summary: "Gives a strobe of one tick every so many ticks.",
    doc: "strobe(t) = 1 when t is a multiple of PERIOD: the first strobe is at tick 0, and nothing stops or shifts the \
          train. PERIOD 1 is a strobe at every tick.",
    source: "SU 1522157, generator 15 of FIG. 1; that it runs freely from tick 0 is chosen",
    parameters: &[Parameter { name: "PERIOD", default: 4, min: 1, max: 65536, doc: "ticks from strobe to strobe" }],
    ports: &[PortDescription::output("strobe", Width::BIT, "high for one tick in PERIOD")],
    clocked: true,
};

fn build(b: &mut Builder) {
    let period = u64::from(b.count("PERIOD"));
    let width = clog2(period).max(1);
    let phase = b.hold(width, 0);
    let one = b.constant(1, width);
    let next = b.add(phase.q, one);
    let last = b.is(phase.q, period - 1);
    let phase = b.load(phase, next, None, last);
    b.name("phase", phase);
    let strobe = b.is(phase, 0);
    b.output("strobe", strobe);
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    #[test]
    fn the_strobe_is_high_at_tick_0_and_at_every_multiple_of_the_period() {
        for period in [1, 2, 3, 4, 5, 7, 8, 100] {
            let mut bench = Bench::new("clock_generator", &[("PERIOD", period)]);
            for tick in 0..3 * period + 2 {
                assert_eq!(bench.get("strobe"), u64::from(tick % period == 0), "period {period}, tick {tick}");
                bench.tick();
            }
        }
    }
}
