//! Parts of a run that are known only while it goes on: from a trigger on, or the last ticks.

use std::collections::VecDeque;

use super::{Frame, Observer};
use crate::base::{Diagnostic, Report, Signal, ValueId};

/// An observer that begins to look in the first tick in which one of some nets is high.
pub struct When<O> {
    observer: O,
    nets: Vec<String>,
    /// How many values are the observer's own; those of the nets follow.
    own: usize,
    has_begun: bool,
}

impl<O: Observer> When<O> {
    /// `nets` are dotted names below the top module.
    #[must_use]
    pub fn new(nets: Vec<String>, observer: O) -> Self {
        Self { observer, nets, own: 0, has_begun: false }
    }
}

impl<O: Observer> Observer for When<O> {
    fn wants(&self, name: &str) -> bool {
        self.observer.wants(name) || self.nets.iter().any(|net| net == name)
    }

    /// # Errors
    /// Those of the observer, and `S012` for each of the nets that is no signal.
    fn begin(&mut self, signals: &[Signal]) -> Result<Vec<ValueId>, Report> {
        let (mut triggers, mut wrong) = (Vec::new(), Vec::new());
        for net in &self.nets {
            match signals.iter().find(|signal| signal.name() == *net) {
                Some(signal) => triggers.push(signal.value),
                None => {
                    let names: Vec<_> = signals.iter().map(Signal::name).collect();
                    let missing = Diagnostic::new("S012", format!("there is no net `{net}`"));
                    wrong.push(missing.nearest(net, names.iter().map(String::as_str)));
                }
            }
        }
        if !wrong.is_empty() {
            return Err(Report::new(Default::default(), wrong));
        }
        let mut values = self.observer.begin(signals)?;
        self.own = values.len();
        values.extend(triggers);
        Ok(values)
    }

    fn tick(&mut self, frame: Frame<'_>) -> Result<(), Report> {
        let (own, triggers) = frame.words.split_at(self.own);
        let is_first = !self.has_begun && triggers.iter().any(|&word| word != 0);
        self.has_begun |= is_first;
        if !self.has_begun {
            return Ok(());
        }
        let before = frame.before.filter(|_| !is_first).map(|before| &before[..self.own]);
        self.observer.tick(Frame { tick: frame.tick, words: own, before })
    }

    /// # Errors
    /// Those of the observer, and `W009` when none of the nets was high at any tick; what the observer makes is not
    /// finished then.
    fn end(&mut self) -> Result<(), Report> {
        if !self.has_begun {
            let message = format!("{} was not high in any tick: there is nothing to trace", self.nets.join(", "));
            return Err(Diagnostic::new("W009", message).help("name another net, or run for longer").into());
        }
        self.observer.end()
    }
}

/// How many words are kept of the last ticks: 256 MiB.
const MOST_WORDS: u64 = 32 << 20;

/// An observer that is shown the last ticks of a run when it is over.
pub struct Last<O> {
    observer: O,
    ticks: u64,
    kept: VecDeque<(u64, Box<[u64]>)>,
}

impl<O: Observer> Last<O> {
    /// `ticks` is how many, at least 1.
    #[must_use]
    pub fn new(ticks: u64, observer: O) -> Self {
        Self { observer, ticks, kept: VecDeque::new() }
    }
}

impl<O: Observer> Observer for Last<O> {
    fn wants(&self, name: &str) -> bool {
        self.observer.wants(name)
    }

    /// # Errors
    /// Those of the observer, and `W008` when the ticks would take more than 256 MiB.
    fn begin(&mut self, signals: &[Signal]) -> Result<Vec<ValueId>, Report> {
        let values = self.observer.begin(signals)?;
        let most = MOST_WORDS / (values.len() as u64).max(1);
        if self.ticks > most {
            let message = format!("the last {} ticks of {} values do not fit into 256 MiB", self.ticks, values.len());
            return Err(Diagnostic::new("W008", message).help(format!("at most {most}; or trace less")).into());
        }
        Ok(values)
    }

