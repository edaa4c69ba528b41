//! Stepping motor of four phases with its drive: a step for each pulse, and the position it has come to.
//!
//! ```text
//!   windings   D C B A        two are on at a time; a pulse up goes down this table, a pulse down goes up
//!              0 0 1 1
//!              0 1 1 0
//!              1 1 0 0
//!              1 0 0 1
//! ```

use crate::base::ValueId;
use crate::blocks::{Block, Builder, Description, Kind, Parameter, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "stepping_motor",
    kind: Kind::Pulses,
    summary: "Takes a step for each pulse on its up or down line, by four windings.",
    doc: "At the trailing edge of a pulse, that is at the end of the first low tick behind it, the drive switches the \
          windings to the next pair (`up`) or to the pair before (`down`), and the shaft follows by a step: `position` \
          changes by one. Edges on both lines at once leave it where it is. `preset` says where the shaft is, and moves \
          nothing. The motor keeps up with every pulse: load, inertia and lost steps are not modelled. At power-on \
          windings A and B are on and the position is 0.",
    source: "US 3,809,868, FIG. 9 and 10, stepping motors 328a, 328b; two of four phases on is chosen, the usual full \
             step drive",
    parameters: &[Parameter { name: "WIDTH", default: 16, min: 2, max: 32, doc: "bits of the position" }],
    ports: &[
        PortDescription::input("preset", Width::BIT, "takes the preset value as the position; wins over a step"),
        PortDescription::input("preset_value", Width::Param("WIDTH"), "where the shaft is").signed(),
        PortDescription::input("up", Width::BIT, "pulses that step forward"),
        PortDescription::input("down", Width::BIT, "pulses that step back"),
        PortDescription::output("windings", Width::Fixed(4), "which windings are on, A lowest"),
        PortDescription::output("position", Width::Param("WIDTH"), "steps from the origin").signed(),
    ],
    clocked: true,
};

fn build(b: &mut Builder) {
    let [up, down] = ["up", "down"].map(|line| b.falls(b.input(line)));
    let steps = b.xor(up, down);

    let windings = b.hold(4, 0b0011);
    let [forward, back] = [rotated(b, windings.q, 3), rotated(b, windings.q, 1)];
    let next = b.mux(up, forward, back);
    b.load(windings, next, steps, None);
    b.output("windings", windings.q);

    let width = b.count("WIDTH");
    let position = b.hold(width, 0);
    let one = b.constant(1, width);
    let (more, less) = (b.add(position.q, one), b.sub(position.q, one));
    let stepped = b.mux(up, more, less);
    let preset = b.input("preset");
    let next = b.mux(preset, b.input("preset_value"), stepped);
    let changes = b.or(preset, steps);
    b.load(position, next, changes, None);
    b.output("position", position.q);
}

/// Four bits turned round, so that bit `low` becomes the lowest.
fn rotated(b: &mut Builder, word: ValueId, low: u32) -> ValueId {
    let (lower, higher) = (b.slice(word, low, 4 - low), b.slice(word, 0, low));
    b.concat(higher, lower)
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    /// The drive table of a full step motor with two phases on: windings A, B, C, D.
    const DRIVE: [[u64; 4]; 4] = [[1, 1, 0, 0], [0, 1, 1, 0], [0, 0, 1, 1], [1, 0, 0, 1]];

    fn on(bench: &Bench) -> [u64; 4] {
        let windings = bench.get("windings");
        [0, 1, 2, 3].map(|bit| windings >> bit & 1)
    }

    #[test]
    fn the_windings_follow_the_drive_table_both_ways_and_the_shaft_follows_them() {
        let mut bench = Bench::new("stepping_motor", &[("WIDTH", 8)]);
        let mut step = 0_i64;
        for (up, down) in [(1, 0), (1, 0), (1, 0), (1, 0), (1, 0), (0, 1), (0, 1), (1, 1), (0, 0)].repeat(3) {
            for (up, down, ticks) in [(up, down, 2), (0, 0, 1)] {
                bench.set_all(&[("up", up), ("down", down)]);
                (0..ticks).for_each(|_| bench.tick());
            }
            step += up - down;
            assert_eq!(on(&bench), DRIVE[step.rem_euclid(4) as usize], "at step {step}");
            assert_eq!(bench.get_signed("position"), step);
        }
        for _ in 0..20 {
            for down in [1, 0] {
                bench.set("down", down);
                bench.tick();
            }
            step -= 1;
            assert_eq!((on(&bench), bench.get_signed("position")), (DRIVE[step.rem_euclid(4) as usize], step));
        }
    }

    #[test]
    fn a_preset_tells_the_position_and_moves_nothing() {
        let mut bench = Bench::new("stepping_motor", &[]);
        bench.set_all(&[("preset", 1), ("preset_value", -777)]);
        bench.tick();
        assert_eq!((bench.get_signed("position"), on(&bench)), (-777, DRIVE[0]));
    }

    #[test]
    fn a_long_pulse_is_one_step_at_its_trailing_edge() {
        let mut bench = Bench::new("stepping_motor", &[]);
        let mut seen = Vec::new();
        for up in [1, 1, 1, 0, 0, 1, 0] {
            bench.set("up", up);
            bench.tick();
            seen.push(bench.get_signed("position"));
        }
        assert_eq!(seen, [0, 0, 0, 1, 1, 1, 2]);
    }
}
