//! Any bytes as a VCD file: `cargo +nightly fuzz run vcd seeds/vcd -- -dict=fuzz_targets/vcd.dict`.
#![no_main]

mod waveform;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| waveform::check(bytes));
