//! Operation 590: real numbers become the words of the registers.

use stepwright::host::{Case, Curve, Refusal, Stroke, Write};

use crate::converters::arcs::Numbers;

#[test]
fn words_are_the_nearest_but_end_just_on_the_nearest_count() {
    let mut numbers = Numbers(590);
    for _ in 0..2000 {
        let quarters = 1 + (numbers.between(0.0, 4.0) as u8).min(3);
        let jklm = [(); 4].map(|()| numbers.between(-2000.0, 2000.0));
        let from = [(); 2].map(|()| numbers.between(-9000.0, 9000.0));
        let curve = Curve { from, jklm, quarters };
        let stroke = curve.words().expect("all of them fit");
        // J and L are rounded alone; what K and M take over from them and the ends is at most one and a half more.
        for (at, (word, exact)) in stroke.jklm.iter().zip(jklm).enumerate() {
            let most = if at % 2 == 0 || quarters.is_multiple_of(2) { 0.5 } else { 2.0 };
            assert!((f64::from(*word) - exact).abs() <= most, "{stroke:?} {curve:?}");
        }
        let most = if quarters.is_multiple_of(2) { 2.0 } else { 0.5 };
        for (end, exact) in stroke.end().iter().zip(curve.end()) {
            assert!((f64::from(*end) - exact).abs() <= most, "{stroke:?} {curve:?}");
        }
    }
}

#[test]
fn between_whole_points_k_is_off_by_no_more_than_j() {
    let curve = Case::V { p2: [71.0, 71.0] }.curve([100.0, 0.0], [0.0, 100.0]).expect("a curve");
    let stroke = curve.words().expect("it fits");
    assert_eq!((stroke.from, stroke.end(), stroke.quarters, stroke.pen), ([100, 0], [0, 100], 1, true));
    assert_eq!(stroke.jklm, [101, 1, 1, 101]); // 100.7, 0.7, 0.7, 100.7
}

#[test]
fn what_does_not_fit_is_named_with_its_range() {
    let curve = |jklm, from| Curve { from, jklm, quarters: 4 }.words().expect_err("it does not fit");
    let beyond = |word, value, low: f64, high: f64| Refusal::TooLarge { word, value, low, high };
    assert_eq!(curve([4095.5, 0.0, 0.0, 0.0], [0.0; 2]), beyond("J", 4096.0, -4095.0, 4095.0));
    assert_eq!(curve([0.0, 0.0, 0.0, -1e300], [0.0; 2]), beyond("M", -1e300, -4095.0, 4095.0));
    assert_eq!(curve([0.0; 4], [0.0, -32768.5]), beyond("Y0", -32769.0, -32768.0, 32767.0));
    let Refusal::TooLarge { word: "L", value, .. } = curve([0.0, 0.0, f64::NAN, 0.0], [0.0; 2]) else { panic!() };
    assert!(value.is_nan());
}

#[test]
fn a_stroke_is_six_words_in_order_and_a_command() {
    let stroke = Stroke { from: [-7, 8], jklm: [-1, 2, -3, 4], quarters: 3, pen: false };
    let words = [0xFFFF, 2, 0xFFFD, 4, 0xFFF9, 8, 0b1_1001];
    let writes: Vec<_> = (0..).zip(words).map(|(address, data)| Write { address, data }).collect();
    assert_eq!(stroke.writes()[..], writes);
    assert_eq!(Stroke { quarters: 1, pen: true, ..stroke }.command(), 1);
}
