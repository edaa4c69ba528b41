//! Parts of a run in a waveform: the last ticks, from a trigger on, one scope.

use std::fs;

use stepwright::golden::{Waveform, read};

use super::{folder, stderr, stepwright_in};

/// The waveform that `run` writes of table 1 with some options.
fn part(options: &[&str]) -> Waveform {
    let folder = folder();
    let output = stepwright_in(folder.path(), &[&["run", "su1522157/table1", "--wave", "p.vcd"], options].concat());
    assert!(output.status.success(), "{options:?}: {}", stderr(&output));
    let bytes = fs::read(folder.path().join("p.vcd")).expect("a file");
    read("p.vcd", &bytes[..]).unwrap_or_else(|report| panic!("{report}"))
}

/// That a part says at each of its ticks what the whole run says.
fn says_the_same(part: &Waveform, whole: &Waveform) {
    for name in part.names() {
        let [a, b] = [part, whole].map(|wave| wave.track(name).expect("a signal"));
        part.span().for_each(|tick| assert_eq!(a.at(tick), b.at(tick), "{name} at {tick}"));
    }
}

#[test]
fn the_last_ticks_are_those_of_the_whole_run() {
    // Table 1 takes 57 ticks, 0 to 56.
    let (whole, last) = (part(&[]), part(&["--last", "10"]));
    assert_eq!((whole.span(), last.span()), (0..57, 47..57));
    says_the_same(&last, &whole);
    assert_eq!(part(&["--last", "1000"]).span(), 0..57);
}

#[test]
fn a_trigger_opens_the_waveform_at_its_first_high_tick() {
    // The first combined step of the table is in tick 24.
    let (whole, triggered) = (part(&[]), part(&["--when", "step_xy_38"]));
    assert_eq!(triggered.span(), 24..57);
    says_the_same(&triggered, &whole);
    assert_eq!(part(&["--when", "step_xy_38", "--trace", "r_14"]).names().collect::<Vec<_>>(), ["interpolator.r_14"]);
}

#[test]
fn a_scope_is_traced_by_a_glob() {
    let wave = part(&["--trace", "accumulator_1.*", "--last", "3"]);
    assert!(wave.names().count() > 1);
    assert!(wave.names().all(|name| name.starts_with("interpolator.accumulator_1.")));
}
