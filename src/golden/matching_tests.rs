//! Two tools' files of the same thing: other scopes, buses and bits, clocks, unknowns, small delays.

use proptest::prelude::*;

use super::*;

use crate::golden::{Edge, Input, Names, Unknown, check, diff};

fn input(vars: &str, body: &str) -> Input {
    Input::bytes("test", format!("{vars} $enddefinitions $end\n{body}").into_bytes())
}

fn scope(name: &str, inside: &str) -> String {
    format!("$scope module {name} $end {inside} $upscope $end ")
}

fn var(width: u32, code: &str, name: &str) -> String {
    format!("$var wire {width} {code} {name} $end ")
}

fn tails() -> How {
    How { signals: Signals::Shared, names: Names::Tails(Vec::new()), ..How::default() }
}

fn compared(a: &Input, b: &Input, how: &How) -> Comparison {
    diff(a, b, how).unwrap_or_else(|report| panic!("{report}"))
}

#[test]
fn scopes_that_a_tool_puts_around_are_matched_by_their_common_tail() {
    let inside = scope("adder", &(var(4, "s", "sum [3:0]") + &var(1, "c", "carry")));
    let ours = input(&scope("fig1", &(inside.clone() + &var(1, "q", "q"))), "#0\nb1 s\n0c\n1q\n#9\n");
    let inside = inside + &var(1, "q", "q") + &var(1, "k", "clk");
    let theirs = scope("bench", &(var(1, "B", "clk") + &scope("dut", &inside)));
    let theirs = input(&theirs, "#0\nb1 s\n0c\n1q\n0k\n0B\n#9\n");
    let comparison = compared(&ours, &theirs, &tails());
    assert!(comparison.is_equal(), "{comparison}");
    assert_eq!(comparison.nets, 3);
    assert_eq!((comparison.missing.len(), comparison.extra), (0, vec!["bench.clk".into(), "bench.dut.clk".into()]));
    assert!(!compared(&ours, &theirs, &How::default()).is_equal());
}

#[test]
fn of_several_scopes_with_the_same_names_the_one_that_shares_most_is_taken() {
    let two = var(1, "a", "a") + &var(1, "b", "b");
    let ours = input(&scope("top", &two), "#0\n0a\n1b\n#9\n");
    let theirs = scope("x", &scope("near", &two)) + &scope("y", &var(1, "A", "a"));
    let theirs = input(&theirs, "#0\n0a\n1b\n1A\n#9\n");
    let comparison = compared(&ours, &theirs, &tails());
    assert!(comparison.is_equal() && comparison.extra == ["y.a"], "{comparison}");
    let maps = vec![("top.a".to_owned(), "y.a".to_owned())];
    let mapped = compared(&ours, &theirs, &How { names: Names::Tails(maps), ..tails() });
    assert_eq!((mapped.divergence.map(|found| found.nets[0].name.clone()), mapped.nets), (Some("top.a".into()), 2));
}

#[test]
fn a_bus_is_compared_with_its_bits_in_both_directions() {
    let bus = input(&scope("t", &var(3, "v", "v [2:0]")), "#0\nb110 v\n#3\nb1x1 v\n#9\n");
    let bits = |last: char| {
        let vars: String = (0..3).map(|i| var(1, &format!("b{i}"), &format!("v [{i}]"))).collect();
        input(&scope("u", &vars), &format!("#0\n0b0\n1b1\n1b2\n#3\n1b0\nxb1\n#7\n{last}b2\n#9\n"))
    };
    for (a, b, name) in [(bus.clone(), bits('1'), "t.v"), (bits('1'), bus.clone(), "t.v")] {
        let comparison = compared(&a, &b, &tails());
        assert!(comparison.is_equal() && comparison.nets == 1, "{name}: {comparison}");
    }
    for (a, b) in [(bus.clone(), bits('0')), (bits('0'), bus)] {
        let found = compared(&a, &b, &tails()).divergence.expect("bit 2 differs");
        assert_eq!((found.tick, found.nets[0].name.as_str()), (7, "t.v"));
    }
}

#[test]
fn a_clocked_file_is_looked_at_just_before_its_edges() {
    // The register q answers to the rising edges of clk at 5, 15 and 25, the net d a little after the falling ones.
    let clocked = var(1, "k", "clk") + &var(4, "q", "q");
    let clocked =
        input(&clocked, "#0\n0k\nb0 q\n#5\n1k\nb1 q\n#10\n0k\n#15\n1k\nb10 q\n#20\n0k\n#25\n1k\nb11 q\n#30\n");
    let ticks = input(&var(4, "q", "q"), "#0\nb0 q\n#1\nb1 q\n#2\nb10 q\n#3\n");
    let edge = |is_rising| Some(Edge { net: "clk".into(), is_rising });
    let how = How { signals: Signals::Shared, at: [edge(true), None], ..How::default() };
    let comparison = compared(&clocked, &ticks, &how);
    assert!(comparison.is_equal(), "{comparison}");
    assert_eq!((comparison.nets, comparison.span), (1, 0..3));
    // Before the falling edges at 10 and 20 the register has already answered.
    let falling = compared(&clocked, &ticks, &How { at: [edge(false), None], ..how.clone() });
    assert_eq!(falling.changed, [Changed { name: "q".into(), first: 0, ticks: 2 }]);
    let unknown = How { at: [Some(Edge { net: "clck".into(), is_rising: true }), None], ..how };
    let report = diff(&clocked, &ticks, &unknown).expect_err("no such net").to_string();
    assert!(report.contains("error[W021]") && report.contains("did you mean `clk`?"), "{report}");
}

