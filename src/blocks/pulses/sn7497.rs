//! SN7497: the six-bit binary rate multiplier package, with the pins that cascade it.
//!
//! ```text
//!             +------------------+
//!   clock  -->|  6-bit counter   |--> enout   low in state 63 while enabled
//!   enin   -->|                  |
//!   strb   -->|  6 gates + rate  |--> z       low pulses
//!   clr    -->|                  |
//!   unity  -->|                  |--> y       NAND(z, unity)
//!             +------------------+
//! ```

use crate::blocks::{Block, Builder, Description, Kind, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "sn7497",
    kind: Kind::Pulses,
    summary: "The SN7497 package: a six-bit rate multiplier with clear, strobe, enable, unity/cascade.",
    doc: "The counter counts at the rising edge of the clock while `clr`, `strb` and `enin` are all 0; `clr` is \
          asynchronous. While the clock is low, z goes low when the gate that the state opens has its rate bit set; `strb` \
          or `clr` high keeps z high. y = NAND(z, unity): tie unity to 1, or to z of the next package. `enout` is low \
          just in state 63 while `enin` is low. To cascade, the first package takes the six heaviest rate bits and its \
          enout goes to enin and strb of the second.\n\
          A tick has no clock edges, so the clock pin is told in two: `clock_low` is 1 while it is low (a pulse), \
          `rising` is 1 in the last tick of that.",
    source: "SN7497 data sheet (synchronous 6-bit binary rate multiplier)",
    parameters: &[],
    ports: &[
        PortDescription::input("clock_low", Width::BIT, "1 while the clock pin is low, that is during a pulse"),
        PortDescription::input("rising", Width::BIT, "1 in the last tick before the clock pin rises"),
        PortDescription::input("clr", Width::BIT, "clear, active high"),
        PortDescription::input("strb", Width::BIT, "strobe, inhibits when high"),
        PortDescription::input("enin", Width::BIT, "enable input, counts when low"),
        PortDescription::input("unity", Width::BIT, "unity/cascade input"),
        PortDescription::input("rate", Width::Fixed(6), "rate inputs F (weight 32) to A (weight 1)"),
        PortDescription::output("y", Width::BIT, "pulses, active high while unity is 1"),
        PortDescription::output("z", Width::BIT, "pulses, active low"),
        PortDescription::output("enout", Width::BIT, "enable output, low in state 63"),
    ],
    clocked: true,
};

fn build(b: &mut Builder) {
    let (clr, strb, enin) = (b.input("clr"), b.input("strb"), b.input("enin"));
    let (clock_low, rising, rate) = (b.input("clock_low"), b.input("rising"), b.input("rate"));
    let inhibited = b.or(clr, strb);
    let released = b.not(inhibited);
    let enabled = b.not(enin);
    let edge = b.and(clock_low, rising);

    let held = b.hold(6, 0);
    let zero = b.constant(0, 6);
    let state = b.mux(clr, zero, held.q);
    b.name("state", state);
    let one = b.constant(1, 6);
    let next = b.add(state, one);
    let step = b.all(&[edge, released, enabled]);
    b.load(held, next, step, clr);

    let not_state = b.not(state);
    let open = b.and(not_state, next);
    b.name("open", open);
    let bits: Vec<_> = (0..6).rev().map(|bit| b.pick(rate, bit)).collect();
    let heaviest_first = b.join(&bits);
    let passing = b.and(open, heaviest_first);
    let selected = b.reduce_or(passing);
    let pulse = b.all(&[clock_low, released, selected]);
    let z = b.not(pulse);
    b.output("z", z);
    let both = b.and(z, b.input("unity"));
    let y = b.not(both);
    b.output("y", y);
    let last = b.reduce_and(state);
    let carry = b.and(last, enabled);
    let enout = b.not(carry);
    b.output("enout", enout);
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    fn running(rate: i64) -> Bench {
        let mut bench = Bench::new("sn7497", &[]);
        bench.set_all(&[("rate", rate), ("unity", 1), ("clock_low", 1), ("rising", 1)]);
        bench
    }

    #[test]
    fn every_rate_gives_its_count_in_64_clocks_and_enable_out_is_low_in_state_63_only() {
        for rate in 0..64 {
            let mut bench = running(rate);
            let mut pulses = 0;
            for state in 0..64 {
                assert_eq!(bench.get("state"), state);
                assert_eq!(bench.get("y"), 1 - bench.get("z"), "unity high inverts z");
                assert_eq!(bench.get("enout"), u64::from(state != 63));
                pulses += bench.get("y");
                bench.tick();
            }
            assert_eq!(pulses, rate as u64);
        }
    }

    #[test]
    fn strobe_and_clear_keep_z_high_and_stop_the_count() {
        for (pin, state_after) in [("strb", 1), ("clr", 0)] {
            let mut bench = running(63);
            bench.tick();
            bench.set(pin, 1);
            assert_eq!((bench.get("z"), bench.get("y")), (1, 0), "{pin}");
            bench.tick();
            bench.set(pin, 0);
            assert_eq!(bench.get("state"), state_after, "{pin}");
        }
    }

    #[test]
    fn clear_is_asynchronous() {
        let mut bench = running(0);
        (0..63).for_each(|_| bench.tick());
        assert_eq!(bench.get("enout"), 0);
        bench.set("clr", 1);
        assert_eq!((bench.get("enout"), bench.get("state")), (1, 0));
    }

    #[test]
    fn enable_high_stops_the_count_and_raises_enable_out_and_unity_low_raises_y() {
        let mut bench = running(0);
        (0..63).for_each(|_| bench.tick());
        bench.set("enin", 1);
        bench.tick();
        assert_eq!((bench.get("state"), bench.get("enout")), (63, 1));
        bench.set("unity", 0);
        assert_eq!(bench.get("y"), 1);
    }

    #[test]
    fn nothing_passes_while_the_clock_is_high() {
        let mut bench = running(63);
        bench.set("clock_low", 0);
        assert_eq!(bench.get("z"), 1);
        bench.tick();
        assert_eq!(bench.get("state"), 0);
    }
}
