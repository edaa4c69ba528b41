//! Velocity compensator: sets the rate of a function generator so that the point it moves keeps its speed.
//!
//! ```text
//!   x --[d/dt]--\
//!                >[ magnitude ]--(-)-->( deviation )--> rate := rate + rate * deviation / 8
//!   y --[d/dt]--/      reference --(+)--^
//! ```

use crate::base::ValueId;
use crate::blocks::{Block, Builder, Description, Kind, Parameter, Parameters, PortDescription, Width};

/// The rate follows the relative deviation by 2^-GAIN of it a tick. The loop of FIG. 4 answers five ticks late; it
/// would swing from 0.35 on.
const GAIN: u32 = 3;

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build).with_check(check);

static DESCRIPTION: Description = Description {
    name: "velocity_compensator",
    kind: Kind::Arithmetic,
    summary: "Regulates a rate so that the vector velocity of a moving point stays at a reference.",
    doc: "While `enable` is 1: velocity = magnitude of (x(t) - x(t-1), y(t) - y(t-1)) as in block vector_magnitude; \
          deviation = (2^VELOCITY_BITS - velocity) / 2^VELOCITY_BITS, not below -1; rate(t+1) = rate + rate * deviation / \
          8, between 2^(RATE_BITS-12) and 2^RATE_BITS - 1. While it is 0 the rate is START_RATE. While `hold` is 1 \
          the rate stays, because another one moves the point. The step is a part of the rate, so the loop behaves alike \
          for large and small curves.",
    source: "US 3,809,868, FIG. 4 and 4A, velocity compensator 102 (chosen: that the deviation is summed up, the \
             gain, and `hold`)",
    parameters: &[
        Parameter { name: "WIDTH", default: 48, min: 8, max: 49, doc: "bits of x and y" },
        Parameter {
            name: "VELOCITY_BITS",
            default: 26,
            min: 4,
            max: 40,
            doc: "the reference is 2^VELOCITY_BITS units of x and y a tick",
        },
        Parameter { name: "RATE_BITS", default: 20, min: 13, max: 24, doc: "bits of the rate" },
        Parameter { name: "START_RATE", default: 4096, min: 1, max: 1 << 24, doc: "the rate at the start" },
    ],
    ports: &[
        PortDescription::input("enable", Width::BIT, "the point moves: regulate"),
        PortDescription::input("hold", Width::BIT, "keeps the rate"),
        PortDescription::input("x", Width::Param("WIDTH"), "first coordinate").signed(),
        PortDescription::input("y", Width::Param("WIDTH"), "second coordinate").signed(),
        PortDescription::output("rate", Width::Param("RATE_BITS"), "the rate, without sign"),
    ],
    clocked: true,
};

fn check(parameters: &Parameters) -> Result<(), String> {
    let (start, bits) = (parameters.get("START_RATE"), parameters.get("RATE_BITS"));
    if start >> bits != 0 {
        return Err(format!("START_RATE is {start}, which does not fit RATE_BITS = {bits}"));
    }
    if parameters.get("VELOCITY_BITS") >= parameters.get("WIDTH") {
        return Err("VELOCITY_BITS is not below WIDTH: no coordinate can move so fast".into());
    }
    Ok(())
}

fn build(b: &mut Builder) {
    let (enable, x, y) = (b.input("enable"), b.input("x"), b.input("y"));
    let (dx, dy) = (derivative(b, x), derivative(b, y));
    let width = i64::from(b.width(dx));
    let velocity = b.block("magnitude", "vector_magnitude", &[("WIDTH", width)], &[("x", dx), ("y", dy)])[0];
    b.name("velocity", velocity);
    let deviation = deviation(b, velocity);
    b.name_signed("deviation", deviation);

    let rate = b.hold(b.count("RATE_BITS"), b.param("START_RATE") as u64);
    let next = regulated(b, rate.q, deviation);
    // The first difference spans the tick in which the point had not begun to move.
    let moving = b.delay(enable);
    let free = b.not(b.input("hold"));
    let regulating = b.and(moving, free);
    let stopped = b.not(enable);
    b.load(rate, next, regulating, stopped);
    b.output("rate", rate.q);
}

