//! Our VCD lines against the `vcd` crate's, and the shape of the whole file.

use ::vcd::{SimulationCommand, Value};
use proptest::prelude::*;

use super::*;
use crate::base::word::mask;
use crate::base::{Signal, ValueId};
use crate::trace::{Frame, Sampler, Window};

fn signals(widths: &[u32]) -> Vec<Signal> {
    let signal = |(i, &width): (usize, &u32)| Signal {
        path: vec!["top".into(), format!("net_{i}")],
        width,
        signed: false,
        fraction: None,
        value: ValueId::new(i),
    };
    widths.iter().enumerate().map(signal).collect()
}

fn ours(signals: &[Signal], history: &[(u64, Vec<u64>)]) -> Vec<u8> {
    let plan = Plan::new(signals);
    let mut sampler = Sampler::new(&plan, Window::ALL);
    let mut writer = VcdWriter::new(Vec::new(), &plan).unwrap();
    let mut before = None;
    for (tick, words) in history {
        let frame = Frame { tick: *tick, words, before };
        writer.tick(*tick, sampler.sample(frame).unwrap()).unwrap();
        before = Some(words.as_slice());
    }
    writer.finish().unwrap()
}

/// The same file by the crate alone, with a plain comparison of words instead of a sampler.
fn by_the_crate(signals: &[Signal], history: &[(u64, Vec<u64>)]) -> Vec<u8> {
    let mut writer = Writer::new(Vec::new());
    writer.version("Stepwright").unwrap();
    writer.timescale(1, TimescaleUnit::NS).unwrap();
    writer.add_module("top").unwrap();
    let ids: Vec<_> = signals
        .iter()
        .map(|signal| {
            let range = (signal.width > 1).then(|| ReferenceIndex::Range(signal.width as i32 - 1, 0));
            writer.add_var(VarType::Wire, signal.width, &signal.path[1], range).unwrap()
        })
        .collect();
    writer.upscope().unwrap();
    writer.enddefinitions().unwrap();
    let mut end = 0;
    for (step, (tick, words)) in history.iter().enumerate() {
        let changed: Vec<_> = (0..words.len()).filter(|&i| step == 0 || history[step - 1].1[i] != words[i]).collect();
        if !changed.is_empty() || step == 0 {
            writer.timestamp(*tick).unwrap();
        }
        if step == 0 {
            writer.begin(SimulationCommand::Dumpvars).unwrap();
        }
        for i in changed {
            let bit = |at: u32| Value::from(words[i] >> at & 1 == 1);
            match signals[i].width {
                1 => writer.change_scalar(ids[i], bit(0)).unwrap(),
                width => writer.change_vector(ids[i], (0..width).rev().map(bit)).unwrap(),
            }
        }
        if step == 0 {
            writer.end().unwrap();
        }
        end = tick + 1;
    }
    writer.timestamp(end).unwrap();
    writer.writer().clone()
}

fn histories() -> impl Strategy<Value = (Vec<u32>, Vec<(u64, Vec<u64>)>)> {
    prop::collection::vec(prop_oneof![2 => Just(1u32), 3 => 1u32..=64], 1..120).prop_flat_map(|widths| {
        let words = widths.iter().map(|&width| (0..=mask(width)).boxed()).collect::<Vec<_>>();
        let step = (1u64..2000, prop_oneof![words.prop_map(Some), Just(None)]);
        let history = prop::collection::vec(step, 0..20).prop_map(|steps| {
            let mut tick = 0;
            let mut last = None;
            let mut history = Vec::new();
            for (pause, words) in steps {
                last = words.or(last);
                history.extend(last.clone().map(|words| (tick, words)));
                tick += pause;
            }
            history
        });
        (Just(widths), history)
    })
}

proptest! {
    #[test]
    fn the_fast_path_writes_byte_for_byte_what_the_crate_writes((widths, history) in histories()) {
        let signals = signals(&widths);
        let (ours, theirs) = (ours(&signals, &history), by_the_crate(&signals, &history));
        prop_assert_eq!(String::from_utf8(ours).unwrap(), String::from_utf8(theirs).unwrap());
    }
}

#[test]
fn a_file_longer_than_the_buffer_is_still_what_the_crate_writes() {
    let widths: Vec<u32> = (1..=64).chain([1; 40]).collect();
    let word = |tick: u64, i: usize| tick.wrapping_mul(0x9E37_79B9_7F4A_7C15).rotate_left(i as u32) & mask(widths[i]);
    let history: Vec<_> = (0..1000).map(|tick| (tick, (0..widths.len()).map(|i| word(tick, i)).collect())).collect();
    let signals = signals(&widths);
    let text = ours(&signals, &history);
    assert!(text.len() > 4 * BUFFER);
    assert!(text == by_the_crate(&signals, &history));
}

#[test]
fn the_longest_identifier_and_the_widest_word_fit_in_a_line() {
    let line = Line::new(Slot { value: ValueId::new(0), width: 64 }, IdCode::from(u32::MAX));
    let mut out = [0; LINE];
    let length = line.put(&mut out, u64::MAX);
    assert_eq!(out[..length], *format!("b{} {}\n", "1".repeat(64), IdCode::from(u32::MAX)).as_bytes());
}

#[test]
fn aliases_share_an_identifier_and_one_line_a_change() {
    let mut two = signals(&[4, 4]);
    two[1].value = two[0].value;
    let text = String::from_utf8(ours(&two, &[(0, vec![5]), (1, vec![6])])).unwrap();
    let expected = "$version\n    Stepwright\n$end\n$timescale 1 NS $end\n$scope module top $end\n\
                    $var wire 4 ! net_0 [3:0] $end\n$var wire 4 ! net_1 [3:0] $end\n$upscope $end\n\
                    $enddefinitions $end\n#0\n$dumpvars\nb0101 !\n$end\n#1\nb0110 !\n#2\n";
    assert_eq!(text, expected.replace("NS", "ns"));
}

#[test]
fn a_run_without_ticks_is_a_header_and_a_time() {
    let text = String::from_utf8(ours(&signals(&[1]), &[])).unwrap();
    assert!(text.ends_with("$enddefinitions $end\n#0\n"), "{text}");
}

#[test]
fn an_output_that_refuses_is_an_error() {
    struct Full;
    impl Write for Full {
        fn write(&mut self, _: &[u8]) -> io::Result<usize> {
            Err(io::ErrorKind::StorageFull.into())
        }
        fn flush(&mut self) -> io::Result<()> {
            Ok(())
        }
    }
    let refused = VcdWriter::new(Full, &Plan::new(&signals(&[1]))).map(|_| ()).unwrap_err();
    assert_eq!(refused.kind(), io::ErrorKind::StorageFull);
}
