//! Digital difference circuit: by how much a measured word is above or below its reference.

use crate::blocks::{Block, Builder, Description, Kind, Parameter, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "difference_circuit",
    kind: Kind::Arithmetic,
    summary: "Compares a measured word with a reference and gives the difference with its sign.",
    doc: "difference = measured - reference, one bit wider, in two's complement. Combinational.",
    source: "US 3,809,868, FIG. 10, digital difference circuit 339",
    parameters: &[Parameter { name: "WIDTH", default: 12, min: 1, max: 63, doc: "bits of both words" }],
    ports: &[
        PortDescription::input("measured", Width::Param("WIDTH"), "measured word"),
        PortDescription::input("reference", Width::Param("WIDTH"), "reference 340"),
        PortDescription::output(
            "difference",
            Width::Add(&Width::Param("WIDTH"), &Width::Fixed(1)),
            "measured less reference",
        )
        .signed(),
    ],
    clocked: false,
};

fn build(b: &mut Builder) {
    let wide = b.count("WIDTH") + 1;
    let measured = b.zero_extend(b.input("measured"), wide);
    let reference = b.zero_extend(b.input("reference"), wide);
    let difference = b.sub(measured, reference);
    b.output("difference", difference);
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    #[test]
    fn the_difference_has_its_sign_over_the_whole_range() {
        let mut bench = Bench::new("difference_circuit", &[("WIDTH", 4)]);
        for measured in 0..16 {
            for reference in 0..16 {
                bench.set_all(&[("measured", measured), ("reference", reference)]);
                assert_eq!(bench.get_signed("difference"), measured - reference);
            }
        }
    }
}
