//! Delay element: gives each pulse out again some ticks later.
//!
//! ```text
//!   pulse_in  _|-|_____________
//!   pulse_out _______|-|_______     DELAY = 3
//!   active    ___|-----|_______
//! ```

use super::chain::Chain;
use crate::blocks::{Block, Builder, Description, Kind, Parameter, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "delay_element",
    kind: Kind::Timing,
    summary: "Delays a pulse by so many ticks.",
    doc: "pulse_out(t) = pulse_in(t - DELAY), 0 before that. `active` is high while a pulse is under way, the tick in \
          which it comes out included.",
    source: "SU 1522157, delay elements 13 and 22 of FIG. 1",
    parameters: &[Parameter { name: "DELAY", default: 1, min: 1, max: 1024, doc: "the delay in ticks" }],
    ports: &[
        PortDescription::input("pulse_in", Width::BIT, "the pulse"),
        PortDescription::output("pulse_out", Width::BIT, "the pulse, delayed"),
        PortDescription::output("active", Width::BIT, "a pulse is under way"),
    ],
    clocked: true,
};

fn build(b: &mut Builder) {
    let delay = b.count("DELAY");
    let chain = Chain::build(b, b.input("pulse_in"), delay);
    let pulse_out = chain.after(b, delay);
    let active = chain.holds_a_pulse(b);
    b.output("pulse_out", pulse_out);
    b.output("active", active);
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    #[test]
    fn every_pulse_comes_out_the_stated_number_of_ticks_later() {
        let pulse = |tick: i64| i64::from([0, 2, 3, 80].contains(&tick));
        for delay in [1, 2, 3, 4, 63, 64, 65, 130] {
            let mut bench = Bench::new("delay_element", &[("DELAY", delay)]);
            for tick in 0..300 {
                bench.set("pulse_in", pulse(tick));
                assert_eq!(bench.get("pulse_out") as i64, pulse(tick - delay), "delay {delay}, tick {tick}");
                let under_way = (1..=delay).any(|age| pulse(tick - age) == 1);
                assert_eq!(bench.get("active"), u64::from(under_way), "delay {delay}, tick {tick}");
                bench.tick();
            }
        }
    }
}
