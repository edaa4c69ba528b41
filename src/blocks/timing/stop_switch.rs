//! Stop switch: ends a stroke after one to four quadrants.

use crate::blocks::{Block, Builder, Description, Kind, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "stop_switch",
    kind: Kind::Timing,
    summary: "Gives the stop pulse at the end of the quadrant that was selected.",
    doc: "At the end of a tick with `load` = 1 it takes the number of quarters, 1 to 4. stop = end_of_quadrant and the \
          decoder's line of that quadrant. `out_of_range`, combinational, is 1 when `quarters` is 0 or more than 4.",
    source: "US 3,809,868, FIG. 10, switch 349; the register is chosen",
    parameters: &[],
    ports: &[
        PortDescription::input("load", Width::BIT, "takes the number of quarters"),
        PortDescription::input("quarters", Width::Fixed(3), "quarters to draw, 1 to 4"),
        PortDescription::input("quadrant_lines", Width::Fixed(4), "the decoder's line of the present quadrant"),
        PortDescription::input("end_of_quadrant", Width::BIT, "1 in the last tick of a quadrant"),
        PortDescription::output("stop", Width::BIT, "1 in the last tick of the stroke"),
        PortDescription::output("out_of_range", Width::BIT, "1 when `quarters` cannot be drawn"),
    ],
    clocked: true,
};

fn build(b: &mut Builder) {
    let quarters = b.input("quarters");
    let selected: Vec<_> = (1..=4).map(|number| b.is(quarters, number)).collect();
    let good = b.any(&selected);
    let out_of_range = b.not(good);
    b.output("out_of_range", out_of_range);
    let selected = b.join(&selected);
    let held = b.hold(4, 0);
    b.load(held, selected, b.input("load"), None);
    b.name("selected", held.q);
    let reached = b.and(held.q, b.input("quadrant_lines"));
    let last_quadrant = b.reduce_or(reached);
    let stop = b.and(last_quadrant, b.input("end_of_quadrant"));
    b.output("stop", stop);
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    #[test]
    fn it_stops_at_the_end_of_the_selected_quadrant_only() {
        for quarters in 1..=4 {
            let mut bench = Bench::new("stop_switch", &[]);
            bench.set_all(&[("quarters", quarters), ("load", 1)]);
            bench.tick();
            bench.set_all(&[("quarters", 0), ("load", 0)]);
            for quadrant in 1..=4 {
                bench.set("quadrant_lines", 1 << (quadrant - 1));
                for end in [0, 1] {
                    bench.set("end_of_quadrant", end);
                    assert_eq!(bench.get("stop"), u64::from(end == 1 && quadrant == quarters));
                }
            }
        }
    }

    #[test]
    fn only_one_to_four_quarters_are_in_range() {
        let mut bench = Bench::new("stop_switch", &[]);
        for quarters in 0..8 {
            bench.set("quarters", quarters);
            assert_eq!(bench.get("out_of_range"), u64::from(!(1..=4).contains(&quarters)));
        }
    }
}
