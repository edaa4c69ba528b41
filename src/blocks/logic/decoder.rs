//! Decoder: raises the one of several lines that a code names.

use crate::blocks::{Block, Builder, Description, Kind, Parameter, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "decoder",
    kind: Kind::Logic,
    summary: "Raises just the line whose number is the code.",
    doc: "lines[i] = (code == i). A code of LINES or more raises none. Combinational.",
    source: "US 3,809,868, FIG. 10, quadrant decoder 332",
    parameters: &[Parameter { name: "LINES", default: 4, min: 2, max: 64, doc: "output lines" }],
    ports: &[
        PortDescription::input("code", Width::Clog2(&Width::Param("LINES")), "number of the line"),
        PortDescription::output("lines", Width::Param("LINES"), "one line high"),
    ],
    clocked: false,
};

fn build(b: &mut Builder) {
    let one = b.constant(1, b.count("LINES"));
    let lines = b.shift_left(one, b.input("code"));
    b.output("lines", lines);
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    #[test]
    fn just_the_named_line_is_high() {
        for lines in [2, 3, 4, 7, 64] {
            let mut bench = Bench::new("decoder", &[("LINES", lines)]);
            for code in 0..lines {
                bench.set("code", code);
                assert_eq!(bench.get("lines"), 1 << code);
            }
        }
        let mut bench = Bench::new("decoder", &[("LINES", 3)]);
        bench.set("code", 3);
        assert_eq!(bench.get("lines"), 0);
    }
}
