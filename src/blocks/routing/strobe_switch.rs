//! Strobe switch: passes the one of four strobes that ends a stroke.

use crate::blocks::{Block, Builder, Description, Kind, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "strobe_switch",
    kind: Kind::Routing,
    summary: "Passes the strobe of the quarter point that was selected.",
    doc: "At the end of a tick with `load` = 1 it takes the number of quarters, 1 to 4; from then on strobe = \
          strobes[quarters - 1]. No strobe passes before the first load. `out_of_range`, combinational, is 1 when \
          `quarters` is 0 or more than 4.",
    source: "US 3,809,868, FIG. 4, logic switch 96; the register is chosen",
    parameters: &[],
    ports: &[
        PortDescription::input("strobes", Width::Fixed(4), "the quarter points, pi/2 lowest"),
        PortDescription::input("load", Width::BIT, "takes the number of quarters"),
        PortDescription::input("quarters", Width::Fixed(3), "quarters to draw, 1 to 4"),
        PortDescription::output("strobe", Width::BIT, "the selected one"),
        PortDescription::output("out_of_range", Width::BIT, "there is no such quarter"),
    ],
    clocked: true,
};

fn build(b: &mut Builder) {
    let (strobes, quarters) = (b.input("strobes"), b.input("quarters"));
    let lines: Vec<_> = (1..=4).map(|number| b.is(quarters, number)).collect();
    let known = b.any(&lines);
    let unknown = b.not(known);
    b.output("out_of_range", unknown);
    let lines = b.join(&lines);
    let held = b.hold(4, 0);
    b.load(held, lines, b.input("load"), None);
    b.name("selected", held.q);
    let passed = b.and(held.q, strobes);
    let strobe = b.reduce_or(passed);
    b.output("strobe", strobe);
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    #[test]
    fn only_the_strobe_that_was_selected_at_the_last_load_passes() {
        let mut bench = Bench::new("strobe_switch", &[]);
        for quarters in 0..8 {
            bench.set_all(&[("quarters", quarters), ("load", 1)]);
            assert_eq!(bench.get("out_of_range") == 1, !(1..=4).contains(&quarters));
            bench.tick();
            bench.set_all(&[("quarters", 7 - quarters), ("load", 0)]);
            bench.tick();
            for line in 0..4 {
                bench.set("strobes", 1 << line);
                assert_eq!(bench.get("strobe") == 1, line + 1 == quarters, "strobe {line}, {quarters} quarters");
            }
        }
    }
}
