//! Whether the inputs of a run satisfy what its scenario says of them.

use super::Design;
use crate::base::word::decode;
use crate::scenario::Requirement;

/// A requirement of a scenario that inputs do not satisfy.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Broken {
    /// Which of the scenario's requirements, counted from 0.
    pub place: usize,
    /// The first tick in which it does not hold.
    pub tick: u64,
    /// The comparison with the numbers of that tick.
    pub numbers: Requirement<i128>,
}

impl Design {
    /// The requirements that do not hold all the time for inputs that begin with the words `initial` and change as the
    /// scenario says. Such a run is possible, but the circuit is not made for it.
    #[must_use]
    pub fn broken_requirements(&self, initial: &[u64]) -> Vec<Broken> {
        let mut broken: Vec<Broken> = Vec::new();
        if self.required().is_empty() {
            return broken;
        }
        let mut words = initial.to_vec();
        let ports: Vec<_> = self.inputs().map(|net| (net.width, net.signed)).collect();
        let changes = &self.stimulus().changes;
        let (mut tick, mut changed) = (0, 0);
        loop {
            for change in changes[changed..].iter().take_while(|change| change.tick <= tick) {
                words[change.input] = change.word;
                changed += 1;
            }
            let number = |input: &usize| decode(words[*input], ports[*input].0, ports[*input].1);
            for (place, requirement) in self.required().iter().enumerate() {
                if !requirement.holds(number) && broken.iter().all(|known| known.place != place) {
                    broken.push(Broken { place, tick, numbers: requirement.map(number) });
                }
            }
            match changes.get(changed) {
                Some(next) => tick = next.tick,
                None => return broken,
            }
        }
    }
}
