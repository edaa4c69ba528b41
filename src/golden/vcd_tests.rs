//! Our tokenizer against two other readers of VCD, and its memory.

use std::collections::BTreeMap;
use std::io::Cursor;

use proptest::prelude::*;

use crate::golden::{Waveform, read};

/// Digits of every signal at every time.
type Digits = BTreeMap<(String, u64), String>;

/// How wide the signals of the random files are; one is wider than a word.
const WIDTHS: [usize; 5] = [1, 4, 1, 64, 70];

/// At how many times something changes in them, at most.
const TIMES: u64 = 30;

/// A file of random changes: which signal, how much later, which digits.
fn file(changes: &[(usize, u64, String)]) -> String {
    let mut text = String::from("$date now $end\n$timescale 10 ps $end\n$scope module t $end\n");
    for (index, width) in WIDTHS.iter().enumerate() {
        text += &format!("$var wire {width} {} n{index} $end\n", code(index));
    }
    text += "$upscope $end\n$enddefinitions $end\n";
    let mut time = 0;
    for (signal, later, digits) in changes {
        time += later;
        let (signal, width) = (signal % WIDTHS.len(), WIDTHS[signal % WIDTHS.len()]);
        text += &match width {
            1 => format!("#{time}\n{}{}\n", &digits[..1], code(signal)),
            _ => format!("#{time}\nb{} {}\n", &digits[..digits.len().min(width)], code(signal)),
        };
    }
    text + &format!("#{}\n", time + 1)
}

fn code(signal: usize) -> &'static str {
    ["!", "\"", "~~", "a$9", "long_code"][signal]
}

fn widened(digits: &str, width: usize) -> String {
    let fill = match digits.as_bytes()[0] {
        b'x' | b'z' => &digits[..1],
        _ => "0",
    };
    fill.repeat(width - digits.len()) + digits
}

fn ours(wave: &Waveform) -> Digits {
    let mut all = Digits::new();
    for name in wave.names() {
        for time in wave.span() {
            let Some(value) = wave.track(name).unwrap().at(time) else { continue };
            let digit = |at| match value.bit(at) {
                (bit, false) => char::from(b'0' + u8::from(bit)),
                (bit, true) => {
                    if bit {
                        'z'
                    } else {
                        'x'
                    }
                }
            };
            all.insert((name.to_owned(), time), (0..value.width()).rev().map(digit).collect());
        }
    }
    all
}

/// Spreads changes over all times from theirs to the end of the file.
fn held(changes: BTreeMap<(String, u64), String>, end: u64) -> Digits {
    let mut all = Digits::new();
    for ((name, time), digits) in changes {
        (time..end).for_each(|time| drop(all.insert((name.clone(), time), digits.clone())));
    }
    all
}

fn by_the_crate(text: &str) -> Digits {
    let mut parser = ::vcd::Parser::new(text.as_bytes());
    let header = parser.parse_header().unwrap();
    let find = |id| (0..WIDTHS.len()).find(|i| header.find_var(&["t", &format!("n{i}")]).unwrap().code == id).unwrap();
    let (mut changes, mut now) = (BTreeMap::new(), 0);
    for command in parser {
        let (id, digits) = match command.unwrap() {
            ::vcd::Command::Timestamp(time) => {
                now = time;
                continue;
            }
            ::vcd::Command::ChangeScalar(id, value) => (id, value.to_string()),
            ::vcd::Command::ChangeVector(id, vector) => (id, vector.to_string()),
            other => panic!("{other:?}"),
        };
        let signal = find(id);
        changes.insert((format!("t.n{signal}"), now), widened(&digits, WIDTHS[signal]));
    }
    held(changes, now)
}

