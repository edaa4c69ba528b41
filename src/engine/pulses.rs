//! Pulses of one-bit outputs: a pulse is a level with a rising and a trailing edge, so it is rising edges that count.

/// What an output did from tick 0 to the present one.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Default, Debug)]
pub struct Pulses {
    /// Rising edges; an output that is high in tick 0 has one there.
    pub rising: u64,
    /// Ticks in which it was high.
    pub high: u64,
}

/// Counts the pulses of some bits, tick by tick.
#[derive(Clone, Debug)]
pub(super) struct PulseMeter {
    counts: Vec<Pulses>,
    before: Vec<bool>,
}

impl PulseMeter {
    /// A meter for so many bits, before tick 0.
    pub fn new(bits: usize) -> Self {
        Self { counts: vec![Pulses::default(); bits], before: vec![false; bits] }
    }

    /// Takes the bits of the tick that ends; `is_high` tells each.
    pub fn leave(&mut self, is_high: impl Fn(usize) -> bool) {
        for (i, (count, before)) in self.counts.iter_mut().zip(&mut self.before).enumerate() {
            let now = is_high(i);
            count.high += u64::from(now);
            count.rising += u64::from(now && !*before);
            *before = now;
        }
    }

    /// The counts with the present tick, which has not ended yet.
    pub fn counts(&self, is_high: impl Fn(usize) -> bool) -> Vec<Pulses> {
        let mut with_this_tick = self.clone();
        with_this_tick.leave(is_high);
        with_this_tick.counts
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_edge_counts_once_and_a_line_that_begins_high_has_one() {
        let mut meter = PulseMeter::new(3);
        let lines = ["1101", "0110", "0000"];
        for tick in 0..3 {
            meter.leave(|line| lines[line].as_bytes()[tick] == b'1');
        }
        let counts = meter.counts(|line| lines[line].as_bytes()[3] == b'1');
        let expected = [(2, 3), (1, 2), (0, 0)].map(|(rising, high)| Pulses { rising, high });
        assert_eq!(counts, expected);
    }
}
