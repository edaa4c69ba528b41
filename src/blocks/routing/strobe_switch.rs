//! Strobe switch: passes the one of four strobes that ends a stroke.

use crate::blocks::{Block, Builder, Description, Kind, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "strobe_switch",
    kind: Kind::Routing,
    summary: "Passes the strobe of the quarter point that was selected.",
    doc: "strobe = strobes[quarters - 1], combinational; 0, and `out_of_range` 1, when `quarters` is 0 or more than 4.",
    source: "US 3,809,868, FIG. 4, logic switch 96",
    parameters: &[],
    ports: &[
        PortDescription::input("strobes", Width::Fixed(4), "the quarter points, pi/2 lowest"),
        PortDescription::input("quarters", Width::Fixed(3), "quarters to draw, 1 to 4"),
        PortDescription::output("strobe", Width::BIT, "the selected one"),
        PortDescription::output("out_of_range", Width::BIT, "there is no such quarter"),
    ],
    clocked: false,
};

fn build(b: &mut Builder) {
    let (strobes, quarters) = (b.input("strobes"), b.input("quarters"));
    let lines: Vec<_> = (1..=4).map(|number| b.is(quarters, number)).collect();
    let selected = b.join(&lines);
    let passed = b.and(selected, strobes);
    let strobe = b.reduce_or(passed);
    let known = b.any(&lines);
    let unknown = b.not(known);
    b.output("strobe", strobe);
    b.output("out_of_range", unknown);
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    #[test]
    fn only_the_selected_strobe_passes() {
        let mut bench = Bench::new("strobe_switch", &[]);
        for quarters in 0..8 {
            bench.set("quarters", quarters);
            assert_eq!(bench.get("out_of_range") == 1, !(1..=4).contains(&quarters));
            for line in 0..4 {
                bench.set("strobes", 1 << line);
                assert_eq!(bench.get("strobe") == 1, line + 1 == quarters, "strobe {line}, {quarters} quarters");
            }
        }
    }
}
