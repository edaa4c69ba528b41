//! Any bytes as a VCD file.
#![no_main]

mod waveform;

libfuzzer_sys::fuzz_target!(
    // A file that begins like FST is read as such: a panic of that decoder ends in our guard.
    init: std::panic::set_hook(Box::new(|_| ())),
    |bytes: &[u8]| waveform::check(bytes)
);
