//! FST files of GTKWave's converter, whole and broken.

use proptest::prelude::*;

use crate::golden::{How, Input, diff, read};

const VCD: &[u8] = include_bytes!("../../fuzz/seeds/vcd/multiplexer_21.vcd");
const FST: &[u8] = include_bytes!("../../fuzz/seeds/fst/multiplexer_21.fst");
const KINDS: &[u8] = include_bytes!("../../fuzz/seeds/fst/kinds.fst");

#[test]
fn an_fst_says_what_the_vcd_says_that_it_was_made_from() {
    let [vcd, fst] = [VCD, FST].map(|bytes| Input::bytes("test", bytes));
    let comparison = diff(&vcd, &fst, &How::default()).unwrap();
    assert!(comparison.is_equal(), "{comparison}");
    let wave = read("kinds", KINDS).unwrap();
    assert_eq!(wave.unit(), 10_000);
    let shown = |name, time| wave.track(name).unwrap().at(time).unwrap().to_string();
    assert_eq!(
        (shown("t.speed", 5), shown("t.bit[2]", 6), shown("t.bit[2]", 7)),
        ("0.5".into(), "z".into(), "1".into())
    );
    assert_eq!(shown("t.wide", 5), "x".repeat(70));
    assert_eq!(shown("t.wide", 8), format!("{}1z01", "0".repeat(66)));
}

/// Where the first block of one of these kinds begins, and where it ends.
fn block(bytes: &[u8], kinds: &[u8]) -> [usize; 2] {
    let mut at = 0;
    loop {
        let end = at + 1 + u64::from_be_bytes(bytes[at + 1..at + 9].try_into().unwrap()) as usize;
        if kinds.contains(&bytes[at]) {
            return [at, end];
        }
        at = end;
    }
}

#[test]
fn a_size_that_cannot_be_is_refused_before_memory_is_taken() {
    let changed = |at: usize, to: &[u8]| [&FST[..at], to, &FST[at + to.len()..]].concat();
    let [_, end] = block(FST, &[1, 5, 8]);
    let [widths, _] = block(FST, &[3]);
    let forged = [
        // How many times there are, more than have bytes and more than are possible.
        changed(end - 8, &[1]),
        changed(
            end - 24,
            &[[0, 0, 0, 0, 15, 0, 0, 0], FST[end - 16..end - 8].try_into().unwrap(), [0, 0, 0, 0, 14, 0, 0, 0]]
                .concat(),
        ),
        // How many signals.
        changed(widths + 9, &[[0, 0, 0, 0, 1, 0, 0, 0]; 2].concat()),
        // How often the dump was switched off.
        [FST, &[2, 0, 0, 0, 0, 0, 0, 0, 13, 255, 255, 255, 255, 15]].concat(),
    ];
    for (place, bytes) in forged.iter().enumerate() {
        let report = read("a.fst", &bytes[..]).expect_err("it is forged").to_string();
        assert!(report.contains("error[W020]: a.fst: this FST file is broken"), "{place}: {report}");
        assert!(report.contains("states a size that cannot be"), "{place}: {report}");
    }
    let report = read("a.fst", &FST[..FST.len() - 9]).expect_err("it is cut").to_string();
    assert!(report.contains("error[W020]") && report.contains("it was cut off"), "{report}");
}

#[test]
fn a_name_for_a_signal_that_cannot_be_is_refused_before_memory_is_taken() {
    // Found by fuzzing: a variable whose signal has number 2^28 - 1.
    let far: &[u8] = include_bytes!("../../fuzz/seeds/fst/far_signal.fst");
    let report = read("far.fst", far).expect_err("it is forged").to_string();
    assert!(report.contains("error[W020]: far.fst: `a` stands for a signal that no file has room for"), "{report}");
}

proptest! {
    #[test]
    fn no_change_of_an_fst_ends_in_a_panic(at in 0..KINDS.len(), with: u8, cut in 0..KINDS.len()) {
        let mut bytes = KINDS.to_vec();
        bytes[at] = with;
        let _ = read("changed", &bytes[..]);
        let _ = read("cut", &bytes[..cut]);
    }
}