#[test]
fn unknown_bits_are_strict_wild_or_zero() {
    let file = |value: &str| input(&var(3, "v", "v"), &format!("#0\nb{value} v\n#9\n"));
    let cases = [
        ("0x1", "0x1", [true, true, true]),
        ("0x1", "0z1", [false, true, true]),
        ("0x1", "001", [false, true, true]),
        ("0x1", "011", [false, true, false]),
        ("0x1", "100", [false, false, false]),
    ];
    for (a, b, expected) in cases {
        let found = [Unknown::Strict, Unknown::Wild, Unknown::Zero]
            .map(|unknown| compared(&file(a), &file(b), &How { unknown, ..How::default() }).is_equal());
        assert_eq!(found, expected, "{a} {b}");
    }
    let never = input(&var(3, "v", "v"), "#0\n#9\n");
    let with = |unknown| compared(&file("000"), &never, &How { unknown, signals: Signals::Shared, ..How::default() });
    assert!(!with(Unknown::Strict).is_equal() && with(Unknown::Wild).is_equal() && with(Unknown::Zero).is_equal());
}

#[test]
fn numbers_near_to_each_other_are_equal_where_that_is_asked_for() {
    let words = |value: &str| input(&var(4, "v", "v"), &format!("#0\nb{value} v\n#9\n"));
    let near = |near| How { near, ..How::default() };
    // 15 and 1 are 2 apart: as signed numbers they are -1 and 1.
    assert!(compared(&words("1111"), &words("1"), &near(2.0)).is_equal());
    assert!(!compared(&words("1111"), &words("1"), &near(1.0)).is_equal());
    let real = |value: &str| input("$var real 64 r r $end", &format!("#0\nr{value} r\n#9\n"));
    assert!(compared(&real("1.5"), &real("1.75"), &near(0.25)).is_equal());
    assert!(!compared(&real("1.5"), &real("1.75"), &near(0.2)).is_equal());
    assert!(!compared(&real("1.5"), &real("nan"), &near(1e9)).is_equal());
}

fn pulses(word: u64) -> String {
    (0..40).map(|tick| format!("#{tick}\n{}!\n", word >> tick & 1)).collect::<String>() + "#40\n"
}

proptest! {
    /// The truth by looking at every tick: which ticks differ, in which spans, which of these are too long.
    #[test]
    fn differing_ticks_are_those_that_looking_at_each_tick_finds(
        a in 0u64..1 << 40, flips in 0u64..1 << 40, sparse: u64, late in 0u64..3, start in 0u64..45, length in 0u64..45,
    ) {
        let b = a ^ flips & sparse;
        let how = How { late, window: Some(start..start + length), ..How::default() };
        let [mine, theirs] = [a, b].map(|word| input(&var(1, "!", "n"), &pulses(word)));
        let (mut expected, mut span) = (Vec::new(), Vec::new());
        for tick in start..=(start + length).min(40) {
            if tick < (start + length).min(40) && (a ^ b) >> tick & 1 == 1 {
                span.push(tick);
            } else {
                if span.len() as u64 > late {
                    expected.append(&mut span);
                }
                span.clear();
            }
        }
        let comparison = compared(&mine, &theirs, &how);
        let found = comparison.changed.first().map(|changed| (changed.first, changed.ticks));
        prop_assert_eq!(found, expected.first().map(|&first| (first, expected.len() as u64)));
        prop_assert_eq!(comparison.divergence.map(|divergence| divergence.tick), expected.first().copied());
    }

    #[test]
    fn files_compared_as_they_are_read_give_what_whole_waveforms_give(a: u64, flips in 0u64..1 << 40, coarse: bool) {
        let unit = if coarse { "$timescale 10 ns $end " } else { "" };
        let texts = [(a, ""), (a ^ flips, unit)].map(|(word, unit)| format!("{unit}{}$enddefinitions $end\n{}", var(1, "!", "n"), pulses(word)));
        let [mine, theirs] = texts.each_ref().map(|text| crate::golden::read("test", text.as_bytes()).unwrap());
        let [first, second] = texts.map(|text| Input::bytes("test", text.into_bytes()));
        prop_assert_eq!(compared(&first, &second, &How::default()), compare(&mine, &theirs, Signals::All));
    }
}

#[test]
fn a_golden_trace_that_is_cut_off_is_no_judge() {
    let whole = input(&var(1, "!", "n"), "#0\n0!\n#5\n");
    let cut = input(&var(1, "!", "n"), "#0\n0!\n#4\n1!\n");
    assert!(check(&whole, &whole).unwrap().is_equal());
    assert_eq!(check(&cut, &cut).unwrap_err().diagnostics[0].code, "W018");
}
