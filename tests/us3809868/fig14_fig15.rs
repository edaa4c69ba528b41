//! FIG. 14, scaling, and FIG. 15, offset, in whole numbers.

use super::machine::{Machine, Random};
use super::transform::Transformer;

/// The word of factor 1.
const ONE: i64 = 1 << 12;

struct Scaling(Transformer);

impl Scaling {
    fn shipped() -> Self {
        Self(Transformer::shipped("fig14_scaling", &["j_out", "k_out", "l_out", "m_out"], &[]))
    }

    fn scale(&mut self, factor: i64, [j, k, l, m]: [i64; 4]) -> Option<Vec<i64>> {
        self.0.run(&[("factor_471", factor), ("j", j), ("k", k), ("l", l), ("m", m)])
    }
}

/// The nearest whole number to `factor / 2^12 * word`, halves away from zero.
fn scaled(factor: i64, word: i64) -> i64 {
    let product = factor * word;
    product.signum() * ((product.abs() + ONE / 2) / ONE)
}

#[test]
fn ten_thousand_scalings_are_the_nearest_counts_or_an_error() {
    let mut scaling = Scaling::shipped();
    let mut random = Random(14);
    let mut refused = 0;
    for _ in 0..10_000 {
        let (factor, words) = (random.within(32767), [0; 4].map(|_| random.within(12_000)));
        let expected = words.map(|word| scaled(factor, word));
        let expected = expected.iter().all(|word| (-32768..=32767).contains(word)).then_some(expected.to_vec());
        refused += u32::from(expected.is_none());
        assert_eq!(scaling.scale(factor, words), expected, "{words:?} times {factor} / 4096");
    }
    assert!((1000..9000).contains(&refused), "{refused} of 10,000 leave their words: both sides are tried");
}

#[test]
fn factor_one_is_exact_minus_one_mirrors_and_a_half_goes_away_from_zero() {
    let mut scaling = Scaling::shipped();
    let words = [-32767, 32767, 1, -3];
    assert_eq!(scaling.scale(ONE, words), Some(words.to_vec()));
    assert_eq!(scaling.scale(ONE, [-32768, 0, 0, 0]), Some(vec![-32768, 0, 0, 0]));
    assert_eq!(scaling.scale(-ONE, words), Some(vec![32767, -32767, -1, 3]));
    assert_eq!(scaling.scale(ONE / 2, words), Some(vec![-16384, 16384, 1, -2]));
    assert_eq!(scaling.scale(0, words), Some(vec![0; 4]));
    assert_eq!(scaling.scale(-ONE, [-32768, 0, 0, 0]), None, "32768 is beyond 16 bits");
    assert_eq!(scaling.scale(ONE + 1, [0, 0, 0, 32767]), None, "32775 is beyond 16 bits");
}

#[test]
fn an_offset_adds_to_the_initial_point_or_is_an_error() {
    let mut offset = Machine::shipped("us3809868/fig15_offset", &[]);
    let mut random = Random(15);
    let ends = [(32767, 1), (-32768, -1), (32767, -32768), (-32768, 0), (0, 32767)];
    let pairs = (0..1000).map(|_| (random.within(32767), random.within(32767)));
    let pairs: Vec<_> = ends.into_iter().chain(pairs).collect();
    for (&(x0, offset_x), &(y0, offset_y)) in pairs.iter().zip(pairs.iter().rev()) {
        offset.set(&[("x0", x0), ("y0", y0), ("offset_x_488", offset_x), ("offset_y_490", offset_y)]);
        offset.tick();
        let sums = [x0 + offset_x, y0 + offset_y];
        let fit = sums.iter().all(|sum| (-32768..=32767).contains(sum));
        let got = ["x0_out", "y0_out"].map(|output| offset.get_signed(output));
        assert_eq!((got, offset.get("error") == 0), (if fit { sums } else { [0, 0] }, fit), "{sums:?}");
    }
}
