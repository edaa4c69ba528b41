//! All segments 0 <= minor <= major <= N, in order.

/// How many segments there are up to a greater projection of `max`; `None` beyond 2^64.
#[must_use]
pub fn count(max: u64) -> Option<u64> {
    let (a, b) = (max.checked_add(1)?, max.checked_add(2)?);
    u64::try_from(u128::from(a) * u128::from(b) / 2).ok()
}

/// The segments up to a greater projection, the lesser one varying fastest.
#[derive(Clone, Debug)]
pub struct Segments {
    max: u64,
    major: u64,
    minor: u64,
}

impl Segments {
    /// Those up to `max` from number `skip` on.
    #[must_use]
    pub fn from(max: u64, skip: u64) -> Self {
        // The greatest major whose first segment, number major (major + 1) / 2, is not beyond `skip`.
        let (mut low, mut high) = (0, max + 1);
        while low < high {
            let middle = low + (high - low).div_ceil(2);
            if count(middle - 1).is_some_and(|before| before <= skip) {
                low = middle;
            } else {
                high = middle - 1;
            }
        }
        let before = if low == 0 { 0 } else { count(low - 1).unwrap_or(u64::MAX) };
        Self { max, major: low, minor: skip - before }
    }
}

impl Iterator for Segments {
    /// The greater and the lesser projection.
    type Item = (u64, u64);

    fn next(&mut self) -> Option<(u64, u64)> {
        if self.major > self.max {
            return None;
        }
        let this = (self.major, self.minor);
        if self.minor == self.major {
            (self.major, self.minor) = (self.major + 1, 0);
        } else {
            self.minor += 1;
        }
        Some(this)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn they_are_all_pairs_in_order_from_any_number_on() {
        let all: Vec<_> = (0..=9).flat_map(|major| (0..=major).map(move |minor| (major, minor))).collect();
        assert_eq!(count(9), Some(all.len() as u64));
        for skip in 0..=all.len() {
            assert_eq!(Segments::from(9, skip as u64).collect::<Vec<_>>(), all[skip..], "from {skip}");
        }
        assert_eq!((count(4095), count(0), count(u64::MAX)), (Some(8_390_656), Some(1), None));
    }
}
