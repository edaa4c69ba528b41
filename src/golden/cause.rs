//! What went wrong first: signals that differ while all that drives them is right.

use std::collections::{HashMap, HashSet};

use super::compare::shown;
use super::cone::{Cone, Cones};
use super::merge::Merged;
use super::pairs::{Pair, Pairs};
use super::{Divergence, Waveform};
use crate::base::Report;

/// How many causes are told, each of which means reading both files once more.
const MOST_CAUSES: usize = 8;

/// A signal that is wrong though all that drives it is right, or was right so far where it works through state.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Cause {
    /// Its name, where the netlist makes it.
    pub net: String,
    /// The tick at which it is wrong first.
    pub tick: u64,
    /// [`super::Driven::place`], or nothing when its drivers are not known.
    pub place: String,
    /// How many of its nearest drivers were compared, all of them right.
    pub inputs: usize,
    /// How many nets between it and these were not compared: the fault may be in one of them.
    pub untraced: usize,
    /// The signals that differ after it because of it, the earliest first.
    pub follows: Vec<String>,
    /// The ticks around, of the signal and then of its nearest drivers.
    pub around: Divergence,
}

/// The causes of all differences; `look` reads both waveforms around a tick.
pub(super) fn causes(
    pairs: &Pairs,
    merged: &Merged,
    mut cones: Cones<'_>,
    look: impl Fn(u64) -> Result<[Waveform; 2], Report>,
) -> Result<Vec<Cause>, Report> {
    let mut differing: Vec<(u64, usize)> =
        merged.tallies.iter().enumerate().filter_map(|(class, tally)| Some((tally.first?, class))).collect();
    differing.sort_unstable();
    // What goes wrong in one block, inside it and at its outputs, is one cause.
    let mut root_of: HashMap<String, usize> = HashMap::new();
    let mut found: Vec<(u64, usize, Vec<usize>)> = Vec::new();
    for &(tick, class) in &differing {
        let first = root(merged, class);
        // What a difference comes from differs no later.
        let tick = merged.tallies[first].first.unwrap_or(tick);
        let cone = &cones.of(first)[merged.behind[first].cone];
        let place = cone.made.as_ref().map_or("", |(_, place)| place.as_str());
        let key = if place.is_empty() { first.to_string() } else { place.to_owned() };
        let at = *root_of.entry(key).or_insert_with(|| {
            found.push((tick, first, Vec::new()));
            found.len() - 1
        });
        let (_, cause, follows) = &mut found[at];
        follows.extend((class != *cause).then_some(class));
    }
    found.sort_by_key(|(tick, class, _)| (*tick, cones.of(*class)[merged.behind[*class].cone].by.is_empty()));
    let name = |class: usize| pairs.all.iter().find(|pair| pair.class == class);
    let cause = |(tick, class, follows): (u64, usize, Vec<usize>)| {
        let [expected, got] = look(tick)?;
        let Cone { by, made, untraced } = cones.of(class)[merged.behind[class].cone].clone();
        let mut known = HashSet::from([class]);
        let behind = by.iter().map(|(class, _)| *class).filter(|class| known.insert(*class));
        let behind: Vec<&Pair> = std::iter::once(class).chain(behind).filter_map(name).collect();
        let around = shown(pairs, behind.iter().copied(), tick, &merged.span, [&expected, &got]);
        let (net, place) = made.unwrap_or_else(|| (around.nets[0].name.clone(), String::new()));
        let follows = follows.into_iter().filter_map(name).map(|pair| pair.name.clone()).collect();
        Ok(Cause { net, tick, place, inputs: around.nets.len() - 1, untraced, follows, around })
    };
    found.into_iter().take(MOST_CAUSES).map(cause).collect()
}

