//! What the reader accepts from other tools, and what it says about broken files.

use proptest::prelude::*;

use super::*;

const GOOD: &str = "$date today $end\n$version Icarus Verilog $end\n$timescale 1ns $end\n\
    $scope module bench $end\n$var parameter 32 P WIDTH $end\n$var reg 1 ! clk $end\n\
    $scope module dut $end\n$var wire 1 ! clk $end\n$var wire 12 \" count [11:0] $end\n\
    $scope begin gen[0] $end\n$var reg 4 # \\q+ [3:0] $end\n$var wire 1 % bit [2] $end\n$upscope $end\n$upscope $end\n\
    $scope task t $end\n$var real 64 & r $end\n$upscope $end\n$upscope $end\n$enddefinitions $end\n\
    $comment Show the parameter values. $end\n$dumpall\nb1100 P\n$end\n\
    #0\n$dumpvars\nbx \"\nb1 #\n0!\n0%\nr0.5 &\n$end\n#5\nb1111 \"\n1!\nbz1 #\n#10\n0!\n#15\n";

fn message(text: &str) -> String {
    read("a.vcd", text.as_bytes()).map_or_else(|report| report.to_string(), |_| String::new())
}

fn shown(wave: &Waveform, name: &str, time: u64) -> String {
    wave.track(name).unwrap_or_else(|| panic!("{name}")).at(time).map_or("-".into(), |value| value.to_string())
}

#[test]
fn a_file_in_the_manner_of_icarus_is_read_with_aliases_scopes_ranges_and_widening() {
    let wave = read("a.vcd", GOOD.as_bytes()).unwrap();
    let names: Vec<_> = wave.names().collect();
    assert_eq!(
        names,
        [
            "bench.WIDTH",
            "bench.clk",
            "bench.dut.clk",
            "bench.dut.count",
            "bench.dut.gen[0].q+",
            "bench.dut.gen[0].bit[2]",
            "bench.t.r"
        ]
    );
    assert_eq!((wave.span(), wave.unit(), wave.top()), (0..15, 1_000_000, Some("bench")));
    assert!(wave.is_closed());
    assert_eq!((shown(&wave, "bench.WIDTH", 0), shown(&wave, "bench.t.r", 9)), ("0000000c".into(), "0.5".into()));
    let at = |name, times: [u64; 3]| times.map(|time| shown(&wave, name, time));
    assert_eq!(at("bench.dut.clk", [0, 5, 14]), ["0", "1", "0"]);
    assert_eq!(at("bench.dut.count", [4, 5, 14]), ["xxxxxxxxxxxx", "00f", "00f"]);
    assert_eq!(at("bench.dut.gen[0].q+", [0, 4, 5]), ["1", "1", "zzz1"]);
}

#[test]
fn a_file_that_cannot_be_read_to_its_end_is_no_waveform() {
    struct Torn;
    impl std::io::Read for Torn {
        fn read(&mut self, _: &mut [u8]) -> std::io::Result<usize> {
            Err(std::io::Error::other("the disk is gone"))
        }
    }
    let torn = std::io::BufReader::new(std::io::Read::chain(GOOD.as_bytes(), Torn));
    let message = read("a.vcd", torn).map_or_else(|report| report.to_string(), |_| String::new());
    assert!(message.contains("W017") && message.contains("the disk is gone"), "{message}");
}

#[test]
fn what_stands_below_a_scope_is_named_from_there() {
    let wave = read("a.vcd", GOOD.as_bytes()).unwrap().below("bench.dut");
    assert_eq!(wave.names().collect::<Vec<_>>(), ["clk", "count", "gen[0].q+", "gen[0].bit[2]"]);
}

#[test]
fn scopes_that_only_one_tool_makes_are_renamed_away() {
    let wave = read("a.vcd", GOOD.as_bytes()).unwrap().below("bench");
    let wave = wave.renamed(|name| (name != "clk").then(|| name.replace("gen[0].", "")));
    assert_eq!(wave.names().collect::<Vec<_>>(), ["WIDTH", "dut.clk", "dut.count", "dut.q+", "dut.bit[2]", "t.r"]);
}

