//! The system of FIG. 1: points and slopes in, pulses out, the end exactly at (X1, Y1).

use super::arcs::{Numbers, next_arc};
use super::rig::Converter;

#[test]
fn every_stroke_of_every_case_ends_exactly_at_its_last_point() {
    let mut system = Converter::shipped("fig01_system");
    let mut numbers = Numbers(1);
    for case in 1..=5 {
        for _ in 0..4 {
            let (mut data, truth) = next_arc(case, &mut numbers);
            let end = data.end();
            data.words.extend([("case_number".to_owned(), case as i64), ("quarters".to_owned(), 1)]);
            let got = system.convert_unchecked(&data).unwrap_or_else(|| panic!("{data:?}"));
            assert!(super::rig::deviation(got, truth) < 0.51, "{data:?}: {got:?}");
            assert_eq!((system.output("x"), system.output("y")), end, "{data:?}");
        }
    }
}

#[test]
fn an_unknown_case_is_refused_and_told() {
    let mut system = Converter::shipped("fig01_system");
    for case in [0, 6, 7] {
        let data = super::Data { words: vec![("case_number".to_owned(), case), ("quarters".to_owned(), 1)] };
        assert_eq!(system.convert_unchecked(&data), None, "case {case}");
    }
}
