//! What is not the same, or cannot be compared, is never called equal.

use super::*;
use crate::golden::read;

fn file(timescale: &str, vars: &str, body: &str) -> Waveform {
    let text =
        format!("$timescale {timescale} $end $scope module t $end {vars} $upscope $end $enddefinitions $end\n{body}");
    read("test", text.as_bytes()).unwrap_or_else(|report| panic!("{report}"))
}

fn compared(a: &Waveform, b: &Waveform) -> Comparison {
    compare(a, b, Signals::All)
}

#[test]
fn reals_that_differ_are_a_difference() {
    let wave = |value: &str| {
        file("1 ns", "$var real 64 r speed $end $var wire 1 ! a $end", &format!("#0\nr0.5 r\n0!\n#3\nr{value} r\n#9\n"))
    };
    let comparison = compared(&wave("1.25"), &wave("1.5"));
    let divergence = comparison.divergence.as_ref().expect("a difference");
    assert_eq!((divergence.tick, divergence.nets[0].name.as_str()), (3, "t.speed"));
    assert!(comparison.to_string().starts_with("tick 3: t.speed expected 1.25, got 1.5\n"), "{comparison}");
    assert!(compared(&wave("1.25"), &wave("1.25e0")).is_equal());
    // The same number in other words.
    assert!(compared(&wave("0"), &wave("-0.0")).is_equal());
    assert!(compared(&wave("nan"), &wave("NaN")).is_equal());
}

#[test]
fn a_parameter_that_differs_is_a_difference() {
    let wave = |value: &str| {
        file("1 ns", "$var parameter 8 p W $end $var wire 1 ! a $end", &format!("b{value} p\n#5\n0!\n#9\n"))
    };
    assert!(!compared(&wave("101"), &wave("111")).is_equal());
    assert_eq!(compared(&wave("101"), &wave("101")).span, 5..9);
}

#[test]
fn texts_and_events_are_named_as_not_compared() {
    for kind in ["string 0", "event 1"] {
        let wave = file("1 ns", &format!("$var {kind} s what $end $var wire 1 ! a $end"), "#0\n0!\n#9\n");
        let comparison = compared(&wave, &wave);
        assert!(!comparison.is_equal());
        assert!(comparison.to_string().contains("t.what: cannot be compared"), "{comparison}");
    }
}

#[test]
fn times_that_do_not_fit_the_finer_unit_are_said_and_not_equal() {
    // 20,000,000,000 s are 2 * 10^19 ns, more than 64 bits hold.
    let late =
        |bit: char| file("1 s", "$var wire 1 ! a $end", &format!("#0\n0!\n#20000000000\n{bit}!\n#20000000001\n"));
    let fine = file("1 ns", "$var wire 1 ! a $end", "#0\n0!\n#18446744073709551614\n");
    for coarse in [late('0'), late('1')] {
        let comparison = compared(&coarse, &fine);
        assert!(comparison.beyond && !comparison.is_equal());
        assert!(comparison.to_string().contains("times are too large"), "{comparison}");
    }
}

#[test]
fn a_time_that_has_none_after_it_is_refused() {
    let text = |time: &str| format!("$var wire 1 ! a $end $enddefinitions $end\n#0\n0!\n#{time}\n1!\n");
    for time in ["18446744073709551615", "18446744073709551616", "99999999999999999999999"] {
        let report = read("a.vcd", text(time).as_bytes()).expect_err("it is too large").to_string();
        assert!(report.contains("error[W012]: a.vcd, line 4"), "{report}");
        assert!(report.contains("below 18446744073709551615"), "{report}");
    }
    let wave = read("a.vcd", text("18446744073709551614").as_bytes()).unwrap();
    assert_eq!(wave.span(), 0..u64::MAX);
    assert_eq!(wave.track("a").unwrap().at(u64::MAX - 1).unwrap().word(), Some(1));
}

#[test]
fn waveforms_without_a_tick_in_common_are_not_equal() {
    let wave = |from: u64| file("1 ns", "$var wire 1 ! a $end", &format!("#{from}\n0!\n#{}\n", from + 5));
    let comparison = compare(&wave(0), &wave(5), Signals::Shared);
    assert!(!comparison.is_equal());
    assert_eq!(comparison.to_string(), "the waveforms have no tick in common\n");
}
