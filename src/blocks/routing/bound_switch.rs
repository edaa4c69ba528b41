//! Bound switch: thrown at each end of an integrator's range, so that it runs up and down.
//!
//! ```text
//!            at_lower   at_upper
//!   plus  ------o          |
//!                \_________|___ rate        level  /\    /\
//!   minus ------o                                 /  \  /  \
//! ```

use crate::blocks::{Block, Builder, Description, Kind, Parameter, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "bound_switch",
    kind: Kind::Routing,
    summary: "Passes the positive rate after the lower bound and the negative one after the upper.",
    doc: "falling = at_upper ? 1 : at_lower ? 0 : as in the tick before (0 at power-on and after `reset`); rate = falling \
          ? minus : plus. A bound acts in the same tick.",
    source: "US 3,809,868, FIG. 4A, switch 89",
    parameters: &[Parameter { name: "WIDTH", default: 21, min: 2, max: 61, doc: "bits of the rates" }],
    ports: &[
        PortDescription::input("plus", Width::Param("WIDTH"), "rate upwards").signed(),
        PortDescription::input("minus", Width::Param("WIDTH"), "rate downwards").signed(),
        PortDescription::input("at_lower", Width::BIT, "throws the switch to plus"),
        PortDescription::input("at_upper", Width::BIT, "throws it to minus"),
        PortDescription::input("reset", Width::BIT, "throws it to plus at the end of the tick"),
        PortDescription::output("rate", Width::Param("WIDTH"), "the rate passed").signed(),
    ],
    clocked: true,
};

fn build(b: &mut Builder) {
    let [lower, upper] = ["at_lower", "at_upper"].map(|name| b.input(name));
    let before = b.hold(1, 0);
    let not_lower = b.not(lower);
    let still_falling = b.and(before.q, not_lower);
    let falling = b.or(upper, still_falling);
    b.load(before, falling, None, b.input("reset"));
    b.name("falling", falling);
    let rate = b.mux(falling, b.input("minus"), b.input("plus"));
    b.output("rate", rate);
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    #[test]
    fn the_switch_stays_as_the_last_bound_threw_it() {
        let mut bench = Bench::new("bound_switch", &[("WIDTH", 4)]);
        bench.set_all(&[("plus", 3), ("minus", -3)]);
        let steps = [(0, 0, 3), (0, 1, -3), (0, 0, -3), (0, 0, -3), (1, 0, 3), (0, 0, 3), (0, 1, -3)];
        for (lower, upper, rate) in steps {
            bench.set_all(&[("at_lower", lower), ("at_upper", upper)]);
            assert_eq!(bench.get_signed("rate"), rate);
            bench.tick();
        }
        bench.set_all(&[("at_upper", 0), ("reset", 1)]);
        bench.tick();
        assert_eq!(bench.get_signed("rate"), 3);
    }
}
