//! Analyzer 338: velocity and acceleration of trains of pulses whose law is known.

use super::machine::Machine;

const BITS: i32 = 10;

/// Sends a pulse on X, up or down, whenever `x` of the tick has come to another whole number; the same with Y. Calls `judge`
/// after each tick.
fn follow(ticks: i32, x: impl Fn(f64) -> f64, y: impl Fn(f64) -> f64, mut judge: impl FnMut(f64, &Machine)) {
    let mut machine = Machine::shipped("us3809868/analyzer_338", &[("BITS", BITS.into())]);
    let mut at = [0.0; 2];
    for tick in (0..ticks).step_by(2) {
        let t = f64::from(tick);
        let steps = [x(t).floor() - at[0], y(t).floor() - at[1]];
        at = [x(t).floor(), y(t).floor()];
        let line = |axis: usize, way: f64| i64::from(steps[axis] * way > 0.0);
        let lines = [("up_304", 0, 1.0), ("down_306", 0, -1.0), ("up_314", 1, 1.0), ("down_316", 1, -1.0)];
        machine.set(&lines.map(|(name, axis, way)| (name, line(axis, way))));
        machine.tick();
        machine.set(&lines.map(|(name, ..)| (name, 0)));
        machine.tick();
        judge(t, &machine);
    }
}

#[test]
fn a_steady_train_has_its_rate_for_velocity_and_no_acceleration() {
    let time = f64::from(1 << BITS);
    for (x_rate, y_rate) in [(0.1, -0.03), (-0.4, 0.25), (0.0, 0.5), (0.013, 0.0)] {
        let judge = |t: f64, machine: &Machine| {
            if t > 8.0 * time {
                for (net, rate) in [("velocity_x", x_rate), ("velocity_y", y_rate)] {
                    let velocity = machine.get_signed(net) as f64;
                    assert!((velocity - rate * time).abs() <= 2.0, "{net} is {velocity} at rate {rate}");
                }
                assert!(machine.get("acceleration") <= 2, "rates {x_rate}, {y_rate}");
            }
        };
        follow(16 << BITS, |t| x_rate * t, |t| y_rate * t, judge);
    }
}

/// X = a t^2 / 2 has acceleration a; the velocity lags by the time of the loop.
#[test]
fn a_train_that_quickens_has_its_acceleration() {
    let time = f64::from(1 << BITS);
    for (x_twice, y_twice) in [(12.0, 0.0), (0.0, -20.0), (18.0, 24.0)] {
        let [ax, ay] = [x_twice, y_twice].map(|a| a / (time * time));
        let judge = |t: f64, machine: &Machine| {
            if t > 8.0 * time {
                let velocity = machine.get_signed("velocity_x") as f64;
                assert!((velocity - ax * (t - time) * time).abs() <= 3.0, "velocity {velocity} at {t}");
                for (net, exact) in [("acceleration_x", x_twice), ("acceleration_y", y_twice)] {
                    let measured = machine.get_signed(net) as f64;
                    assert!((measured - exact).abs() <= 3.0, "{net} is {measured} instead of {exact}");
                }
                let length = machine.get("acceleration") as f64;
                assert!((length - x_twice.hypot(y_twice)).abs() <= 3.5, "{length} for {x_twice}, {y_twice}");
            }
        };
        follow(16 << BITS, |t| ax * t * t / 2.0, |t| ay * t * t / 2.0, judge);
    }
}
