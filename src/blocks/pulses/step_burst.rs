//! Step burst: a step of an interpolator as pulses for a motor that takes quarters of it.
//!
//! ```text
//!   forward[0]  _#________________      whole step: four pulses
//!   up          _#_#_#_#__________
//!   forward[1]  _#________________      combined step: three
//!   up          _#_#_#____________
//! ```

use crate::base::ValueId;
use crate::blocks::{Block, Builder, Description, Kind, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "step_burst",
    kind: Kind::Pulses,
    summary: "Turns a step of one axis into four or three pulses on the up or down line of a stepping motor.",
    doc: "A strobe at forward[0] gives four pulses at `up`, one at forward[1] three; the same at `back` gives them at `down`. \
          The first comes in the tick of the strobe, the others every second tick. `active` is high from the tick after the \
          strobe until the trailing edge of the last pulse is past. Strobes have to be 8 ticks apart, or 6 behind a combined \
          step: an earlier one cuts the burst short and begins its own, and may join it to a pulse that is not over.",
    source: "SU 1522157: motors are driven outside the interpolator; quarters and bursts are chosen",
    parameters: &[],
    ports: &[
        PortDescription::input("forward", Width::Fixed(2), "strobes of a whole (0) and a combined step (1) forward"),
        PortDescription::input("back", Width::Fixed(2), "the same back"),
        PortDescription::output("up", Width::BIT, "pulses forward"),
        PortDescription::output("down", Width::BIT, "pulses back"),
        PortDescription::output("active", Width::BIT, "a burst is under way"),
    ],
    clocked: true,
};

fn build(b: &mut Builder) {
    let forward = burst(b, "forward");
    let back = burst(b, "back");
    b.output("up", forward.0);
    b.output("down", back.0);
    let active = b.or(forward.1, back.1);
    b.output("active", active);
}

/// The pulses of one line, and whether some are still to come or to end: a chain of ticks that a strobe fills.
fn burst(b: &mut Builder, strobes: &str) -> (ValueId, ValueId) {
    let strobes = b.input(strobes);
    let (whole, combined) = (b.pick(strobes, 0), b.pick(strobes, 1));
    let strobe = b.or(whole, combined);
    // Bit i is high when a pulse comes i ticks from now: after the one of the strobe itself.
    let chain = b.hold(6, 0);
    let zero = b.bit(false);
    let shifted = b.slice(chain.q, 1, 5);
    let shifted = b.concat(zero, shifted);
    let [four, three] = [0b10_1010, 0b00_1010].map(|pulses| b.constant(pulses, 6));
    let filled = b.mux(whole, four, three);
    let next = b.mux(strobe, filled, shifted);
    b.load(chain, next, None, None);
    let pulse = b.pick(chain.q, 0);
    let pulses = b.or(strobe, pulse);
    let waits = b.reduce_or(chain.q);
    let was_high = b.delay(pulses);
    let active = b.or(waits, was_high);
    (pulses, active)
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    /// Up, down and active, tick by tick, as `#` and `_`.
    fn seen(line: &str, strobe: i64) -> [String; 3] {
        let mut bench = Bench::new("step_burst", &[]);
        let mut rows = [String::new(), String::new(), String::new()];
        for tick in 0..12 {
            bench.set(line, if tick == 1 { strobe } else { 0 });
            for (row, name) in rows.iter_mut().zip(["up", "down", "active"]) {
                row.push(if bench.get(name) == 1 { '#' } else { '_' });
            }
            bench.tick();
        }
        rows
    }

    #[test]
    fn a_whole_step_gives_four_pulses_and_a_combined_one_three_on_the_line_of_its_direction() {
        let [four, three, none] = ["_#_#_#_#____", "_#_#_#______", "____________"];
        let [long, short] = ["__#######___", "__#####_____"];
        assert_eq!(seen("forward", 1), [four, none, long]);
        assert_eq!(seen("forward", 2), [three, none, short]);
        assert_eq!(seen("back", 1), [none, four, long]);
        assert_eq!(seen("back", 2), [none, three, short]);
    }

    #[test]
    fn bursts_eight_ticks_apart_never_touch() {
        let mut bench = Bench::new("step_burst", &[]);
        let mut pulses = String::new();
        for tick in 0..24 {
            bench.set("forward", i64::from(tick % 8 == 0));
            pulses.push(if bench.get("up") == 1 { '#' } else { '_' });
            bench.tick();
        }
        assert_eq!(pulses, "#_#_#_#_".repeat(3));
    }
}
