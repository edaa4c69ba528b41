//! Between planes and lanes: a square of 64 x 64 bits turned about its diagonal.

/// The words of 64 lanes, from their planes, low bit first.
pub(super) fn to_lanes(planes: impl Iterator<Item = u64>) -> [u64; 64] {
    let mut square = [0; 64];
    square.iter_mut().zip(planes).for_each(|(row, plane)| *row = plane);
    transpose(&mut square);
    square
}

/// The 64 planes of the words of 64 lanes.
pub(super) fn from_lanes(mut lanes: [u64; 64]) -> [u64; 64] {
    transpose(&mut lanes);
    lanes
}

/// Swaps ever smaller squares off the diagonal (Warren, Hacker's Delight, 7-3).
fn transpose(square: &mut [u64; 64]) {
    let mut distance = 32;
    let mut mask = 0x0000_0000_FFFF_FFFFu64;
    while distance > 0 {
        for row in (0..64).filter(|row| row & distance == 0) {
            let change = (square[row] >> distance ^ square[row | distance]) & mask;
            square[row] ^= change << distance;
            square[row | distance] ^= change;
        }
        distance /= 2;
        mask ^= mask << distance;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bit_i_of_plane_j_is_bit_j_of_lane_i() {
        let planes: [u64; 64] = std::array::from_fn(|i| (i as u64 + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15));
        let lanes = to_lanes(planes.into_iter());
        for (lane, word) in lanes.iter().enumerate() {
            for (bit, plane) in planes.iter().enumerate() {
                assert_eq!(word >> bit & 1, plane >> lane & 1);
            }
        }
        assert_eq!(from_lanes(lanes), planes);
    }
}
