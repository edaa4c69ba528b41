//! The pace of a run that may be broken off: how many ticks to go before looking up.

use std::time::{Duration, Instant};

/// How long a run may go without looking up, about.
const PATIENCE: Duration = Duration::from_millis(50);
/// Ticks before the first look.
const FIRST: u64 = 1 << 4;

/// Doubles the number of ticks until they take as long as they may.
#[derive(Debug)]
pub(super) struct Pace {
    ticks: u64,
    since: Option<Instant>,
}

impl Default for Pace {
    fn default() -> Self {
        Self { ticks: FIRST, since: None }
    }
}

impl Pace {
    /// How many ticks to go now.
    pub fn next(&mut self) -> u64 {
        let now = Instant::now();
        let taken = self.since.replace(now).map(|since| now - since);
        match taken {
            Some(taken) if taken < PATIENCE / 2 => self.ticks = self.ticks.saturating_mul(2),
            Some(taken) if taken > PATIENCE => self.ticks = (self.ticks / 2).max(1),
            _ => {}
        }
        self.ticks
    }
}
