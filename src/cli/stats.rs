//! `--stats`: what the engine's specialised code runs.

use std::fmt::Write as _;

use crate::simulation::Stats;

/// The table, a leaf a line.
pub(super) fn table(engine: &str, stats: Option<&Stats>) -> String {
    let Some(Stats { whole, leaves, made_in, ticks, rests }) = stats else {
        return format!("engine {engine}: no specialised code (short runs, traced ones and large circuits have none)");
    };
    let mut text = format!(
        "engine {engine}: specialised code for {ticks} ticks, made in {:.1} ms, left {rests} times\n\
         {:>6}  {:>6}  {:>9}  share of the profile",
        made_in.as_secs_f64() * 1e3,
        "leaf",
        "ops",
        "registers"
    );
    let mut line = |name: &str, ops, registers, share| {
        let _ = write!(text, "\n{name:>6}  {ops:>6}  {registers:>9}  {share}");
    };
    line("whole", whole.ops, whole.registers, String::new());
    for ((work, share), number) in leaves.iter().zip(1..) {
        line(&format!("{number}"), work.ops, work.registers, format!("{:.1} %", share * 100.0));
    }
    text
}
