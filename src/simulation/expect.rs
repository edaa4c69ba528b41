//! Whether a run came to what its scenario expects.

use super::{Design, Outcome, Run};
use crate::base::word::decode;
use crate::base::{Diagnostic, Signal};
use crate::scenario::{Expectations, Named, Number};

impl Design {
    /// `S016`, for each name that the scenario expects something of and the circuit does not have.
    pub(super) fn unknown_expectations(&self) -> Vec<Diagnostic> {
        let expect = &self.scenario().expect;
        let outputs: Vec<_> = self.outputs().map(|net| net.name.clone()).collect();
        let bits: Vec<_> = self.outputs().filter(|net| net.width == 1).map(|net| net.name.clone()).collect();
        // Signals inside of blocks are known only to the compiler, which most scenarios need not ask.
        let is_output = |net: &Named<Number>| outputs.contains(&net.name);
        let nets = match expect.outputs.iter().all(is_output) {
            true => outputs,
            false => self.all_signals().iter().map(Signal::name).chain(outputs).collect(),
        };
        let values = expect.outputs.iter().filter_map(|net| unknown(net, "net", &nets));
        values.chain(expect.pulses.iter().filter_map(|bit| unknown(bit, "one-bit output", &bits))).collect()
    }
}

fn unknown<T>(named: &Named<T>, what: &str, known: &[String]) -> Option<Diagnostic> {
    let name = &named.name;
    let diagnostic = Diagnostic::new("S016", format!("the scenario expects something of `{name}`: no such {what}"))
        .nearest(name, known.iter().map(String::as_str));
    let is_known = known.contains(name);
    (!is_known).then(|| named.span.into_iter().fold(diagnostic, |diagnostic, span| diagnostic.at(span, "here")))
}

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
