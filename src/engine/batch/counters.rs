//! Counters of rising edges in all lanes at once: plane `i` of a counter holds bit `i` of every lane's count.

/// Most 64-lane words of a plane.
pub(super) const MOST_WORDS: usize = 16;
/// Most bits of the count of one block, which has at most 128 ticks.
const BLOCK_BITS: usize = 8;

/// One counter a lane.
#[derive(Clone, Debug)]
pub(super) struct EdgeCounters {
    words: usize,
    /// The plane of the tick before.
    before: Vec<u64>,
    /// Only as many planes as the largest count has bits.
    planes: Vec<u64>,
}

impl EdgeCounters {
    pub(super) fn new(words: usize) -> Self {
        debug_assert!(words <= MOST_WORDS);
        Self { words, before: vec![0; words], planes: Vec::new() }
    }

    /// Puts the lanes of `mask` before their tick 0.
    pub(super) fn clear(&mut self, mask: &[u64]) {
        for plane in self.planes.chunks_exact_mut(self.words).chain([self.before.as_mut_slice()]) {
            plane.iter_mut().zip(mask).for_each(|(word, mask)| *word &= !mask);
        }
    }

    /// The count of a lane, with the bits of ticks that have not been added.
    pub(super) fn count(&self, lane: usize, block: impl Iterator<Item = u64>) -> u64 {
        let bit = |plane: &[u64]| plane[lane / 64] >> (lane % 64) & 1;
        let added: u64 = self.planes.chunks_exact(self.words).enumerate().map(|(i, plane)| bit(plane) << i).sum();
        let mut before = bit(&self.before);
        added + block.map(|now| now & !std::mem::replace(&mut before, now)).sum::<u64>()
    }

    /// Counts a block of ticks: `block` yields the plane of each.
    pub(super) fn add<'a>(&mut self, block: impl Iterator<Item = &'a [u64]>) {
        match self.words {
            4 => self.add_words::<4>(block),
            8 => self.add_words::<8>(block),
            _ => self.add_words::<MOST_WORDS>(block),
        }
    }

    /// First counts within the block, in registers; then adds that to the long counts.
    fn add_words<'a, const W: usize>(&mut self, block: impl Iterator<Item = &'a [u64]>) {
        let mut counts = [[0u64; W]; BLOCK_BITS];
        let mut before = [0; W];
        before.copy_from_slice(&self.before);
        for (tick, plane) in block.enumerate() {
            let bits = (usize::BITS - (tick + 1).leading_zeros()) as usize;
            let mut carry = [0; W];
            for ((carry, before), &now) in carry.iter_mut().zip(&mut before).zip(plane) {
                *carry = now & !std::mem::replace(before, now);
            }
            for count in &mut counts[..bits] {
                for i in 0..W {
                    (count[i], carry[i]) = (count[i] ^ carry[i], count[i] & carry[i]);
                }
            }
        }
        self.before.copy_from_slice(&before);
        let mut carry = [0u64; W];
        for bit in 0.. {
            let count = counts.get(bit).copied().unwrap_or([0; W]);
            if bit >= BLOCK_BITS && carry == [0; W] {
                break;
            }
            let start = bit * W;
            if self.planes.len() == start {
                if count == [0; W] && carry == [0; W] && counts[bit.min(BLOCK_BITS)..].iter().all(|c| *c == [0; W]) {
                    break;
                }
                self.planes.resize(start + W, 0);
            }
            for (i, plane) in self.planes[start..start + W].iter_mut().enumerate() {
                let (a, b, c) = (*plane, count[i], carry[i]);
                (*plane, carry[i]) = (a ^ b ^ c, a & b | c & (a ^ b));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_lane_counts_its_own_edges() {
        for words in [4, 8, 16] {
            let mut counters = EdgeCounters::new(words);
            let mut expected = vec![0u64; words * 64];
            let mut before = vec![0u64; words * 64];
            let mut random = 1u64;
            for block in [1, 7, 128, 64, 128, 3] {
                let mut next = || {
                    random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
                    random ^ random >> 29
                };
                let planes: Vec<u64> = (0..block * words).map(|_| next() | next()).collect();
                counters.add(planes.chunks_exact(words));
                for plane in planes.chunks_exact(words) {
                    for lane in 0..words * 64 {
                        let now = plane[lane / 64] >> (lane % 64) & 1;
                        expected[lane] += u64::from(now > before[lane]);
                        before[lane] = now;
                    }
                }
            }
            counters.clear(&[vec![2], vec![0; words - 1]].concat());
            (expected[1], before[1]) = (0, 0);
            // A tick that is high, one that is low and one that is high have not been added yet.
            let counts: Vec<_> = (0..words * 64).map(|lane| counters.count(lane, [1, 0, 1].into_iter())).collect();
            let more = before.iter().map(|before| 2 - before);
            assert_eq!(counts, expected.iter().zip(more).map(|(count, more)| count + more).collect::<Vec<_>>());
        }
    }
}
