//! Any text.
#![no_main]

#[path = "../../tests/support/netlist_check.rs"]
mod netlist_check;

libfuzzer_sys::fuzz_target!(|text: &str| netlist_check::check(text));
