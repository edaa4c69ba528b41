//! Acceleration meter: the change of the two axes' pulse counts from one window of time to the next.
//!
//! ```text
//!   v = pulses up - pulses down in WINDOW ticks;   a = v - v of the window before
//!   acceleration = max(|ax|, |ay|) + min(|ax|, |ay|) / 2
//! ```

use crate::base::ValueId;
use crate::base::word::clog2;
use crate::blocks::{Block, Builder, Description, Kind, Parameter, Parameters, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build).with_check(check);

static DESCRIPTION: Description = Description {
    name: "acceleration_meter",
    kind: Kind::Arithmetic,
    summary: "Measures vector acceleration as the change of pulse counts between windows of time.",
    doc: "In each window of WINDOW ticks it counts the pulses of each axis with their sign, at their trailing edges. In \
          the last tick of a window `update` is 1 and `acceleration` is max(|ax|, |ay|) + min(|ax|, |ay|) / 2 (rounded \
          down), ax and ay being the change of the counts since the window before; that is within +11.8 % of the length \
          of the vector. At other ticks `acceleration` is what it would be if the window ended now. `clear` forgets all \
          counts. A window should hold some 20 pulses, because the jitter of a rate multiplier, about two pulses, is \
          measured too.",
    source: "US 3,809,868, FIG. 10, digital differential analyzer 338; the window form and the magnitude are chosen",
    parameters: &[
        Parameter { name: "WINDOW", default: 1000, min: 2, max: 65536, doc: "ticks of a window" },
        Parameter { name: "WIDTH", default: 12, min: 4, max: 20, doc: "bits of the acceleration" },
    ],
    ports: &[
        PortDescription::input("clear", Width::BIT, "forgets all counts and starts a window"),
        PortDescription::input("x_up", Width::BIT, "line 304"),
        PortDescription::input("x_down", Width::BIT, "line 306"),
        PortDescription::input("y_up", Width::BIT, "line 314"),
        PortDescription::input("y_down", Width::BIT, "line 316"),
        PortDescription::output("acceleration", Width::Param("WIDTH"), "pulses per window, per window"),
        PortDescription::output("update", Width::BIT, "1 in the last tick of a window"),
    ],
    clocked: true,
};

fn check(p: &Parameters) -> Result<(), String> {
    // The worst case is full speed reversed on both axes: 2 WINDOW + 2 WINDOW / 2.
    let (window, width) = (p.get("WINDOW"), p.get("WIDTH"));
    let worst = 3 * window;
    if worst >> width != 0 {
        let enough = clog2(worst.unsigned_abs() + 1);
        return Err(format!("an acceleration of up to {worst} does not fit {width} bits: take WIDTH {enough}"));
    }
    Ok(())
}

fn build(b: &mut Builder) {
    let update = window_end(b);
    b.output("update", update);
    let ax = b.scope("x", |b| axis(b, "x_up", "x_down", update));
    let ay = b.scope("y", |b| axis(b, "y_up", "y_down", update));
    let x_less = b.less(ax, ay);
    let (larger, smaller) = (b.mux(x_less, ay, ax), b.mux(x_less, ax, ay));
    let one = b.bit(true);
    let half = b.shift_right(smaller, one);
    let acceleration = b.add(larger, half);
    b.output("acceleration", acceleration);
}

/// Counts the ticks of a window; 1 in the last of them.
fn window_end(b: &mut Builder) -> ValueId {
    let window = b.count("WINDOW");
    let width = clog2(window.into());
    let ticks = b.hold(width, 0);
    b.name("ticks", ticks.q);
    let last = b.is(ticks.q, u64::from(window) - 1);
    let one = b.constant(1, width);
    let more = b.add(ticks.q, one);
    let restart = b.or(last, b.input("clear"));
    b.load(ticks, more, None, restart);
    last
}

/// The magnitude of the change of one axis' pulse count since the window before.
fn axis(b: &mut Builder, up: &str, down: &str, update: ValueId) -> ValueId {
    let width = b.count("WIDTH");
    let clear = b.input("clear");
    let (up, down) = (b.falls(b.input(up)), b.falls(b.input(down)));
    let count = b.hold(width, 0);
    b.name_signed("count", count.q);
    let (up, down) = (b.zero_extend(up, width), b.zero_extend(down, width));
    let more = b.add(count.q, up);
    let counted = b.sub(more, down);
    let restart = b.or(update, clear);
    b.load(count, counted, None, restart);

    let before = b.hold(width, 0);
    b.name_signed("previous", before.q);
    b.load(before, counted, update, clear);
    let change = b.sub(counted, before.q);
    let (negative, opposite) = (b.sign(change), b.negate(change));
    b.mux(negative, opposite, change)
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    /// Pulses of each axis in each window of 20 ticks, negative for down; the accelerations reported.
    fn measure(windows: &[(i64, i64)]) -> Vec<u64> {
        let mut bench = Bench::new("acceleration_meter", &[("WINDOW", 20), ("WIDTH", 8)]);
        let mut reported = Vec::new();
        for (x, y) in windows {
            for tick in 0..20 {
                let line = |count: i64| i64::from(tick % 2 == 0 && tick / 2 < count);
                bench.set_all(&[("x_up", line(*x)), ("x_down", line(-x)), ("y_up", line(*y)), ("y_down", line(-y))]);
                assert_eq!(bench.get("update"), u64::from(tick == 19));
                if tick == 19 {
                    reported.push(bench.get("acceleration"));
                }
                bench.tick();
            }
        }
        reported
    }

    #[test]
    fn it_reports_the_change_of_velocity_as_maximum_plus_half_the_minimum() {
        // Changes: (3,0), (0,0), (-3,4), (0,-8), (10,14), (-20,0).
        let windows = [(3, 0), (3, 0), (0, 4), (0, -4), (10, 10), (-10, 10)];
        assert_eq!(measure(&windows), [3, 0, 4 + 1, 8, 14 + 5, 20]);
    }

    #[test]
    fn a_long_pulse_counts_once_at_its_trailing_edge() {
        let mut bench = Bench::new("acceleration_meter", &[("WINDOW", 10), ("WIDTH", 8)]);
        let mut seen = Vec::new();
        for x_up in [1, 1, 1, 0, 0] {
            bench.set("x_up", x_up);
            seen.push(bench.get("acceleration"));
            bench.tick();
        }
        assert_eq!(seen, [0, 0, 0, 1, 1]);
    }
}