#[test]
fn a_clocked_bench_is_seen_at_its_sample_points() {
    let text = "$timescale 1ps $end $scope module t $end $var wire 4 a n $end $upscope $end $enddefinitions $end\n\
                #0\nb0 a\n#12\nb1 a\n#15\nb10 a\n#21\nb11 a\n#40\nb100 a\n#45\n";
    let wave = read("a.vcd", text.as_bytes()).unwrap().sampled(4, 10);
    // Sample points 4, 14, 24, 34, 44.
    assert_eq!([0, 1, 2, 3, 4].map(|tick| shown(&wave, "t.n", tick)), ["0", "1", "3", "3", "4"]);
    assert_eq!((wave.span(), wave.unit()), (0..5, 1_000_000));
}

#[test]
fn broken_files_are_told_by_line() {
    let cases = [
        ("", "error[W011]: a.vcd, line 1: the file ends before `$enddefinitions`"),
        ("\u{7f}ELF\0\0", "error[W010]: a.vcd, line 1: this is not a VCD file"),
        (&GOOD[..200], "error[W011]"),
        (&GOOD[..GOOD.len() - 1], "error[W011]: a.vcd, line 38: the file ends in the middle of a command"),
        (&GOOD.replace("#10", "#3"), "error[W013]: a.vcd, line 36: time goes back from 5 to 3"),
        (&GOOD.replace("b1111 \"", "b1111 \"\n1Q"), "error[W014]: a.vcd, line 34: a value for `Q`"),
        (
            &GOOD.replace("bz1 #", "bz0101 #"),
            "error[W015]: a.vcd, line 35: 5 bits for `bench.dut.gen[0].q+`, which has 4",
        ),
        (&GOOD.replace("bit [2]", "q+"), "error[W016]: a.vcd, line 12: two signals are called `bench.dut.gen[0].q+`"),
        (&GOOD.replace("wire 12", "wire 4000000000"), "error[W015]: a.vcd, line 9: `count` has 4000000000 bits"),
        (&GOOD.replace("#15", "#15\n$upscope $end"), "error[W012]: a.vcd, line 39: a declaration after"),
        (&GOOD.replace("#15", "?"), "error[W012]: a.vcd, line 38"),
    ];
    for (text, expected) in cases {
        let message = message(text);
        assert!(message.contains(expected), "expected `{expected}`, got `{message}`");
    }
}

#[test]
fn scopes_nested_without_end_are_refused() {
    let text = "$scope module a $end ".repeat(100_000);
    assert!(message(&text).contains("nested more than 256 deep"));
}

#[test]
fn a_file_cut_between_two_lines_is_not_closed() {
    let cut = GOOD.strip_suffix("#15\n").unwrap();
    let wave = read("a.vcd", cut.as_bytes()).unwrap();
    assert!(!wave.is_closed());
    assert_eq!(wave.span(), 0..11);
    let refused = read_golden("a.vcd", cut.as_bytes()).unwrap_err();
    assert_eq!(refused.diagnostics[0].code, "W018");
    assert!(read_golden("a.vcd", GOOD.as_bytes()).is_ok());
}

proptest! {
    #[test]
    fn no_bytes_make_the_reader_panic(bytes in prop::collection::vec(any::<u8>(), 0..300)) {
        let _ = read("random", &bytes[..]);
    }

    #[test]
    fn no_change_of_a_good_file_makes_the_reader_panic(
        at in 0..GOOD.len(), with in "[ -~\\n]{0,6}", length in 0usize..20,
    ) {
        let end = (at + length).min(GOOD.len());
        let _ = read("mutated", [&GOOD.as_bytes()[..at], with.as_bytes(), &GOOD.as_bytes()[end..]].concat().as_slice());
    }
}