fn by_wellen(text: &str, end: u64) -> Digits {
    let mut wave = wellen::simple::read_from_reader(Cursor::new(text.as_bytes().to_vec())).unwrap();
    let vars: Vec<_> = wave.hierarchy().all_vars().collect();
    let mut all = Digits::new();
    for var in vars {
        let (name, signal) = {
            let hierarchy = wave.hierarchy();
            (hierarchy[var].full_name(hierarchy), hierarchy[var].signal_ref())
        };
        wave.load_signals(&[signal]);
        for time in 0..end {
            let Some(index) = wave.time_table().partition_point(|&known| known <= time).checked_sub(1) else {
                continue;
            };
            let values = wave.get_signal(signal).unwrap();
            let Some(offset) = values.get_offset(index as u32) else { continue };
            let bits = values.get_value_at(&offset, offset.elements - 1).to_bit_string().unwrap();
            all.insert((name.clone(), time), bits);
        }
    }
    all
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]

    #[test]
    fn our_reader_and_two_others_find_the_same_digits(
        changes in prop::collection::vec((0usize..5, 0u64..3, "[01xz]{1,70}"), 1..TIMES as usize),
    ) {
        let text = file(&changes);
        let wave = read("random", text.as_bytes()).unwrap();
        let found = ours(&wave);
        prop_assert_eq!(&found, &by_the_crate(&text));
        prop_assert_eq!(&found, &by_wellen(&text, wave.span().end));
    }
}

/// One wire of 65,536 bits and very many short changes of it.
fn wide(digits: [&str; 2], changes: usize) -> String {
    let mut text = String::from("$var wire 65536 ! a $end $enddefinitions $end\n");
    for time in 0..changes {
        text += &format!("#{time}\nb{} !\n", digits[time % 2]);
    }
    text + &format!("#{changes}\n")
}

#[test]
fn a_short_change_of_a_wide_wire_costs_what_it_says() {
    let cases = [(["0", "1"], (true, false)), (["x", "z"], (true, true)), (["1x", "z0"], (false, false))];
    for (digits, lowest) in cases {
        let wave = read("wide", wide(digits, 20_000).as_bytes()).unwrap();
        let track = wave.track("a").unwrap();
        assert!(track.bytes() < 4 << 20, "{} bytes", track.bytes());
        let value = track.at(1).unwrap();
        assert_eq!((value.width(), value.bit(0)), (65_536, lowest));
    }
}

#[test]
fn declarations_that_would_take_too_much_memory_are_refused_by_line() {
    let wires: String = (0..1100).map(|i| format!("$var wire 65536 c{i} n{i} $end\n")).collect();
    let report = read("a.vcd", wires.as_bytes()).expect_err("too wide in all").to_string();
    assert!(report.contains("error[W019]: a.vcd, line 1025: its signals have more than 67108864 bits"), "{report}");
    let scopes: String = (0..250).map(|_| format!("$scope module {} $end\n", "s".repeat(1000))).collect();
    let names: String = (0..300).map(|i| format!("$var wire 1 c{i} n{i} $end\n")).collect();
    let report = read("a.vcd", (scopes + &names).as_bytes()).expect_err("too long in all").to_string();
    assert!(report.contains("error[W019]") && report.contains("more than 64 MiB"), "{report}");
}

#[test]
fn what_is_wrong_is_said_in_words_with_the_way_to_mend_it() {
    let header = "$var wire 4 ! a $end $var real 64 r r $end $enddefinitions $end\n#0\n";
    let cases = [
        ("1 !\n", "`1` is a value without the code of its signal", "as in `1!`"),
        ("b12 !\n", "a value for `a` that is not made of 0, 1, x and z", "kind and width"),
        ("rfast r\n", "a value for `r` that is no number", "kind and width"),
        ("#-1\n", "a time that cannot be understood", "a whole number"),
        ("#5x\n", "a time that cannot be understood", "a whole number"),
        ("?hello\n", "`?hello` is neither a time nor a value", "a value `1!`"),
        ("$dumpsome\n", "`$dumpsome` is an unknown command", "$dumpvars"),
        ("$var wire 1 x x $end\n", "a declaration after `$enddefinitions`", "before the first value"),
    ];
    for (body, message, help) in cases {
        let report = read("a.vcd", format!("{header}{body}").as_bytes()).expect_err(body).to_string();
        assert!(report.contains("a.vcd, line 3: ") && report.contains(message) && report.contains(help), "{report}");
    }
    let report = read("a.vcd", &b"$timescale 3 ns $end\n$var wire many ! a $end\n$upscope $end\n$what $end\n"[..]);
    let report = report.expect_err("all at once").to_string();
    for part in
        ["`3ns` is no timescale", "the width `many` of `a` is no number", "none is open", "`$what` is an unknown"]
    {
        assert!(report.contains(part), "{part} in {report}");
    }
}
