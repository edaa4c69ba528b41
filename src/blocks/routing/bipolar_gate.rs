//! Bipolar gate: passes a rate with both signs, or nothing.

use crate::blocks::{Block, Builder, Description, Kind, Parameter, PortDescription, Width};

static SIGNED_RATE: Width = Width::Add(&Width::Param("WIDTH"), &Width::Fixed(1));

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "bipolar_gate",
    kind: Kind::Routing,
    summary: "Gives a rate and its negative while it is open.",
    doc: "plus = enable ? rate : 0; minus = -plus. Combinational.",
    source: "US 3,809,868, FIG. 4A, gate 107",
    parameters: &[Parameter { name: "WIDTH", default: 20, min: 1, max: 60, doc: "bits of the rate" }],
    ports: &[
        PortDescription::input("enable", Width::BIT, "opens the gate"),
        PortDescription::input("rate", Width::Param("WIDTH"), "the rate, without sign"),
        PortDescription::output("plus", SIGNED_RATE, "the rate").signed(),
        PortDescription::output("minus", SIGNED_RATE, "its negative").signed(),
    ],
    clocked: false,
};

fn build(b: &mut Builder) {
    let (enable, rate) = (b.input("enable"), b.input("rate"));
    let passed = b.gate(enable, rate);
    let plus = b.zero_extend(passed, b.width(rate) + 1);
    let minus = b.negate(plus);
    b.output("plus", plus);
    b.output("minus", minus);
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    #[test]
    fn both_signs_pass_the_open_gate_and_nothing_the_closed_one() {
        let mut bench = Bench::new("bipolar_gate", &[("WIDTH", 4)]);
        for rate in 0..16 {
            for (enable, passed) in [(1, rate), (0, 0)] {
                bench.set_all(&[("enable", enable), ("rate", rate)]);
                assert_eq!((bench.get_signed("plus"), bench.get_signed("minus")), (passed, -passed));
            }
        }
    }
}
