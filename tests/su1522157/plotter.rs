//! The plotter: where pen and motors come to, against vectors in floating point.

use std::f64::consts::{FRAC_PI_4, SQRT_2};

use stepwright::simulation::{Circuit, Outcome, Session};
use stepwright::trace::Select;

use super::oracle;

fn plotted(dx: i64, dy: i64, turn: i64) -> Outcome {
    let session = Session::open("su1522157/plotter").expect("the scenario");
    let session = session.input("dx", dx).input("dy", dy).input("turn_45", turn);
    session.start().and_then(|mut run| run.finish()).unwrap_or_else(|report| panic!("{report}"))
}

fn number(outcome: &Outcome, output: &str) -> i64 {
    outcome.output(output).expect("an output").number() as i64
}

/// Whole and combined steps of a segment, by the equations.
fn steps(dx: i64, dy: i64) -> (i64, i64) {
    let letters = oracle::letters(dx.abs().max(dy.abs()), dx.abs().min(dy.abs()));
    (letters.matches('U').count() as i64, letters.matches('D').count() as i64)
}

fn segments(limit: i64) -> impl Iterator<Item = (i64, i64)> {
    let all = (-limit..=limit).flat_map(move |dx| (-limit..=limit).map(move |dy| (dx, dy)));
    all.filter(|&segment| segment != (0, 0))
}

#[test]
fn every_small_segment_ends_within_a_quarter_of_its_point_and_the_motors_with_it() {
    for (dx, dy) in segments(5) {
        let outcome = plotted(dx, dy, 0);
        let (x, y) = (number(&outcome, "x"), number(&outcome, "y"));
        assert!((x - 4 * dx).abs() <= 1 && (y - 4 * dy).abs() <= 1, "({dx}, {dy}) ends at ({x}, {y}) quarters");
        assert_eq!((number(&outcome, "motor_x"), number(&outcome, "motor_y")), (x, y), "({dx}, {dy})");
        let [whole, combined] = [&["step_x_36", "step_y_37"][..], &["step_xy_38"]]
            .map(|lines| lines.iter().map(|line| outcome.pulses(line).expect("a line") as i64).sum::<i64>());
        assert_eq!((whole, combined), steps(dx, dy), "({dx}, {dy})");
    }
}

#[test]
fn a_turn_turns_every_step_and_stretches_or_shrinks_it_when_it_is_odd() {
    for (dx, dy) in [(7, 3), (-3, 7), (5, -5), (-8, -1), (0, -6), (4, 0)] {
        let (whole, combined) = steps(dx, dy);
        let main = if dx.abs() >= dy.abs() { [dx.signum(), 0] } else { [0, dy.signum()] };
        for turn in 0..8 {
            let (sin, cos) = (turn as f64 * FRAC_PI_4).sin_cos();
            // A whole step is 1 long, a combined one 0.75 sqrt 2, after the turn as before it.
            let [axis, diagonal] = if turn % 2 == 0 { [1.0, 0.75] } else { [0.75 * SQRT_2, 1.0 / SQRT_2] };
            let sum =
                |axis_part: i64, sign: i64| (whole * axis_part) as f64 * axis + (combined * sign) as f64 * diagonal;
            let end = [sum(main[0], dx.signum()), sum(main[1], dy.signum())];
            let turned = [end[0] * cos - end[1] * sin, end[0] * sin + end[1] * cos];
            let outcome = plotted(dx, dy, turn);
            let seen = ["x", "y"].map(|output| number(&outcome, output) as f64 / 4.0);
            let off = (seen[0] - turned[0]).abs().max((seen[1] - turned[1]).abs());
            assert!(off < 1e-9, "({dx}, {dy}) turned by {turn}: {seen:?} {turned:?}");
        }
    }
}

#[test]
fn a_diagonal_step_is_6_07_percent_longer_than_a_whole_one() {
    let straight = plotted(100, 0, 0);
    let turned = plotted(100, 0, 1);
    let length = |outcome: &Outcome| f64::hypot(number(outcome, "x") as f64, number(outcome, "y") as f64);
    let stretch = length(&turned) / length(&straight) - 1.0;
    assert!((stretch - 0.0607).abs() < 0.000_05, "{stretch}");
}

#[test]
fn no_two_pulses_of_a_motor_line_touch_at_the_shortest_clock_period() {
    let lines = ["pulse_right", "pulse_left", "pulse_up", "pulse_down"];
    let session = Session::open("su1522157/plotter").expect("the scenario").input("dx", 30).input("dy", -17);
    let mut run = session.observe(Select::new(lines).expect("globs")).start().expect("a run");
    let (nets, start, done) = (
        lines.map(|line| run.net(line).expect("a net")),
        run.input("start").expect("it"),
        run.net("done").expect("it"),
    );
    run.set(start, 1).expect("a bit");
    let (mut was, mut edges, mut high) = ([0; 4], 0, 0);
    while run.word(done) == 0 {
        let now = nets.map(|net| run.word(net));
        edges += now.iter().zip(was).filter(|(now, was)| **now > *was).count() as i64;
        high += now.iter().sum::<u64>() as i64;
        was = now;
        run.step(1);
        run.set(start, 0).expect("a bit");
    }
    let (whole, combined) = steps(30, -17);
    assert_eq!((edges, high), (4 * whole + 6 * combined, 4 * whole + 6 * combined), "strobes, all of them apart");
}

#[test]
fn a_segment_without_a_magnitude_is_refused_until_the_next_start() {
    let circuit = Circuit::shipped("su1522157/plotter").expect("the circuit");
    let mut run = circuit.session().input("dx", -4096).start().expect("a run");
    let [start, dx] = ["start", "dx"].map(|input| run.input(input).expect("an input"));
    let [error, busy] = ["error", "busy"].map(|net| run.net(net).expect("a net"));
    run.set(start, 1).expect("a bit");
    run.step(1);
    assert_eq!((run.word(error), run.word(busy)), (1, 0));
    run.set(dx, -4095).expect("a number that fits");
    run.step(1);
    assert_eq!((run.word(error), run.word(busy)), (0, 1));
}
