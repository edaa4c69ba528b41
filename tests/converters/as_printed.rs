//! FIG. 3 wired as its text is printed does not convert: the erratum is one.

use super::arcs::{Numbers, next_arc};
use super::rig::{Converter, deviation};

/// The largest error over some arcs of case I; what must hold for every result is not asked for.
fn worst(path: &str) -> f64 {
    let mut converter = Converter::from_file(path);
    let mut numbers = Numbers(3);
    let errors = (0..200).filter_map(|_| {
        let (data, truth) = next_arc(1, &mut numbers);
        converter.convert_unchecked(&data).map(|got| deviation(got, truth))
    });
    errors.fold(0.0, f64::max)
}

#[test]
fn the_text_of_figure_3_gives_wrong_curves_and_its_repair_right_ones() {
    assert!(worst("tests/circuits/us3809868/fig03_as_printed.v") > 1000.0);
    assert!(worst("circuits/us3809868/fig03_case1.v") < 0.51);
}
