//! Appendix A as it is printed, and what its corrections mend.

use std::f64::consts::FRAC_PI_2;

use stepwright::host::appendix::{Listing, Message, Program};
use stepwright::host::{Curve, Point};

use crate::converters::arcs::Numbers;

const BOTH: [Listing; 2] = [Listing::AsPrinted, Listing::Corrected];

fn program(listing: Listing) -> Program<'static> {
    let mut program = Program::new(listing, Box::new(|_| {}));
    program.init(1);
    program
}

/// What both listings make of one call, from (0, 0) on.
fn both<T>(call: impl Fn(&mut Program) -> T) -> [T; 2] {
    BOTH.map(|listing| call(&mut program(listing)))
}

/// How near a quarter comes to a point.
fn miss(curve: &Curve, [x, y]: Point) -> f64 {
    let away = |step: u16| {
        let [px, py] = curve.at(f64::from(step) / 2000.0 * FRAC_PI_2);
        (px - x).hypot(py - y)
    };
    (0..=2000).map(away).fold(f64::INFINITY, f64::min)
}

/// Quarters from (0, 0), whose coefficients fit the buffer, with a time between.
fn arcs(count: usize) -> Vec<(Curve, f64)> {
    let mut numbers = Numbers(460);
    let mut found = Vec::new();
    while found.len() < count {
        let jklm = [(); 4].map(|()| numbers.between(-7.0, 7.0));
        let [j, k, l, m] = jklm;
        if (j * m - k * l).abs() > 6.0 && j.abs() > 0.3 && k.abs() > 0.3 {
            found.push((Curve { from: [0.0; 2], jklm, quarters: 1 }, numbers.between(0.2, 1.35)));
        }
    }
    found
}

#[test]
fn as_printed_cases_2_and_3_keep_ends_and_slope_but_miss_the_point_between() {
    let mut missed = [Vec::new(), Vec::new()];
    for (arc, t) in arcs(300) {
        let ([j, k, l, m], inter, end) = (arc.jklm, arc.at(t), arc.end());
        let [begin, other] =
            [both(|program| program.crv3b(inter, end, m / k)), both(|program| program.crv3e(inter, end, l / j))];
        for (case, [printed, corrected]) in [begin, other].into_iter().enumerate() {
            let corrected = corrected.expect("it was taken from an arc");
            assert!(miss(&corrected, inter) < 0.02, "{corrected:?}");
            // What does not fit the words wraps, and is found all the same.
            let Ok(printed) = printed else { continue };
            assert!(printed.end().iter().zip(end).all(|(a, b)| (a - b).abs() < 1e-6), "{printed:?}");
            let [pj, pk, pl, pm] = printed.jklm;
            let slopes = if case == 0 { [pm / pk, m / k] } else { [pl / pj, l / j] };
            assert!((slopes[0] - slopes[1]).abs() < 1e-6 * slopes[1].abs().max(1.0), "{printed:?}");
            missed[case].push(miss(&printed, inter) / end[0].hypot(end[1]));
        }
    }
    for mut missed in missed {
        missed.sort_by(f64::total_cmp);
        // The reading measured 8.6 % of the chord on arcs of its own.
        let median = missed[missed.len() / 2];
        assert!(missed.len() > 250 && (0.04..0.2).contains(&median), "{} arcs, {median}", missed.len());
    }
}

#[test]
fn as_printed_a_point_of_inflection_is_not_seen_when_the_ratio_is_negative() {
    // From the vectors of case II: "E<0".
    let [printed, corrected] = both(|program| program.crv3b([0.4, 1.3], [1.0, 1.0], 0.0));
    assert!(printed.is_ok());
    assert_eq!(corrected, Err(Message::InflectionAtBegin));
    let [printed, corrected] = both(|program| program.crv3e([0.4, -0.2], [1.0, 1.0], 0.0));
    assert!(printed.is_ok());
    assert_eq!(corrected, Err(Message::InflectionAtEnd));
}

