//! Whether a run came to what its scenario expects.

use super::{Outcome, Run};
use crate::base::word::decode;
use crate::scenario::{Expectations, Named, Number};

impl Run<'_> {
    /// A line for each expectation that failed, after [`Run::finish`] has told its outcome.
    #[must_use]
    pub fn failed_expectations(&self, expect: &Expectations, outcome: &Outcome) -> Vec<String> {
        let ticks = expect.ticks.map(|ticks| ("ticks".to_owned(), ticks.to_string(), outcome.ticks.to_string()));
        let reason = expect.stopped_by.clone();
        let reason = reason.map(|reason| ("stopped_by".to_owned(), reason, outcome.stopped_by.to_string()));
        let values = expect.outputs.iter().map(|net| self.value(net));
        let pulses = expect.pulses.iter().map(|pulse| {
            let got =
                outcome.pulses(&pulse.name).map_or("no such one-bit output".to_owned(), |count| count.to_string());
            (format!("pulses of {}", pulse.name), pulse.value.to_string(), got)
        });
        let all = ticks.into_iter().chain(reason).chain(values).chain(pulses);
        let failed = all.filter(|(_, expected, got)| expected != got);
        failed.map(|(name, expected, got)| format!("expected {name} {expected}, got {got}")).collect()
    }

    /// The name of a net, what it should be, and what it is.
    fn value(&self, expected: &Named<Number>) -> (String, String, String) {
        let name = &expected.name;
        let Ok(net) = self.net(name) else {
            return (name.clone(), expected.value.to_string(), "no such net".to_owned());
        };
        let (width, signed, fraction) = self.shape(net);
        match expected.value.encode(width, signed, fraction) {
            Ok(word) => (name.clone(), decode(word, width, signed).to_string(), self.read(net).to_string()),
            Err(error) => (name.clone(), expected.value.to_string(), format!("{}: {error}", self.read(net))),
        }
    }
}
