//! Whether a run came to what its scenario expects.

use crate::base::word::decode;
use crate::compile::Program;
use crate::scenario::Expectations;
use crate::simulation::Outcome;

/// A line for each expectation that failed.
pub(super) fn failed_expectations(expect: &Expectations, program: &Program, outcome: &Outcome) -> Vec<String> {
    let mut failed = Vec::new();
    let mut judge = |name: &str, expected: String, got: String| {
        if expected != got {
            failed.push(format!("expected {name} {expected}, got {got}"));
        }
    };
    if let Some(ticks) = expect.ticks {
        judge("ticks", ticks.to_string(), outcome.ticks.to_string());
    }
    if let Some(reason) = &expect.stopped_by {
        judge("stopped_by", reason.clone(), outcome.stopped_by.to_string());
    }
    let none = || "no such output".to_owned();
    for output in &expect.outputs {
        let found = program.outputs.iter().zip(&outcome.outputs).find(|(port, _)| port.name == output.name);
        let (expected, got) = match found {
            Some((port, &word)) => match output.value.encode(port.width, port.signed, port.fraction) {
                Ok(expected) => {
                    (decode(expected, port.width, port.signed), decode(word, port.width, port.signed).to_string())
                }
                Err(error) => (0, error),
            },
            None => (0, none()),
        };
        judge(&output.name, expected.to_string(), got);
    }
    for pulse in &expect.pulses {
        let mut counted = program.pulses.iter().zip(&outcome.pulses);
        let found = counted.find(|((output, _), _)| program.outputs[*output].name == pulse.name);
        judge(
            &format!("pulses of {}", pulse.name),
            pulse.value.to_string(),
            found.map_or_else(none, |(_, n)| n.to_string()),
        );
    }
    failed
}