/// How much a coordinate has changed since the tick before, in one more bit.
fn derivative(b: &mut Builder, word: ValueId) -> ValueId {
    let before = b.delay(word);
    let width = b.width(word) + 1;
    let (now, before) = (b.sign_extend(word, width), b.sign_extend(before, width));
    b.sub(now, before)
}

/// Reference less velocity, not below minus the reference, in VELOCITY_BITS + 2 bits.
fn deviation(b: &mut Builder, velocity: ValueId) -> ValueId {
    let bits = b.count("VELOCITY_BITS");
    let double = b.constant(2 << bits, b.width(velocity).max(bits + 2));
    let wide = b.zero_extend(velocity, b.width(double));
    let slow = b.less(wide, double);
    let limited = b.mux(slow, wide, double);
    let limited = b.slice(limited, 0, bits + 2);
    let reference = b.constant(1 << bits, bits + 2);
    b.sub(reference, limited)
}

/// The next rate.
fn regulated(b: &mut Builder, rate: ValueId, deviation: ValueId) -> ValueId {
    let bits = b.width(rate);
    let width = bits + b.width(deviation) + 1;
    let (wide, deviation) = (b.zero_extend(rate, width), b.sign_extend(deviation, width));
    let product = b.mul(wide, deviation);
    let shift = b.constant((b.count("VELOCITY_BITS") + GAIN).into(), 6);
    let step = b.shift_right_signed(product, shift);
    let sum = b.add(wide, step);
    let (least, most) = (b.constant(1 << (bits - 12), width), b.constant((1 << bits) - 1, width));
    let low = b.less_signed(sum, least);
    let sum = b.mux(low, least, sum);
    let high = b.less_signed(most, sum);
    let sum = b.mux(high, most, sum);
    b.slice(sum, 0, bits)
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    /// Moves a point by `gain` units along (3, 4) / 5 for each unit of rate; returns the speed after so many ticks.
    fn speed_after(bench: &mut Bench, gain: f64, ticks: u32) -> f64 {
        let mut along = 0.0;
        for _ in 0..ticks {
            along += gain * bench.get("rate") as f64;
            bench.set_all(&[("x", (along * 0.6) as i64), ("y", (along * 0.8) as i64), ("enable", 1)]);
            bench.tick();
        }
        gain * bench.get("rate") as f64
    }

    #[test]
    fn the_speed_settles_at_the_reference_whatever_the_size_of_the_curve() {
        for gain in [200.0, 3000.0, 20_000.0] {
            let mut bench = Bench::new("velocity_compensator", &[("VELOCITY_BITS", 26)]);
            let speed = speed_after(&mut bench, gain, 300) / f64::from(1 << 26);
            assert!((speed - 1.0).abs() < 0.005, "{speed} of the reference at a gain of {gain}");
        }
    }

    #[test]
    fn a_point_at_rest_drives_the_rate_to_its_limit_and_disabling_starts_over() {
        let mut bench = Bench::new("velocity_compensator", &[]);
        bench.set("enable", 1);
        assert_eq!(bench.get("rate"), 4096);
        (0..200).for_each(|_| bench.tick());
        assert_eq!(bench.get("rate"), (1 << 20) - 1);
        bench.set("enable", 0);
        bench.tick();
        assert_eq!(bench.get("rate"), 4096);
    }

    #[test]
    fn a_held_rate_stays_whatever_the_point_does_and_goes_on_from_there() {
        let mut bench = Bench::new("velocity_compensator", &[]);
        bench.set("enable", 1);
        (0..20).for_each(|_| bench.tick());
        let rate = bench.get("rate");
        assert!(rate > 4096, "the point rests, so the rate has risen");
        bench.set("hold", 1);
        for x in 0..100 {
            bench.set("x", x << 30);
            assert_eq!(bench.get("rate"), rate);
            bench.tick();
        }
        bench.set("hold", 0);
        (0..2).for_each(|_| bench.tick());
        assert!(bench.get("rate") > rate, "the point rests again");
    }
}
