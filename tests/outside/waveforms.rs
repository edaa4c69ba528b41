//! Our waveforms in the hands of others: `wellen`, `vcd2fst`, `fst2vcd` and GTKWave itself.

use std::io::Cursor;
use std::path::Path;

use proptest::prelude::*;
use stepwright::golden::{How, Input, Signals, Waveform, compare, diff, read};
use stepwright::trace::{Plan, SaveText};

use super::tools;
use super::trace::Trace;

/// Every signal at every tick as our own reader finds it.
fn check_with_our_reader(trace: &Trace, file: &[u8]) {
    let wave = read("ours", file).expect("our own file");
    assert!(wave.is_closed());
    assert_eq!(wave.names().count(), trace.signals.len());
    assert_eq!(wave.span(), trace.first..trace.first + trace.words.len() as u64);
    for (tick, words) in trace.ticks() {
        for signal in &trace.signals {
            let value = wave.track(&signal.path.join(".")).and_then(|track| track.at(tick)).expect("a value");
            assert_eq!(value.word(), Some(words[signal.value.index()]), "{signal:?} at {tick}");
            assert_eq!(value.width(), signal.width);
        }
    }
}

/// Every signal at every tick as `wellen` finds it. The one place that speaks to that crate.
fn check_with_wellen(trace: &Trace, file: Vec<u8>) {
    let mut wave = wellen::simple::read_from_reader(Cursor::new(file)).expect("wellen reads it");
    let names: Vec<_> =
        wave.hierarchy().all_vars().map(|var| wave.hierarchy()[var].full_name(wave.hierarchy())).collect();
    let refs: Vec<_> = wave.hierarchy().all_vars().map(|var| wave.hierarchy()[var].signal_ref()).collect();
    assert_eq!(names.len(), trace.signals.len());
    wave.load_signals(&refs);
    for signal in &trace.signals {
        let name = signal.path.join(".");
        let at = names.iter().position(|known| *known == name).unwrap_or_else(|| panic!("no {name} in {names:?}"));
        let values = wave.get_signal(refs[at]).expect("a loaded signal");
        for (tick, words) in trace.ticks() {
            let index = wave.time_table().partition_point(|&time| time <= tick) - 1;
            let offset = values.get_offset(index as u32).expect("a value");
            let bits = values.get_value_at(&offset, offset.elements - 1).to_bit_string().expect("bits");
            assert_eq!(bits, trace.bits(signal, words), "{name} at {tick}");
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn what_we_write_as_vcd_and_fst_is_read_back_by_us_and_by_wellen(
        seed: u64, count in 1usize..40, ticks in 1usize..40, first in prop_oneof![Just(0u64), 1u64..2000],
    ) {
        let trace = Trace::random(seed, count, ticks, first);
        let vcd = trace.vcd();
        check_with_our_reader(&trace, &vcd);
        check_with_our_reader(&trace, &trace.fst());
        check_with_wellen(&trace, vcd);
        check_with_wellen(&trace, trace.fst());
    }
}

#[test]
fn an_fst_of_many_blocks_is_read_back_by_us_and_by_wellen() {
    let trace = Trace::random(7, 80, 20_000, 0);
    let fst = trace.fst();
    check_with_our_reader(&trace, &fst);
    // A block is written when it has 1 MiB, before compression.
    assert!(fst.len() > 1 << 20, "{} bytes", fst.len());
    check_with_wellen(&trace, fst);
}

/// What `fst2vcd` makes of an FST file.
fn by_fst2vcd(folder: &Path, fst: &str) -> Waveform {
    let output = tools::run(folder, "fst2vcd", &[fst]);
    read(fst, &output.stdout[..]).expect("what fst2vcd writes is read")
}

#[test]
fn vcd2fst_and_fst2vcd_keep_every_value_of_ours() {
    if !tools::present(&["vcd2fst", "fst2vcd"]) {
        return;
    }
    let folder = tempfile::tempdir().expect("a folder");
    for (seed, first) in [(1, 0), (2, 0), (3, 500)] {
        let trace = Trace::random(seed, 50, 400, first);
        let ours = read("ours", &trace.vcd()[..]).expect("our own file");
        std::fs::write(folder.path().join("ours.vcd"), trace.vcd()).expect("a file");
        std::fs::write(folder.path().join("ours.fst"), trace.fst()).expect("a file");
        // vcd2fst exits 0 whatever it is given; fst2vcd and the comparison judge.
        tools::run(folder.path(), "vcd2fst", &["ours.vcd", "converted.fst"]);
        for fst in ["converted.fst", "ours.fst"] {
            let theirs = by_fst2vcd(folder.path(), fst);
            let [a, b] = ["ours.vcd", fst].map(|file| Input::file(&folder.path().join(file)));
            let straight = diff(&a, &b, &How::default()).unwrap_or_else(|report| panic!("{report}"));
            assert!(straight.is_equal(), "{fst}: {straight}");
            let comparison = compare(&ours, &theirs, Signals::Shared);
            assert!(comparison.is_equal(), "{fst}: {comparison}");
            assert_eq!(comparison.nets, trace.signals.len());
            assert_eq!(comparison.span, first..first + 400, "{fst}");
        }
    }
}

#[test]
fn gtkwave_shows_every_row_of_a_save_file() {
    if !tools::present(&["gtkwave", "xvfb-run", "xauth"]) {
        return;
    }
    let folder = tempfile::tempdir().expect("a folder");
    let trace = Trace::random(4, 60, 50, 0);
    let plan = Plan::new(&trace.signals);
    let curves: Vec<_> = trace.signals.iter().step_by(5).map(|signal| signal.name()).collect();
    let check = concat!(env!("CARGO_MANIFEST_DIR"), "/.ci/gtkwave_check");
    for (dump, bytes) in [("run.vcd", trace.vcd()), ("run.fst", trace.fst())] {
        let save = SaveText { plan: &plan, dump, curves: &curves }.to_string();
        std::fs::write(folder.path().join(dump), bytes).expect("a file");
        std::fs::write(folder.path().join("run.gtkw"), save).expect("a file");
        let output = tools::run(folder.path(), "sh", &[check, dump, "run.gtkw"]);
        let said = String::from_utf8_lossy(&output.stdout);
        assert!(said.contains(&format!("GTKWave shows all {} rows", trace.signals.len())), "{said}");
    }
}
