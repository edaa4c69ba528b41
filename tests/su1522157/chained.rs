//! Frames in a row: the table of docs/hazards.md, and the equations behind it.

#[allow(dead_code, reason = "the program's main is not called here")]
#[path = "../../examples/chained_frames.rs"]
mod chained_frames;

use chained_frames::{Errors, errors, polylines, table_row};

use super::oracle;

/// Where a frame ends, in quarters, by the equations and the signs of its projections.
fn end_of([dx, dy]: [i64; 2]) -> [i64; 2] {
    let letters = oracle::letters(dx.abs().max(dy.abs()), dx.abs().min(dy.abs()));
    let (whole, combined) = (letters.matches('U').count() as i64, letters.matches('D').count() as i64);
    let (major, minor) = (4 * whole + 3 * combined, 3 * combined);
    let (x, y) = if dx.abs() >= dy.abs() { (major, minor) } else { (minor, major) };
    [x * dx.signum(), y * dy.signum()]
}

#[test]
fn without_carrying_the_errors_of_all_frames_add_up_as_the_equations_say() {
    for (name, polyline) in polylines() {
        let (mut pen, mut corner, mut expected) = ([0, 0], [0, 0], Errors { greatest: 0.0, last: 0.0 });
        for next in &polyline {
            let segment = [next[0] - corner[0], next[1] - corner[1]];
            corner = *next;
            if segment != [0, 0] {
                let end = end_of(segment);
                pen = [pen[0] + end[0], pen[1] + end[1]];
            }
            expected.last = f64::hypot((4 * next[0] - pen[0]) as f64, (4 * next[1] - pen[1]) as f64) / 4.0;
            expected.greatest = expected.greatest.max(expected.last);
        }
        let seen = errors(&polyline, false).unwrap_or_else(|report| panic!("{report}"));
        assert!(
            (seen.last - expected.last).abs() < 1e-9 && (seen.greatest - expected.greatest).abs() < 1e-9,
            "{name}: {seen:?} {expected:?}"
        );
    }
}

#[test]
fn a_host_that_carries_the_residue_keeps_every_corner_within_three_quarters_of_a_step_on_either_axis() {
    for (name, polyline) in polylines() {
        let seen = errors(&polyline, true).unwrap_or_else(|report| panic!("{report}"));
        // Half a step by rounding to whole steps, a quarter by the frame itself.
        assert!(seen.greatest <= 0.75 * 2_f64.sqrt(), "{name}: {seen:?}");
    }
}

#[test]
fn the_table_of_the_page_is_what_the_plotter_draws() {
    let page = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/docs/hazards.md")).expect("the page");
    for (name, polyline) in polylines() {
        let row = table_row(name, &polyline).unwrap_or_else(|report| panic!("{report}"));
        assert!(page.contains(&row), "the page has not: {row}");
    }
}
