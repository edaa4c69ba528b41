//! Binary rate multiplier: of every 2^WIDTH pulses it passes as many as its rate says, evenly spread.
//!
//! ```text
//!            +---------+  state       gates open for weight    passes when
//!   pulse -->| counter |---/----> k trailing ones: 2^(n-1-k)   rate has that bit
//!            +---------+
//! ```

use crate::base::ValueId;
use crate::blocks::{Block, Builder, Description, Kind, Parameter, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "binary_rate_multiplier",
    kind: Kind::Pulses,
    summary: "Passes `rate` of every 2^WIDTH pulses, evenly spread, in the pattern of the SN7497.",
    doc: "A counter of n = WIDTH bits counts the input pulses from 0 after `clear`. In a state with k trailing ones \
          (k = 0 .. n-1) the gate of weight 2^(n-1-k) is open: the heaviest in every even state, the lightest in one \
          state of 2^n. The input pulse passes when the rate has the bit of the open gate. State 2^n - 1 opens no gate, \
          so the last pulse of a round never passes. A pulse may last several ticks; the counter steps at the end of the \
          tick in which `trailing` is 1. `overflow` is 1 during the last pulse of a round.\n\
          count(t+1) = clear ? 0 : pulse and trailing ? count + 1 : count",
    source: "US 3,809,868, FIG. 9 (262 to 270) and FIG. 10 (325, 327); pulse pattern of the SN7497 data sheet",
    parameters: &[Parameter {
        name: "WIDTH",
        default: 12,
        min: 1,
        max: 32,
        doc: "bits of the rate and of the counter",
    }],
    ports: &[
        PortDescription::input("clear", Width::BIT, "sets the counter to 0; wins over counting"),
        PortDescription::input("pulse", Width::BIT, "input pulse"),
        PortDescription::input("trailing", Width::BIT, "1 in the last tick of a pulse"),
        PortDescription::input("rate", Width::Param("WIDTH"), "pulses to pass of 2^WIDTH"),
        PortDescription::output("out", Width::BIT, "the pulses that pass"),
        PortDescription::output("overflow", Width::BIT, "1 during the last pulse of a round"),
    ],
    clocked: true,
};

fn build(b: &mut Builder) {
    let (clear, pulse, rate) = (b.input("clear"), b.input("pulse"), b.input("rate"));
    let trailing = b.input("trailing");
    let step = b.and(pulse, trailing);
    let (state, next) = b.scope("counter", |b| counter(b, step, clear));
    let selected = b.scope("gates", |b| gates(b, state, next, rate));
    let out = b.and(pulse, selected);
    b.output("out", out);
    let last = b.reduce_and(state);
    let overflow = b.and(pulse, last);
    b.output("overflow", overflow);
}

/// The counter's state and the state after it.
fn counter(b: &mut Builder, step: ValueId, clear: ValueId) -> (ValueId, ValueId) {
    let width = b.count("WIDTH");
    let count = b.hold(width, 0);
    let one = b.constant(1, width);
    let next = b.add(count.q, one);
    b.name("count", count.q);
    (b.load(count, next, step, clear), next)
}

/// Whether the open gate's bit is set in the rate. Gate k is open in states with k trailing ones: adding 1 carries
/// just through these, so bit k is the one that goes from 0 to 1.
fn gates(b: &mut Builder, state: ValueId, next: ValueId, rate: ValueId) -> ValueId {
    let zeros = b.not(state);
    let open = b.and(zeros, next);
    b.name("open", open);
    let bits: Vec<_> = (0..b.count("WIDTH")).rev().map(|bit| b.pick(rate, bit)).collect();
    let heaviest_first = b.join(&bits);
    let passing = b.and(open, heaviest_first);
    b.name("passing", passing);
    b.reduce_or(passing)
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    /// Which of 2^width pulses pass, and the ticks with an overflow.
    fn round(width: i64, rate: i64) -> (Vec<bool>, Vec<usize>) {
        let mut bench = Bench::new("binary_rate_multiplier", &[("WIDTH", width)]);
        bench.set_all(&[("rate", rate), ("pulse", 1), ("trailing", 1)]);
        let mut overflows = Vec::new();
        let passed = (0..1 << width).map(|i| {
            if bench.get("overflow") == 1 {
                overflows.push(i);
            }
            let out = bench.get("out") == 1;
            bench.tick();
            out
        });
        (passed.collect(), overflows)
    }

    #[test]
    fn every_rate_of_six_bits_passes_the_pattern_of_the_data_sheet() {
        for rate in 0..64_i64 {
            let (passed, overflows) = round(6, rate);
            for (state, passes) in passed.iter().enumerate() {
                // The data sheet's gates, written out: weight 32 at even states, 16 at 1 mod 4, 8 at 3 mod 8, ...
                let gates = [(32, 2, 0), (16, 4, 1), (8, 8, 3), (4, 16, 7), (2, 32, 15), (1, 64, 31)];
                let open = gates.iter().find(|(_, period, phase)| state % period == *phase);
                assert_eq!(*passes, open.is_some_and(|(weight, ..)| rate & weight != 0), "{rate} in state {state}");
            }
            assert_eq!(passed.iter().filter(|p| **p).count() as i64, rate);
            assert_eq!(overflows, [63]);
        }
    }

    #[test]
    fn a_round_of_twelve_bits_passes_just_the_rate_and_never_the_last_pulse() {
        for rate in [0, 1, 2, 2047, 2048, 2730, 4094, 4095] {
            let (passed, _) = round(12, rate);
            assert_eq!(passed.iter().filter(|p| **p).count() as i64, rate);
            assert!(!passed[4095]);
        }
    }

    #[test]
    fn a_long_pulse_counts_once_at_its_trailing_edge() {
        let mut bench = Bench::new("binary_rate_multiplier", &[("WIDTH", 6)]);
        bench.set_all(&[("rate", 32), ("pulse", 1)]);
        bench.tick();
        bench.tick();
        assert_eq!((bench.get("counter.count"), bench.get("out")), (0, 1));
        bench.set("trailing", 1);
        bench.tick();
        assert_eq!((bench.get("counter.count"), bench.get("out")), (1, 0));
        bench.set("clear", 1);
        bench.tick();
        assert_eq!(bench.get("counter.count"), 0);
    }
}
