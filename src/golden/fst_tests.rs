//! FST files of GTKWave's converter, whole and broken.

use proptest::prelude::*;

use crate::golden::{How, Input, diff, read};

const VCD: &[u8] = include_bytes!("../../fuzz/seeds/vcd/multiplexer_21.vcd");
const FST: &[u8] = include_bytes!("../../fuzz/seeds/fst/multiplexer_21.fst");
const KINDS: &[u8] = include_bytes!("../../fuzz/seeds/fst/kinds.fst");

#[test]
fn an_fst_says_what_the_vcd_says_that_it_was_made_from() {
    let [vcd, fst] = [VCD, FST].map(|bytes| Input::bytes("test", bytes));
    let comparison = diff(&vcd, &fst, &How::default()).unwrap().comparison;
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

#[test]
fn a_size_that_cannot_be_is_refused_before_memory_is_taken() {
    // How many times the table of the only block with values has stands in its last eight bytes.
    let mut at = 0;
    while ![1, 5, 8].contains(&FST[at]) {
        at += 1 + u64::from_be_bytes(FST[at + 1..at + 9].try_into().unwrap()) as usize;
    }
    let end = at + 1 + u64::from_be_bytes(FST[at + 1..at + 9].try_into().unwrap()) as usize;
    let mut broken = FST.to_vec();
    broken[end - 8] = 1;
    for (bytes, why) in [(&broken[..], "states a size that cannot be"), (&FST[..FST.len() - 9], "it was cut off")] {
        let report = read("a.fst", bytes).expect_err(why).to_string();
        assert!(report.contains("error[W020]: a.fst: this FST file is broken") && report.contains(why), "{report}");
    }
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
