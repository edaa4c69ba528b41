//! Round numbers along an axis.

/// The distance between marks on an axis: 1, 2 or 5 times a power of ten, so that at most `most` marks lie in `span`.
pub(super) fn step(span: f64, most: usize) -> f64 {
    let least = span / most as f64;
    let power = 10f64.powf(least.log10().floor());
    let factor = [1.0, 2.0, 5.0, 10.0].into_iter().find(|factor| factor * power >= least * (1.0 - 1e-9));
    factor.unwrap_or(10.0) * power
}

/// The marks in a range, with their labels.
pub(super) fn marks(from: f64, to: f64, step: f64) -> impl Iterator<Item = (f64, String)> {
    let decimals = (-step.log10().floor()).max(0.0) as usize;
    let marks = (from / step).ceil() as i64..=(to / step).floor() as i64;
    // A true minus, which is as wide as a digit.
    marks
        .map(move |mark| mark as f64 * step)
        .map(move |at| (at, format!("{:.decimals$}", at + 0.0).replace('-', "\u{2212}")))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn marks_stand_at_round_numbers_and_are_not_many() {
        for (span, most, expected) in
            [(10.0, 10, 1.0), (11.0, 10, 2.0), (4000.0, 8, 500.0), (0.3, 4, 0.1), (1e-3, 2, 5e-4)]
        {
            assert!((step(span, most) / expected - 1.0).abs() < 1e-9, "{span} {most}: {}", step(span, most));
        }
        let labels: Vec<_> = marks(-0.25, 0.21, 0.1).map(|(_, label)| label).collect();
        assert_eq!(labels, ["\u{2212}0.2", "\u{2212}0.1", "0.0", "0.1", "0.2"]);
    }
}
