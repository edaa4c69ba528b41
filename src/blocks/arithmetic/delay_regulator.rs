//! Delay regulator: the common delay word of the delay circuits, raised while acceleration is too high.
//!
//! ```text
//!   difference > 0:  interval = min(MAX, interval + STEP * difference)
//!   difference < 0:  interval = max(MIN, interval - STEP)
//! ```

use crate::base::ValueId;
use crate::base::word::clog2;
use crate::blocks::{Block, Builder, Description, Kind, Parameter, Parameters, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build).with_check(check);

static DESCRIPTION: Description = Description {
    name: "delay_regulator",
    kind: Kind::Arithmetic,
    summary: "Holds the delay word, raises it above the reference and lowers it below.",
    doc: "At the end of every PERIOD ticks: difference > 0 raises the interval by STEP * difference, at most to \
          MAX; difference < 0 lowers it by STEP, at least to MIN; 0 leaves it. `preset` sets it to MAX (a soft start) and \
          begins a period; so it is at power-on.",
    source: "US 3,809,868, FIG. 10, \"increase or decrease the delay\" of circuits 341, 342; the law is chosen",
    parameters: &[
        Parameter { name: "WIDTH", default: 8, min: 1, max: 20, doc: "bits of the interval" },
        Parameter { name: "DIFFERENCE_WIDTH", default: 13, min: 2, max: 21, doc: "bits of the difference" },
        Parameter { name: "MIN", default: 4, min: 0, max: 65535, doc: "least interval, in ticks" },
        Parameter { name: "MAX", default: 120, min: 0, max: 65535, doc: "greatest interval, in ticks" },
        Parameter { name: "PERIOD", default: 1000, min: 1, max: 65536, doc: "ticks from change to change" },
        Parameter { name: "STEP", default: 1, min: 1, max: 64, doc: "ticks of change" },
    ],
    ports: &[
        PortDescription::input("preset", Width::BIT, "sets the interval to MAX"),
        PortDescription::input("difference", Width::Param("DIFFERENCE_WIDTH"), "acceleration less reference").signed(),
        PortDescription::output("interval", Width::Param("WIDTH"), "the delay word"),
    ],
    clocked: true,
};

fn check(p: &Parameters) -> Result<(), String> {
    let (least, most, width) = (p.get("MIN"), p.get("MAX"), p.get("WIDTH"));
    if least > most {
        return Err(format!("MIN {least} is above MAX {most}"));
    }
    if most >> width != 0 {
        return Err(format!("MAX {most} does not fit {width} bits: raise WIDTH"));
    }
    Ok(())
}

fn build(b: &mut Builder) {
    let width = b.count("WIDTH");
    let interval = b.hold(width, b.param("MAX").unsigned_abs());
    let difference = b.input("difference");
    // Wide enough for interval, STEP (7 bits) times difference, and a sign.
    let wide = b.count("DIFFERENCE_WIDTH") + width + 8;
    let now = b.zero_extend(interval.q, wide);
    let difference = b.sign_extend(difference, wide);
    let next = changed(b, now, difference);
    let next = b.slice(next, 0, width);
    let end_of_period = end_of_period(b);
    b.load(interval, next, end_of_period, b.input("preset"));
    b.output("interval", interval.q);
}

/// 1 in the last tick of each period.
fn end_of_period(b: &mut Builder) -> ValueId {
    let period = u64::from(b.count("PERIOD"));
    let width = clog2(period).max(1);
    let ticks = b.hold(width, 0);
    b.name("ticks", ticks.q);
    let last = b.is(ticks.q, period - 1);
    let one = b.constant(1, width);
    let more = b.add(ticks.q, one);
    let restart = b.or(last, b.input("preset"));
    b.load(ticks, more, None, restart);
    last
}

fn changed(b: &mut Builder, now: ValueId, difference: ValueId) -> ValueId {
    let wide = b.width(now);
    let number = |b: &mut Builder, name: &str| b.constant(b.param(name).unsigned_abs(), wide);
    let (step, least, most) = (number(b, "STEP"), number(b, "MIN"), number(b, "MAX"));
    let growth = b.mul(difference, step);
    let grown = b.add(now, growth);
    let too_long = b.less_signed(most, grown);
    let longer = b.mux(too_long, most, grown);
    let reduced = b.sub(now, step);
    let too_short = b.less_signed(reduced, least);
    let shorter = b.mux(too_short, least, reduced);
    let (below, differs) = (b.sign(difference), b.reduce_or(difference));
    let moved = b.mux(below, shorter, longer);
    b.mux(differs, moved, now)
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    #[test]
    fn the_interval_follows_the_law_between_its_limits() {
        let mut bench = Bench::new("delay_regulator", &[("STEP", 2), ("MIN", 10), ("MAX", 40), ("PERIOD", 1)]);
        assert_eq!(bench.get("interval"), 40);
        let mut expected = 40;
        for difference in
            [-1, -4095, 0, 3, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, 1, 4, 4095, -4096]
        {
            bench.set("difference", difference);
            bench.tick();
            expected = match difference {
                0 => expected,
                1.. => (expected + 2 * difference).min(40),
                _ => (expected - 2).max(10),
            };
            assert_eq!(bench.get("interval"), expected as u64);
        }
        bench.set("preset", 1);
        bench.tick();
        assert_eq!(bench.get("interval"), 40);
    }

    #[test]
    fn it_changes_once_a_period_counted_from_the_preset() {
        let mut bench = Bench::new("delay_regulator", &[("PERIOD", 3), ("MAX", 20)]);
        bench.set("difference", -1);
        let mut seen = Vec::new();
        for preset in [0, 0, 1, 0, 0, 0, 0, 0, 0] {
            bench.set("preset", preset);
            bench.tick();
            seen.push(bench.get("interval"));
        }
        assert_eq!(seen, [20, 20, 20, 20, 20, 19, 19, 19, 18]);
    }
}
