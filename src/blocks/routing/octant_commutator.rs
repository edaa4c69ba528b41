//! Octant commutator: gives the steps of an interpolator their signs, and turns them by eighths of a turn.
//!
//! ```text
//!        3  2  1                     direction = that of the step + turn, modulo 8
//!         \ | /
//!      4 -- o -- 0     even: a whole step along one axis
//!         / | \        odd: a combined step along both
//!        5  6  7
//! ```

use crate::blocks::{Block, Builder, Description, Kind, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "octant_commutator",
    kind: Kind::Routing,
    summary: "Applies signs to the steps of an interpolator and turns them by multiples of 45 degrees.",
    doc: "A step has one of eight directions, counted in eighths of a turn from +X by +Y. Without a turn a whole step \
          along X goes in direction 0, or 4 with minus_x; one along Y in 2, or 6 with minus_y; a combined step in 1 \
          (+X+Y), 3 (-X+Y), 5 (-X-Y), 7 (+X-Y). `turn` is added to that, modulo 8: an odd one exchanges the roles of whole \
          and combined steps. lines[d] is high while a step goes in direction d. Combinational; of the three step \
          inputs at most one may be high.",
    source: "SU 1522157: signs are applied outside the interpolator, and its path may be turned by multiples of 45 \
             degrees without a new computation; how is chosen",
    parameters: &[],
    ports: &[
        PortDescription::input("step_x", Width::BIT, "a whole step along X"),
        PortDescription::input("step_y", Width::BIT, "a whole step along Y"),
        PortDescription::input("step_xy", Width::BIT, "a combined step"),
        PortDescription::input("minus_x", Width::BIT, "X runs backward"),
        PortDescription::input("minus_y", Width::BIT, "Y runs backward"),
        PortDescription::input("turn", Width::Fixed(3), "eighths of a turn, counter-clockwise"),
        PortDescription::output("lines", Width::Fixed(8), "one line for each direction"),
    ],
    clocked: false,
};

fn build(b: &mut Builder) {
    let [step_x, step_y, step_xy] = ["step_x", "step_y", "step_xy"].map(|name| b.input(name));
    let (minus_x, minus_y) = (b.input("minus_x"), b.input("minus_y"));
    // The direction without a turn, bit by bit: 4 or 0, 6 or 2, 1, 3, 5 or 7.
    let half = b.mux(step_x, minus_x, minus_y);
    let signs_differ = b.xor(minus_x, minus_y);
    let quarter = b.gate(step_xy, signs_differ);
    let quarter = b.or(quarter, step_y);
    let direction = b.join(&[step_xy, quarter, half]);
    let direction = b.add(direction, b.input("turn"));
    let direction = b.name("direction", direction);
    let any = b.any(&[step_x, step_y, step_xy]);
    let lines: Vec<_> = (0..8)
        .map(|line| {
            let goes = b.is(direction, line);
            b.and(any, goes)
        })
        .collect();
    let lines = b.join(&lines);
    b.output("lines", lines);
}

#[cfg(test)]
mod tests {
    use std::f64::consts::FRAC_PI_4;

    use crate::blocks::bench::Bench;

    #[test]
    fn every_step_goes_where_its_signed_vector_points_after_the_turn() {
        let mut bench = Bench::new("octant_commutator", &[]);
        for (step, vector) in [("step_x", [1.0, 0.0]), ("step_y", [0.0, 1.0]), ("step_xy", [1.0, 1.0])] {
            for signs in 0..4 {
                let [minus_x, minus_y] = [signs & 1, signs >> 1];
                let sign = |minus: i64| if minus == 1 { -1.0 } else { 1.0 };
                let angle = f64::atan2(vector[1] * sign(minus_y), vector[0] * sign(minus_x));
                for turn in 0..8 {
                    bench.set_all(&[("step_x", 0), ("step_y", 0), ("step_xy", 0), (step, 1)]);
                    bench.set_all(&[("minus_x", minus_x), ("minus_y", minus_y), ("turn", turn)]);
                    let eighths = (angle / FRAC_PI_4).round() as i64 + turn;
                    assert_eq!(bench.get("lines"), 1 << eighths.rem_euclid(8), "{step} {signs} {turn}");
                }
            }
        }
    }

    #[test]
    fn without_a_step_no_line_is_high() {
        let mut bench = Bench::new("octant_commutator", &[]);
        for turn in 0..8 {
            bench.set_all(&[("minus_x", turn & 1), ("minus_y", turn >> 1 & 1), ("turn", turn)]);
            assert_eq!(bench.get("lines"), 0);
        }
    }
}
