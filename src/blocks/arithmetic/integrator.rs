//! Integrator between two limits: the sum of its rates, held at 0 and at the upper limit.

use crate::base::ValueId;
use crate::blocks::{Block, Builder, Description, Kind, Parameter, Parameters, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build).with_check(check);

static DESCRIPTION: Description = Description {
    name: "integrator",
    kind: Kind::Arithmetic,
    summary: "Adds up a signed rate between 0 and an upper limit of 2^BITS.",
    doc: "level(t+1) = reset ? 0 : min(max(level + rate, 0), 2^BITS). The level meets either limit exactly, so that \
          comparators (outputs `at_lower`, `at_upper`) see it there for one tick at least; what a step would carry beyond \
          the limit is lost.",
    source: "US 3,809,868, FIG. 4A, integrator 91 (chosen: the comparators that throw switch 89 are part of it)",
    parameters: &[
        Parameter { name: "BITS", default: 28, min: 1, max: 60, doc: "the upper limit is 2^BITS" },
        Parameter { name: "RATE_WIDTH", default: 22, min: 2, max: 61, doc: "bits of the rate, at most BITS + 1" },
    ],
    ports: &[
        PortDescription::input("rate", Width::Param("RATE_WIDTH"), "what is added in this tick").signed(),
        PortDescription::input("reset", Width::BIT, "discharges the integrator"),
        PortDescription::output(
            "level",
            Width::Add(&Width::Param("BITS"), &Width::Fixed(1)),
            "the sum, 0 to 2^BITS, without sign",
        ),
        PortDescription::output("at_lower", Width::BIT, "the level is 0"),
        PortDescription::output("at_upper", Width::BIT, "the level is 2^BITS"),
    ],
    clocked: true,
};

fn check(parameters: &Parameters) -> Result<(), String> {
    if parameters.get("RATE_WIDTH") > parameters.get("BITS") + 1 {
        return Err("RATE_WIDTH is more than BITS + 1: one step would span both limits".into());
    }
    Ok(())
}

fn build(b: &mut Builder) {
    let (bits, rate, reset) = (b.count("BITS"), b.input("rate"), b.input("reset"));
    let level = b.hold(bits + 1, 0);
    let next = limited_sum(b, level.q, rate);
    b.load(level, next, None, reset);
    let at_upper = b.sign(level.q);
    let at_lower = b.is(level.q, 0);
    for (name, value) in [("level", level.q), ("at_lower", at_lower), ("at_upper", at_upper)] {
        b.output(name, value);
    }
}

fn limited_sum(b: &mut Builder, level: ValueId, rate: ValueId) -> ValueId {
    let width = b.width(level);
    let (wide, rate) = (b.zero_extend(level, width + 2), b.sign_extend(rate, width + 2));
    let sum = b.add(wide, rate);
    let limit = b.constant(1 << (width - 1), width + 2);
    let below = b.sign(sum);
    let inside = b.less_signed(sum, limit);
    let positive = b.mux(inside, sum, limit);
    let positive = b.slice(positive, 0, width);
    let not_below = b.not(below);
    b.gate(not_below, positive)
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    #[test]
    fn the_level_is_the_sum_of_the_rates_held_between_the_limits() {
        let mut bench = Bench::new("integrator", &[("BITS", 4), ("RATE_WIDTH", 5)]);
        let mut level = 0;
        for rate in [3, 15, -1, -15, -9, 7, 8, 1, 1, -16, 5] {
            bench.set("rate", rate);
            bench.tick();
            level = (level + rate).clamp(0, 16);
            let seen = (bench.get("level"), bench.get("at_lower"), bench.get("at_upper"));
            assert_eq!(seen, (level as u64, u64::from(level == 0), u64::from(level == 16)));
        }
    }

    #[test]
    fn a_reset_discharges_it_whatever_the_rate() {
        let mut bench = Bench::new("integrator", &[]);
        bench.set("rate", 1000);
        bench.tick();
        bench.set("reset", 1);
        bench.tick();
        assert_eq!((bench.get("level"), bench.get("at_lower")), (0, 1));
    }
}
