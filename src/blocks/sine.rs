//! The sine of a part of a quarter turn in whole numbers, so that every machine builds the same tables.

const FRACTION: u32 = 62;
/// pi in units of 2^-62.
const PI: i128 = 14_488_038_916_154_245_684;

/// `2^bits sin(i pi / 2 entries)`, rounded, for `i` from 0 to `entries` and up to 24 `bits`. The series is exact to
/// about 2^-59; the tests of the tables show that none in use comes near a tie, where that could decide.
pub(super) fn rounded_sine(i: u64, entries: u64, bits: u32) -> u64 {
    let angle = PI * i128::from(i) / (2 * i128::from(entries));
    let square = (angle * angle) >> FRACTION;
    let (mut sine, mut term) = (0, angle);
    for k in 1.. {
        if term == 0 {
            break;
        }
        sine += term;
        term = -((term * square) >> FRACTION) / (2 * k * (2 * k + 1));
    }
    let half = 1_i128 << (FRACTION - 1);
    (((sine << bits) + half) >> FRACTION) as u64
}

#[cfg(test)]
mod tests {
    use super::rounded_sine;

    #[test]
    fn the_ends_are_exact_and_no_sine_of_the_finest_table_is_off() {
        assert_eq!((rounded_sine(0, 1024, 24), rounded_sine(1024, 1024, 24)), (0, 1 << 24));
        for i in 0..1024 {
            let real = f64::from(1 << 24) * (f64::from(i) * std::f64::consts::FRAC_PI_2 / 1024.0).sin();
            assert!((rounded_sine(i as u64, 1024, 24) as f64 - real).abs() < 0.5 + 1e-6, "{i}");
        }
    }
}
