//! Pulse distributor: a delay chain with taps, so that one pulse becomes a sequence of pulses on successive lines.
//!
//! ```text
//!   pulse_in _|-|_________________
//!   taps[0]  _____|-|_____________     SPACING = 2
//!   taps[1]  _________|-|_________
//!   taps[2]  _____________|-|_____
//!   active   ___|-----------|_____
//! ```

use super::chain::Chain;
use crate::blocks::{Block, Builder, Description, Kind, Parameter, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "pulse_distributor",
    kind: Kind::Timing,
    summary: "Turns one pulse into a sequence of pulses on successive taps.",
    doc: "taps[k](t) = pulse_in(t - (k + 1) * SPACING): a delay chain of TAPS links, SPACING ticks each, with a tap \
          after each link. `active` is high while a pulse is under way, the tick of the last tap included.",
    source: "SU 1522157, distributor 20 of FIG. 1 (a multi-link delay element)",
    parameters: &[
        Parameter { name: "TAPS", default: 9, min: 1, max: 64, doc: "number of taps" },
        Parameter { name: "SPACING", default: 2, min: 1, max: 64, doc: "ticks from one tap to the next" },
    ],
    ports: &[
        PortDescription::input("pulse_in", Width::BIT, "the pulse that starts a sequence"),
        PortDescription::output("taps", Width::Param("TAPS"), "the taps, the first one lowest"),
        PortDescription::output("active", Width::BIT, "a pulse is under way"),
    ],
    clocked: true,
};

fn build(b: &mut Builder) {
    let (taps, spacing) = (b.count("TAPS"), b.count("SPACING"));
    let chain = Chain::build(b, b.input("pulse_in"), taps * spacing);
    let tapped: Vec<_> = (1..=taps).map(|link| chain.after(b, link * spacing)).collect();
    let tapped = b.join(&tapped);
    let active = chain.holds_a_pulse(b);
    b.output("taps", tapped);
    b.output("active", active);
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    #[test]
    fn a_pulse_passes_the_taps_in_order_at_the_stated_spacing() {
        for (taps, spacing) in [(1, 1), (9, 1), (9, 2), (9, 7), (9, 8), (3, 64), (64, 3)] {
            let mut bench = Bench::new("pulse_distributor", &[("TAPS", taps), ("SPACING", spacing)]);
            for tick in 0..=taps * spacing + 2 {
                bench.set("pulse_in", i64::from(tick == 0));
                let at_a_tap = tick > 0 && tick % spacing == 0 && tick <= taps * spacing;
                let expected = if at_a_tap { 1 << (tick / spacing - 1) } else { 0 };
                assert_eq!(bench.get("taps"), expected, "{taps} taps, spacing {spacing}, tick {tick}");
                assert_eq!(bench.get("active"), u64::from((1..=taps * spacing).contains(&tick)), "tick {tick}");
                bench.tick();
            }
        }
    }

    #[test]
    fn pulses_follow_each_other_without_disturbance() {
        let mut bench = Bench::new("pulse_distributor", &[("TAPS", 3), ("SPACING", 1)]);
        bench.set("pulse_in", 1);
        for taps in [0b000, 0b001, 0b011, 0b111, 0b111] {
            assert_eq!(bench.get("taps"), taps);
            bench.tick();
        }
    }
}
