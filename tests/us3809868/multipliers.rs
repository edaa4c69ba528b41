//! SN7497 packages and the multipliers wired from them.

use super::machine::{Machine, session, shipped_session};
use super::vectors::read;

#[test]
fn the_package_passes_the_pattern_of_every_rate() {
    let text = "module t(input wire clk, input wire [5:0] rate, output wire y);
        sn7497 u (.clk(clk), .clock_low(1'b1), .rising(1'b1), .clr(1'b0), .strb(1'b0), .enin(1'b0), .unity(1'b1),
          .rate(rate), .y(y), .z(), .enout());
      endmodule";
    let package = session("t", text, &[], &[]);
    let patterns = read("sn7497_patterns.json");
    let masks = patterns["masks"].as_object().expect("masks by rate");
    assert_eq!(masks.len(), 64);
    for (rate, pattern) in masks {
        let mut machine = Machine::new(&package);
        machine.set(&[("rate", rate.parse().expect("a rate"))]);
        let mut passed = 0_u64;
        for state in 0..64 {
            passed |= machine.get("y") << state;
            machine.tick();
        }
        assert_eq!(format!("{passed:#x}"), pattern.as_str().expect("a mask"), "rate {rate}");
    }
}

/// A wired multiplier beside the block of as many bits.
fn beside_the_block(circuit: &str, width: u32) -> Machine {
    let text = format!(
        "module t(input wire clk, input wire clear, pulse, trailing, input wire [{width}-1:0] rate,
            output wire out, overflow, block_out, block_overflow);
          {circuit} wired (.clk(clk), .clear(clear), .pulse(pulse), .trailing(trailing), .rate(rate), .out(out),
            .overflow(overflow));
          binary_rate_multiplier #(.WIDTH({width})) block (.clk(clk), .clear(clear), .pulse(pulse),
            .trailing(trailing), .rate(rate), .out(block_out), .overflow(block_overflow));
        endmodule"
    );
    Machine::new(&session("us3809868/t", &text, &[], &[]))
}

/// Runs a whole round with a pulse of one tick, and two more pulses; returns how many passed.
fn round(machine: &mut Machine, width: u32, rate: i64) -> i64 {
    machine.set(&[("clear", 1), ("pulse", 0), ("rate", rate)]);
    machine.tick();
    machine.set(&[("clear", 0), ("pulse", 1), ("trailing", 1)]);
    let [out, overflow, block_out, block_overflow] =
        ["out", "overflow", "block_out", "block_overflow"].map(|output| machine.find(output));
    let mut passed = 0;
    for state in 0..(1_u32 << width) + 2 {
        assert_eq!(machine.word(out), machine.word(block_out), "rate {rate}, state {state}");
        assert_eq!(machine.word(overflow), machine.word(block_overflow), "rate {rate}, state {state}");
        assert_eq!(machine.word(overflow) == 1, state == (1 << width) - 1);
        passed += if state >> width == 0 { machine.word(out) as i64 } else { 0 };
        machine.tick();
    }
    passed
}

#[test]
fn two_packages_are_a_multiplier_of_twelve_bits_in_every_state() {
    let mut machine = beside_the_block("brm12", 12);
    for rate in [0, 1, 63, 64, 65, 1365, 2048, 2730, 4032, 4095] {
        assert_eq!(round(&mut machine, 12, rate), rate);
    }
}

#[test]
fn three_packages_are_a_multiplier_of_eighteen_bits_in_every_state() {
    let mut machine = beside_the_block("brm18", 18);
    for rate in [0x2_AAAA, 0x3_FFFF] {
        assert_eq!(round(&mut machine, 18, rate), rate);
    }
}

#[test]
fn long_pulses_and_pauses_make_no_difference() {
    let mut machine = beside_the_block("brm12", 12);
    machine.set(&[("rate", 2731)]);
    let mut state = 12345_u64;
    for _ in 0..20_000 {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        machine.set(&[("pulse", (state >> 60 & 1) as i64), ("trailing", (state >> 61 & 1) as i64)]);
        assert_eq!(machine.get("out"), machine.get("block_out"));
        machine.tick();
    }
}

#[test]
fn the_packages_stand_as_instances_in_the_circuits() {
    for (circuit, packages) in [("brm12", 2), ("brm18", 3)] {
        let names: Vec<_> = (1..=packages).map(|i| format!("package_{i}.state")).collect();
        let names: Vec<_> = names.iter().map(String::as_str).collect();
        let run = shipped_session(&format!("us3809868/{circuit}"), &[], &names).start().expect("the circuit");
        assert_eq!(run.signals().len(), packages);
    }
}
