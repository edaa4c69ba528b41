//! Limit inverter: the rest that is left to the upper limit.

use crate::blocks::{Block, Builder, Description, Kind, Parameter, PortDescription, Width};

static LEVEL: Width = Width::Add(&Width::Param("BITS"), &Width::Fixed(1));

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "limit_inverter",
    kind: Kind::Arithmetic,
    summary: "Turns a level into what is left to the limit of 2^BITS.",
    doc: "rest = 2^BITS - level, combinational, for a level from 0 to 2^BITS: a triangle wave upside down, that is, a \
          quarter of a period later.",
    source: "US 3,809,868, FIG. 4A, inverter 95",
    parameters: &[Parameter { name: "BITS", default: 28, min: 1, max: 60, doc: "the limit is 2^BITS" }],
    ports: &[
        PortDescription::input("level", LEVEL, "0 to 2^BITS, without sign"),
        PortDescription::output("rest", LEVEL, "2^BITS less the level"),
    ],
    clocked: false,
};

fn build(b: &mut Builder) {
    let (bits, level) = (b.count("BITS"), b.input("level"));
    let limit = b.constant(1 << bits, bits + 1);
    let rest = b.sub(limit, level);
    b.output("rest", rest);
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    #[test]
    fn level_and_rest_make_up_the_limit() {
        let mut bench = Bench::new("limit_inverter", &[("BITS", 5)]);
        for level in 0..=32 {
            bench.set("level", level);
            assert_eq!(bench.get("rest"), 32 - level as u64);
        }
    }
}
