//! From a difference back through the drivers to the net that first went wrong.

use std::collections::{HashMap, HashSet};

use super::Waveform;

/// How many nets and ticks are looked at before the walk gives up; reached only where nearly nothing is traced.
const MOST_STEPS: usize = 100_000;

/// What drives each signal, by its name in the waveforms. Made from the netlist by the caller.
pub type Drivers = HashMap<String, Driven>;

/// A signal's drivers and where it comes from.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Driven {
    /// The signals that it is computed from.
    pub by: Vec<Driver>,
    /// The block and the figure, for a person: `accumulator_1, a summer of FIG. 1`.
    pub place: String,
}

/// A signal that another one is computed from.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Driver {
    /// Its name.
    pub net: String,
    /// Whether it works through state, so that its value of the tick before counts.
    pub delayed: bool,
}

/// A signal that is wrong though all that drives it is right.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Cause {
    /// Its name.
    pub net: String,
    /// The tick at which it is wrong.
    pub tick: u64,
    /// [`Driven::place`], or nothing when its drivers are not known.
    pub place: String,
    /// How many drivers are known, all of them right.
    pub inputs: usize,
    /// Expected value; `-` when there is none.
    pub expected: String,
    /// The other waveform's.
    pub got: String,
    /// From the signal that the walk began at to this one.
    pub path: Vec<(String, u64)>,
}

/// Walks back from signals that differ at `tick` to those that first went wrong: each differs while none of its
/// drivers does at the tick that counts. Signals that the waveforms do not hold are walked through. The earliest
/// cause comes first, one whose drivers are known before others.
///
/// ```
/// use stepwright::golden::{Driven, Driver, Drivers, causes, read};
///
/// let header = "$scope module top $end $var wire 1 a d $end $var wire 1 b q $end $upscope $end $enddefinitions $end\n";
/// let expected = read("golden", format!("{header}#0\n0a\n0b\n#4\n1a\n#5\n1b\n#9\n").as_bytes())?;
/// let got = read("run", format!("{header}#0\n0a\n0b\n#9\n").as_bytes())?;
/// let by = vec![Driver { net: "top.d".into(), delayed: true }];
/// let drivers = Drivers::from([("top.q".into(), Driven { by, place: "register_3, FIG. 1".into() })]);
/// let found = causes(&expected, &got, &drivers, &["top.q"], 5);
/// assert_eq!((found[0].net.as_str(), found[0].tick), ("top.d", 4));
/// # Ok::<(), stepwright::base::Report>(())
/// ```
#[must_use]
pub fn causes(expected: &Waveform, got: &Waveform, drivers: &Drivers, nets: &[&str], tick: u64) -> Vec<Cause> {
    let mut walk = Walk { expected, got, drivers, steps_left: MOST_STEPS };
    let begin = nets.iter().filter(|net| walk.differs(net, tick) == Some(true));
    let mut steps: Vec<Step<'_>> = begin.map(|&net| Step { at: (net, tick), from: None }).collect();
    let mut seen: HashSet<_> = steps.iter().map(|step| step.at).collect();
    let (mut causes, mut next) = (Vec::new(), 0);
    while next < steps.len() {
        let behind = walk.wrong_behind(steps[next].at);
        if behind.is_empty() {
            causes.push(walk.cause(&steps, next));
        }
        let unseen = behind.into_iter().filter(|at| seen.insert(*at));
        steps.extend(unseen.map(|at| Step { at, from: Some(next) }));
        next += 1;
    }
    causes.sort_by_key(|cause| (cause.tick, cause.inputs == 0));
    causes
}

/// A signal at a tick.
type At<'a> = (&'a str, u64);

/// A signal that differs, and the step that led to it.
struct Step<'a> {
    at: At<'a>,
    from: Option<usize>,
}

struct Walk<'a> {
    expected: &'a Waveform,
    got: &'a Waveform,
    drivers: &'a Drivers,
    steps_left: usize,
}

impl<'a> Walk<'a> {
    /// Whether a signal differs at a tick; `None` when a waveform does not hold it.
    fn differs(&self, net: &str, tick: u64) -> Option<bool> {
        Some(self.expected.track(net)?.at(tick) != self.got.track(net)?.at(tick))
    }