/// The class that a difference comes from, step by step to what was wrong before it or with it, the earliest first.
fn root(merged: &Merged, class: usize) -> usize {
    let (mut class, mut seen) = (class, HashSet::from([class]));
    loop {
        let wrong =
            merged.behind[class].wrong.iter().filter_map(|&behind| Some((merged.tallies[behind].first?, behind)));
        match wrong.min() {
            Some((_, behind)) if seen.insert(behind) => class = behind,
            Some(_) => {
                return seen.into_iter().min_by_key(|&class| (merged.tallies[class].first, class)).unwrap_or(class);
            }
            None => return class,
        }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::golden::{Driven, Driver, Drivers, How, Input, explain};

    fn wave(nets: usize, ticks: &[u64]) -> Input {
        let mut text = String::from("$scope module t $end\n");
        for net in 0..nets {
            text += &format!("$var wire 1 n{net} n{net} $end\n");
        }
        text += "$upscope $end $enddefinitions $end\n";
        for (tick, words) in ticks.iter().enumerate() {
            text += &format!("#{tick}\n");
            (0..nets).for_each(|net| text += &format!("{}n{net}\n", words >> net & 1));
        }
        Input::bytes("test", format!("{text}#{}\n", ticks.len()).into_bytes())
    }

    fn found(expected: &Input, got: &Input, drivers: &Drivers) -> Vec<Cause> {
        explain(expected, got, &How::default(), drivers).unwrap_or_else(|report| panic!("{report}")).1
    }

    fn driver(net: usize, delayed: bool) -> Driver {
        Driver { net: format!("t.n{net}"), delayed }
    }

    fn drivers(edges: &[(usize, &[Driver])]) -> Drivers {
        let driven =
            |by: &[Driver], net: usize| Driven { by: by.to_vec(), place: format!("block of n{net}"), is_net: true };
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
            let found = found(&run(false), &run(true), &drivers(&edges));
            prop_assert_eq!(found.len(), 1);
            prop_assert_eq!((found[0].net.clone(), found[0].tick), (format!("t.n{flipped}"), at as u64));
            let behind: Vec<_> = (flipped + 1..6).map(|net| format!("t.n{net}")).collect();
            prop_assert_eq!(&found[0].follows, &behind);
        }
    }

    #[test]
    fn a_net_that_is_not_traced_is_walked_through() {
        let mut edges = drivers(&[(2, &[hidden(false)])]);
        edges.insert("t.hidden".into(), Driven { by: vec![driver(0, true)], place: String::new(), is_net: true });
        let found = found(&wave(3, &[0, 0, 0]), &wave(3, &[0, 1, 4]), &edges);
        assert_eq!((found[0].net.as_str(), found[0].tick, found.len()), ("t.n0", 1, 1));
    }

    fn hidden(delayed: bool) -> Driver {
        Driver { net: "t.hidden".into(), delayed }
    }

    #[test]
    fn a_net_behind_others_that_are_not_traced_is_not_said_to_be_the_faulty_one() {
        let mut edges = drivers(&[(1, &[hidden(false)])]);
        edges.insert("t.hidden".into(), Driven { by: vec![driver(0, false)], place: String::new(), is_net: true });
        let found = found(&wave(2, &[0, 0]), &wave(2, &[0, 2]), &edges);
        assert_eq!((found[0].net.as_str(), found[0].inputs, found[0].untraced), ("t.n1", 1, 1));
        let text = found[0].to_string();
        assert!(text.contains("its nearest traced drivers are right"), "{text}");
        assert!(text.contains("nets between that are not traced, of which one may be wrong: 1"), "{text}");
    }

    #[test]
    fn the_net_whose_drivers_are_right_is_the_cause_and_tells_its_block() {
        let edges = drivers(&[(0, &[]), (1, &[driver(0, false)]), (2, &[driver(1, false), driver(0, true)])]);
        // n0 is right in both ticks; n1, and n2 behind it, are wrong in the second one.
        let found = found(&wave(3, &[0, 1]), &wave(3, &[0, 7]), &edges);
        assert_eq!(found.len(), 1);
        let expected = "t.n1 first went wrong, at tick 1: expected 0, got 1 while its drivers are right (block of n1)\n\
            \x20 t.n2 follows\n";
        assert!(found[0].to_string().starts_with(expected), "{}", found[0]);
    }

    #[test]
    fn what_state_has_kept_since_a_driver_was_wrong_comes_from_that_driver() {
        // n0 is wrong in tick 1 alone; the memory n1 shows it in tick 4.
        let edges = drivers(&[(1, &[driver(0, true)])]);
        let found = found(&wave(2, &[0; 6]), &wave(2, &[0, 1, 0, 0, 2, 2]), &edges);
        assert_eq!((found.len(), found[0].net.as_str(), found[0].tick), (1, "t.n0", 1));
    }

    #[test]
    fn two_faults_are_two_causes_each_with_what_follows_from_it() {
        let edges = drivers(&[(1, &[driver(0, false)]), (3, &[driver(2, false)])]);
        let found = found(&wave(4, &[0; 4]), &wave(4, &[0, 0b0011, 0, 0b1100]), &edges);
        let told: Vec<_> =
            found.iter().map(|cause| (cause.net.as_str(), cause.tick, cause.follows.join(" "))).collect();
        assert_eq!(told, [("t.n0", 1, "t.n1".to_owned()), ("t.n2", 3, "t.n3".to_owned())]);
    }

    #[test]
    fn nets_that_drive_each_other_are_no_endless_walk() {
        let edges = drivers(&[(0, &[driver(1, false)]), (1, &[driver(0, false)])]);
        let both = found(&wave(2, &[0]), &wave(2, &[3]), &edges);
        assert_eq!(both.len(), 1);
        let own = drivers(&[(0, &[driver(0, true)])]);
        assert_eq!(found(&wave(1, &[0]), &wave(1, &[1]), &own).len(), 1);
    }

    #[test]
    fn a_netlist_is_found_below_the_scopes_of_a_bench() {
        let text = |tick| {
            format!(
                "$scope module bench $end $scope module dut $end $var wire 1 a n0 $end\n\
            $var wire 1 b n1 $end $upscope $end $upscope $end $enddefinitions $end\n#0\n0a\n0b\n#{tick}\n1a\n1b\n#9\n"
            )
        };
        let [a, b] = [4, 5].map(|tick| Input::bytes("bench", text(tick).into_bytes()));
        let found = found(&a, &b, &drivers(&[(0, &[]), (1, &[driver(0, false)])]));
        assert_eq!(
            (found.len(), found[0].net.as_str(), found[0].follows.join(" ")),
            (1, "t.n0", "bench.dut.n1".into())
        );
    }
}