    fn tick(&mut self, frame: Frame<'_>) -> Result<(), Report> {
        let mut words = if self.kept.len() as u64 == self.ticks { self.kept.pop_front() } else { None };
        match &mut words {
            Some((_, words)) => words.copy_from_slice(frame.words),
            None => words = Some((0, frame.words.into())),
        }
        self.kept.extend(words.map(|(_, words)| (frame.tick, words)));
        Ok(())
    }

    fn end(&mut self) -> Result<(), Report> {
        let mut before = None;
        for (tick, words) in std::mem::take(&mut self.kept) {
            self.observer.tick(Frame { tick, words: &words, before: before.as_deref() })?;
            before = Some(words);
        }
        self.observer.end()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Writes down what it is shown.
    #[derive(Default)]
    struct Notes(Vec<(u64, u64, Option<u64>)>);

    impl Observer for Notes {
        fn wants(&self, name: &str) -> bool {
            name == "n"
        }

        fn begin(&mut self, signals: &[Signal]) -> Result<Vec<ValueId>, Report> {
            Ok(signals.iter().filter(|signal| self.wants(&signal.name())).map(|signal| signal.value).collect())
        }

        fn tick(&mut self, frame: Frame<'_>) -> Result<(), Report> {
            self.0.push((frame.tick, frame.words[0], frame.before.map(|before| before[0])));
            Ok(())
        }

        fn end(&mut self) -> Result<(), Report> {
            Ok(())
        }
    }

    fn signal(name: &str, value: usize) -> Signal {
        let path = vec!["t".to_owned(), name.to_owned()];
        Signal { path, width: 8, signed: false, fraction: None, value: ValueId::new(value) }
    }

    /// Shows the ticks 0 to 9, in which `n` is ten times the tick and `go` is high in 4 and 7.
    fn show(observer: &mut impl Observer) {
        let signals = [signal("n", 0), signal("go", 1)];
        let values = observer.begin(&signals).unwrap();
        let words = |tick: u64| {
            let word = |value: &ValueId| if value.index() == 0 { 10 * tick } else { u64::from([4, 7].contains(&tick)) };
            values.iter().map(word).collect::<Vec<_>>()
        };
        for tick in 0..10 {
            let before = (tick > 0).then(|| words(tick - 1));
            observer.tick(Frame { tick, words: &words(tick), before: before.as_deref() }).unwrap();
        }
        observer.end().unwrap();
    }

    #[test]
    fn a_trigger_opens_at_its_first_high_tick_and_stays_open() {
        let mut notes = Notes::default();
        show(&mut When::new(vec!["go".to_owned()], &mut notes));
        assert_eq!(notes.0.len(), 6);
        assert_eq!(notes.0[..2], [(4, 40, None), (5, 50, Some(40))]);
    }

    #[test]
    fn the_last_ticks_are_shown_as_a_run_of_their_own() {
        let mut notes = Notes::default();
        show(&mut Last::new(3, &mut notes));
        assert_eq!(notes.0, [(7, 70, None), (8, 80, Some(70)), (9, 90, Some(80))]);
        let mut all = Notes::default();
        show(&mut Last::new(50, &mut all));
        assert_eq!(all.0.len(), 10);
    }

    #[test]
    fn more_last_ticks_than_memory_is_given_are_refused_with_how_many_would_do() {
        let report = Last::new(MOST_WORDS + 1, Notes::default()).begin(&[signal("n", 0)]).unwrap_err();
        assert_eq!(report.diagnostics[0].code, "W008");
        assert!(report.to_string().contains("at most 33554432"), "{report}");
    }

    #[test]
    fn a_trigger_that_never_comes_is_told() {
        let mut never = When::new(vec!["go".to_owned()], Notes::default());
        let values = never.begin(&[signal("n", 0), signal("go", 1)]).unwrap();
        never.tick(Frame { tick: 0, words: &vec![0; values.len()], before: None }).unwrap();
        assert_eq!(never.end().unwrap_err().diagnostics[0].code, "W009");
    }

    #[test]
    fn a_trigger_that_is_no_net_is_refused_with_the_nearest_name() {
        let report = When::new(vec!["busi".to_owned()], Notes::default()).begin(&[signal("busy", 0)]).unwrap_err();
        assert!(report.to_string().contains("did you mean `busy`?"), "{report}");
    }
}