    /// The differing signals that drive this one, directly or through signals that the waveforms do not hold.
    fn wrong_behind(&mut self, at: At<'a>) -> Vec<At<'a>> {
        let (mut wrong, mut stack, mut seen) = (Vec::new(), vec![at], HashSet::from([at]));
        while let Some((net, tick)) = stack.pop() {
            let drivers = self.drivers;
            for driver in drivers.get(net).map_or(&[][..], |driven| &driven.by) {
                let Some(tick) = tick.checked_sub(u64::from(driver.delayed)) else { continue };
                let at = (driver.net.as_str(), tick);
                if self.steps_left == 0 || !seen.insert(at) {
                    continue;
                }
                self.steps_left -= 1;
                match self.differs(at.0, tick) {
                    Some(true) => wrong.push(at),
                    Some(false) => {}
                    None => stack.push(at),
                }
            }
        }
        wrong
    }

    fn cause(&self, steps: &[Step<'_>], found: usize) -> Cause {
        let (net, tick) = steps[found].at;
        let shown = |wave: &Waveform| {
            let value = wave.track(net).and_then(|track| track.at(tick));
            value.map_or_else(|| "-".to_owned(), |value| value.to_string())
        };
        let back = std::iter::successors(Some(found), |&step| steps[step].from);
        let mut path: Vec<_> = back.map(|step| (steps[step].at.0.to_owned(), steps[step].at.1)).collect();
        path.reverse();
        let driven = self.drivers.get(net);
        Cause {
            net: net.to_owned(),
            tick,
            place: driven.map_or_else(String::new, |driven| driven.place.clone()),
            inputs: driven.map_or(0, |driven| driven.by.len()),
            expected: shown(self.expected),
            got: shown(self.got),
            path,
        }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::golden::read;

    fn wave(nets: usize, ticks: &[u64]) -> Waveform {
        let mut text = String::from("$scope module t $end\n");
        for net in 0..nets {
            text += &format!("$var wire 1 n{net} n{net} $end\n");
        }
        text += "$upscope $end $enddefinitions $end\n";
        for (tick, words) in ticks.iter().enumerate() {
            text += &format!("#{tick}\n");
            (0..nets).for_each(|net| text += &format!("{}n{net}\n", words >> net & 1));
        }
        read("test", format!("{text}#{}\n", ticks.len()).as_bytes()).unwrap()
    }

    fn driver(net: usize, delayed: bool) -> Driver {
        Driver { net: format!("t.n{net}"), delayed }
    }

    fn drivers(edges: &[(usize, &[Driver])]) -> Drivers {
        let driven = |by: &[Driver], net: usize| Driven { by: by.to_vec(), place: format!("block of n{net}") };
        edges.iter().map(|(net, by)| (format!("t.n{net}"), driven(by, *net))).collect()
    }

    proptest! {
        /// A chain n0 -> register -> n1 -> register -> ... of which one register flips its output at one tick: the
        /// walk from the last net finds that register and tick, whatever else travels down the chain.
        #[test]
        fn a_flip_in_a_chain_of_registers_is_traced_to_its_register(
            stimulus in prop::collection::vec(any::<bool>(), 30), flipped in 0usize..6, at in 0usize..20,
        ) {
            let run = |flip: bool| {
                let mut nets = [0u64; 6];
                let mut ticks = Vec::new();
                for (tick, input) in stimulus.iter().enumerate() {
                    nets = std::array::from_fn(|i| if i == 0 { u64::from(*input) } else { nets[i - 1] });
                    if flip && tick == at {
                        nets[flipped] ^= 1;
                    }
                    ticks.push(nets.iter().enumerate().map(|(i, bit)| bit << i).sum());
                }
                wave(6, &ticks)
            };
            let edges: Vec<_> = (1..6).map(|net| (net, [driver(net - 1, true)])).collect();
            let edges: Vec<_> = edges.iter().map(|(net, by)| (*net, &by[..])).collect();
            let seen_at = at + (5 - flipped);
            let found = causes(&run(false), &run(true), &drivers(&edges), &["t.n5"], seen_at as u64);
            prop_assert_eq!(found.len(), 1);
            prop_assert_eq!((found[0].net.clone(), found[0].tick), (format!("t.n{flipped}"), at as u64));
            prop_assert_eq!(found[0].path.len(), 6 - flipped);
        }
    }

    #[test]
    fn a_net_that_is_not_traced_is_walked_through() {
        // n1 is known to the drivers under a name that no waveform has.
        let unseen = Driver { net: "t.hidden".into(), delayed: false };
        let mut edges = drivers(&[(2, &[unseen])]);
        edges.insert("t.hidden".into(), Driven { by: vec![driver(0, true)], place: String::new() });
        let found = causes(&wave(3, &[0, 0, 0]), &wave(3, &[0, 1, 4]), &edges, &["t.n2"], 2);
        assert_eq!((found[0].net.as_str(), found[0].tick), ("t.n0", 1));
    }

    #[test]
    fn the_net_whose_drivers_are_right_is_the_cause_and_tells_its_block() {
        let edges = drivers(&[(1, &[driver(0, false)]), (2, &[driver(1, false), driver(0, true)])]);
        let found = causes(&wave(3, &[0, 1]), &wave(3, &[0, 7]), &edges, &["t.n2"], 1);
        assert_eq!(found.len(), 1);
        assert_eq!(
            found[0].to_string(),
            "t.n1 first went wrong, at tick 1: expected 0, got 1 while its drivers are right (block of n1)\n\
             \x20 t.n2 (tick 1) <- t.n1 (tick 1)\n"
        );
    }

    #[test]
    fn state_that_feeds_itself_is_no_endless_walk() {
        let hidden = Driven { by: vec![Driver { net: "t.hidden".into(), delayed: true }], place: String::new() };
        let mut edges = Drivers::from([("t.hidden".to_owned(), hidden)]);
        edges.insert(
            "t.n0".into(),
            Driven { by: vec![Driver { net: "t.hidden".into(), delayed: true }], place: String::new() },
        );
        let late = (1 << 20) - 1;
        let at = |word: u64| {
            let text = format!(
                "$scope module t $end $var wire 1 a n0 $end $upscope $end $enddefinitions $end\n#0\n{word}a\n#{late}\n"
            );
            read("test", text.as_bytes()).unwrap()
        };
        assert_eq!(causes(&at(0), &at(1), &edges, &["t.n0"], late).len(), 1);
    }
}
