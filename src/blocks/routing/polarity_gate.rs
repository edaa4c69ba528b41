//! Polarity gate: passes a rectified wave as it is and inverted in turn, so that a summer can rebuild the full wave.

use crate::blocks::{Block, Builder, Description, Kind, Parameter, PortDescription, Width};

static WAVE: Width = Width::Add(&Width::Param("WIDTH"), &Width::Fixed(1));

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "polarity_gate",
    kind: Kind::Routing,
    summary: "Passes a wave to one output as it is, or to the other inverted, changing over at each zero.",
    doc: "reversed, 0 at power-on and after `reset`, changes at the end of each tick in which `at_zero` has risen. \
          direct = reversed ? 0 : magnitude; inverted = reversed ? -magnitude : 0; a summer joins them.",
    source: "US 3,809,868, FIG. 4A, gates 99 and 101 (polarity reversal on alternate cycles)",
    parameters: &[Parameter { name: "WIDTH", default: 29, min: 1, max: 60, doc: "bits of the rectified wave" }],
    ports: &[
        PortDescription::input("magnitude", Width::Param("WIDTH"), "the rectified wave, without sign"),
        PortDescription::input("at_zero", Width::BIT, "the wave is at its zero"),
        PortDescription::input("reset", Width::BIT, "back to direct"),
        PortDescription::output("direct", WAVE, "the wave in its positive cycles").signed(),
        PortDescription::output("inverted", WAVE, "the inverted wave in the others").signed(),
    ],
    clocked: true,
};

fn build(b: &mut Builder) {
    let (at_zero, reset) = (b.input("at_zero"), b.input("reset"));
    // A wave that begins at its zero does not arrive there.
    let was_zero = b.hold(1, 1);
    b.load(was_zero, at_zero, None, reset);
    let not_before = b.not(was_zero.q);
    let arrived = b.and(at_zero, not_before);
    let reversed = b.hold(1, 0);
    let other = b.not(reversed.q);
    b.load(reversed, other, arrived, reset);
    b.name("reversed", reversed.q);

    let wave = b.input("magnitude");
    let wave = b.zero_extend(wave, b.width(wave) + 1);
    let negated = b.negate(wave);
    let direct = b.gate(other, wave);
    let inverted = b.gate(reversed.q, negated);
    b.output("direct", direct);
    b.output("inverted", inverted);
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    #[test]
    fn a_rectified_wave_becomes_a_full_one() {
        let mut bench = Bench::new("polarity_gate", &[("WIDTH", 4)]);
        let wave = [0, 5, 9, 5, 0, 5, 9, 5, 0, 0, 5];
        let full = [0, 5, 9, 5, 0, -5, -9, -5, 0, 0, 5];
        for (magnitude, expected) in wave.into_iter().zip(full) {
            bench.set_all(&[("magnitude", magnitude), ("at_zero", i64::from(magnitude == 0))]);
            assert_eq!(bench.get_signed("direct") + bench.get_signed("inverted"), expected);
            bench.tick();
        }
    }

    #[test]
    fn a_reset_makes_the_wave_direct_again() {
        let mut bench = Bench::new("polarity_gate", &[("WIDTH", 4)]);
        for (at_zero, reset) in [(0, 0), (1, 0), (0, 1)] {
            bench.set_all(&[("magnitude", 7), ("at_zero", at_zero), ("reset", reset)]);
            bench.tick();
        }
        assert_eq!((bench.get_signed("direct"), bench.get_signed("inverted")), (7, 0));
    }
}
