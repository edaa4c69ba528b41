//! Other circuits every day: all engines and Icarus agree on what several random modules inside one another do.

use std::io::Write;
use std::time::SystemTime;

use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::{RngAlgorithm, TestRng, TestRunner};
use stepwright::base::word::mask;
use stepwright::base::{Change, Stimulus, StopRule};
use stepwright::simulation::{Circuit, EngineKind};

use super::circuits::{held_against, icarus};
use super::random::Random;
use super::tools;
use crate::generate::composites::{composites, write};

/// How many circuits a day.
const CIRCUITS: u64 = 12;
const TICKS: u64 = 40;
const SEED: &str = "STEPWRIGHT_SEED";

/// The days since 1970, or what was asked for.
fn seed() -> u64 {
    let asked = std::env::var(SEED).ok().map(|text| text.parse().expect("the seed is a number"));
    asked.unwrap_or_else(|| {
        SystemTime::now().duration_since(SystemTime::UNIX_EPOCH).map_or(0, |time| time.as_secs() / 86_400)
    })
}

#[test]
fn all_engines_and_icarus_agree_on_the_composite_circuits_of_the_day() {
    if !tools::present(&["iverilog", "vvp"]) {
        return;
    }
    let seed = seed();
    // Straight to the standard error: the test harness hides what is printed by a test that passes.
    let told = format!("\ncomposite circuits of the day: {SEED}={seed} repeats them\n");
    std::io::stderr().write_all(told.as_bytes()).expect("standard error takes text");
    let mut bytes = [0; 32];
    bytes[..8].copy_from_slice(&seed.to_le_bytes());
    let rng = TestRng::from_seed(RngAlgorithm::ChaCha, &bytes);
    let mut runner = TestRunner::new_with_rng(ProptestConfig::default(), rng);
    for i in 0..CIRCUITS {
        let parts = composites().new_tree(&mut runner).expect("a circuit").current();
        let text = write(&parts);
        judge(&text, seed ^ i << 32).unwrap_or_else(|why| panic!("{SEED}={seed}, circuit {i}: {why}\n{text}"));
    }
}

/// Runs a circuit under random inputs on every engine, and holds each against Icarus on every net and tick.
fn judge(text: &str, seed: u64) -> Result<(), String> {
    let mut wave = None;
    for engine in EngineKind::all() {
        let design = Circuit::text("random.v", text).session().engine(engine).elaborate();
        let design = design.map_err(|report| report.to_string())?;
        let widths: Vec<_> = design.inputs().map(|port| port.width).collect();
        let mut random = Random(seed);
        let each = (0..TICKS).flat_map(|tick| (0..widths.len()).map(move |input| (tick, input)));
        let changes = each.map(|(tick, input)| Change { tick, input, word: random.word() & mask(widths[input]) });
        let stop = StopRule::Ticks(TICKS);
        let stimulus = Stimulus { initial: vec![0; widths.len()], changes: changes.collect(), stop };
        let design = design.with_stimulus(stimulus);
        held_against(wave.get_or_insert_with(|| icarus(&design, TICKS)), engine.name(), &design)?;
    }
    Ok(())
}
