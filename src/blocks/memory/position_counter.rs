//! Position counter: where an axis stands, in quarters of a step, by whole steps and steps of three quarters.
//!
//! ```text
//!   forward[0], back[0]   whole step:     +4, -4  --->[ position ]---> position
//!   forward[1], back[1]   combined step:  +3, -3
//! ```

use crate::blocks::{Block, Builder, Description, Kind, Parameter, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "position_counter",
    kind: Kind::Memory,
    summary: "Counts an axis forward and back by whole steps and by steps of three quarters.",
    doc: "position(t+1) = position(t) + 4 forward[0] + 3 forward[1] - 4 back[0] - 3 back[1], in quarters of a whole step. \
          At most one of the four strobes may be high. It wraps round when it is full.",
    source: "SU 1522157: a combined step is 0.75 of a whole one along each axis; quarters hold both (chosen)",
    parameters: &[Parameter { name: "WIDTH", default: 20, min: 4, max: 64, doc: "bits of the position" }],
    ports: &[
        PortDescription::input("forward", Width::Fixed(2), "strobes of a whole (0) and a combined step (1) forward"),
        PortDescription::input("back", Width::Fixed(2), "the same back"),
        PortDescription::output("position", Width::Param("WIDTH"), "quarters from where it was at power-on").signed(),
    ],
    clocked: true,
};

fn build(b: &mut Builder) {
    let width = b.count("WIDTH");
    let (forward, back) = (b.input("forward"), b.input("back"));
    let mut change = b.constant(0, width);
    for (strobes, sign) in [(forward, 1), (back, -1)] {
        for (strobe, quarters) in [4_i64, 3].into_iter().enumerate() {
            let strobe = b.pick(strobes, strobe as u32);
            let quarters = b.constant((sign * quarters) as u64, width);
            change = b.mux(strobe, quarters, change);
        }
    }
    let position = b.hold(width, 0);
    let next = b.add(position.q, change);
    let position = b.load(position, next, None, None);
    b.output("position", position);
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    #[test]
    fn each_strobe_counts_its_quarters_and_a_full_counter_wraps() {
        let mut bench = Bench::new("position_counter", &[("WIDTH", 5)]);
        let mut position = 0_i64;
        for (forward, back, change) in [(1, 0, 4), (2, 0, 3), (0, 0, 0), (0, 1, -4), (0, 2, -3), (0, 1, -4)].repeat(9) {
            bench.set_all(&[("forward", forward), ("back", back)]);
            bench.tick();
            position = (position + change + 16).rem_euclid(32) - 16;
            assert_eq!(bench.get_signed("position"), position);
        }
    }
}
