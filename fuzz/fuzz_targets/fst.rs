//! Any bytes as an FST file.
#![no_main]

mod waveform;

libfuzzer_sys::fuzz_target!(
    // A panic of the decoder ends in our guard; only one that comes out is a finding.
    init: std::panic::set_hook(Box::new(|_| ())),
    |bytes: &[u8]| waveform::check(bytes)
);