#[test]
fn as_printed_the_limits_of_each_case_divide_by_zero() {
    // E = 0 and E = 1 of cases II and III; the tangent through P0 and through P1 of case IV; a vertical chord.
    type Call = fn(&mut Program) -> Result<Curve, Message>;
    let calls: [(Call, Result<(), Message>); 6] = [
        (|program| program.crv3b([0.4, 1.0], [1.0, 1.0], 0.0), Err(Message::InflectionAtBegin)),
        (|program| program.crv3b([0.0, 0.0], [1.0, 1.0], 0.0), Err(Message::InflectionAtBegin)),
        (|program| program.crv3e([0.4, 0.0], [1.0, 1.0], 0.0), Err(Message::InflectionAtEnd)),
        (|program| program.crv3([1.0, 0.5], [2.0, 0.0], 0.5), Err(Message::RoutineCrv3)),
        (|program| program.crv3([1.0, 0.5], [2.0, 0.0], -0.5), Err(Message::RoutineCrv3)),
        (|program| program.crvmax([0.75, 1.0], [0.0, 2.0]), Ok(())),
    ];
    for (at, (call, right)) in calls.into_iter().enumerate() {
        let [printed, corrected] = both(call);
        assert_eq!(printed, Err(Message::DivisionByZero), "call {at}");
        assert_eq!(corrected.map(drop), right, "call {at}");
    }
    assert_eq!(Message::DivisionByZero.to_string(), "division by zero");
}

#[test]
fn crvmax_touches_the_farthest_point_of_a_vertical_chord_when_corrected() {
    let curve = program(Listing::Corrected).crvmax([0.75, 1.0], [0.0, 2.0]).expect("case V has no singular one");
    let [x, y] = curve.at(FRAC_PI_2 / 2.0);
    assert!((x - 0.75).hypot(y - 1.0) < 1e-12);
    let farthest = (0..=100).map(|step| curve.at(f64::from(step) / 100.0 * FRAC_PI_2)[0]).fold(0.0, f64::max);
    assert!(farthest <= 0.75 + 1e-12);
}

#[test]
fn as_printed_what_a_word_cannot_hold_is_another_number_while_the_begin_moves_as_if_it_were_right() {
    let [mut printed, mut corrected] = BOTH.map(program);
    let circle = |program: &mut Program| program.circle([0.0, 0.0], 9.0);
    assert!(circle(&mut printed).is_ok());
    // -9 is -72 eighths: 0670 octal, of which seven bits are 070 and 0110.
    assert_eq!((printed.words()[18], printed.words()[21]), (0o270, 0o310));
    assert_eq!(printed.beg(), [-9.0, 0.0]);
    assert_eq!(circle(&mut corrected), Err(Message::Range));
    assert_eq!((corrected.words().len(), corrected.beg()), (18, [0.0, 0.0]));
    assert_eq!(corrected.shtfmt(8.0, false), Err(Message::Range));
    assert_eq!((corrected.shtfmt(7.99, false), corrected.shtfmt(-8.1, false)), (Ok(()), Ok(())));
    assert_eq!(Message::Range.to_string(), "a parameter is not from -8 to 7.875");
}

#[test]
fn numbers_that_are_none_leave_nothing_behind() {
    for listing in BOTH {
        let mut program = program(listing);
        for value in [f64::NAN, f64::INFINITY] {
            assert_eq!(program.circle([0.0, 0.0], value).err(), Some(Message::DivisionByZero));
            assert_eq!(program.semi([value, 0.0], 1).err(), Some(Message::DivisionByZero));
            assert!(program.crv22([1.0, 1.0], value, 0.5).is_err());
            assert!(program.crv3([1.0, value], [2.0, 3.0], 0.5).is_err());
        }
        assert_eq!((program.words().len(), program.beg()), (18, [0.0, 0.0]));
    }
}
