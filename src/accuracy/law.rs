//! The law of FIG. 5: the deviation that is claimed of a segment, over its angle.

use super::Frame;
use crate::scenario::Law;

impl Law {
    /// The deviation at an angle in radians, in whole steps.
    #[must_use]
    pub fn at(self, angle: f64) -> f64 {
        self.sin * angle.sin() + self.cos * angle.cos()
    }

    /// Whether a frame keeps to it. With sin a = minor / length and cos a = major / length the length drops out; what is left
    /// are whole numbers times the factors, so that nothing is rounded where those are eighths.
    #[must_use]
    pub fn allows(self, frame: &Frame) -> bool {
        frame.greatest as f64 <= 4.0 * (self.sin * frame.minor as f64 + self.cos * frame.major as f64)
    }
}

/// What is claimed of an interpolator.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Claim {
    /// How far its nodes may be from the segment.
    pub law: Law,
    /// The same as it is printed.
    pub printed: Option<Printed>,
    /// How far off its end may be along either axis, in whole steps.
    pub end: f64,
}

/// A law as it is printed, rounded: `amplitude` sin(`degrees` + a).
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Printed {
    /// In whole steps.
    pub amplitude: f64,
    /// What is added to the angle.
    pub degrees: f64,
}

impl Printed {
    /// The deviation at an angle in radians, in whole steps.
    #[must_use]
    pub fn at(self, angle: f64) -> f64 {
        self.amplitude * (self.degrees.to_radians() + angle).sin()
    }

    /// By how much at most the printed law is below `law` between 0 and 45 degrees, looked at every hundredth of a degree.
    #[must_use]
    pub fn falls_short_of(self, law: Law) -> f64 {
        let angles = (0..=4500).map(|hundredths| (f64::from(hundredths) / 100.0).to_radians());
        angles.map(|angle| law.at(angle) - self.at(angle)).fold(0.0, f64::max)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const DEVICE: Law = Law { sin: 0.125, cos: 0.375 };

    #[test]
    fn the_devices_law_is_the_printed_one_but_for_its_rounding() {
        // Amplitude sqrt(0.125^2 + 0.375^2) = 0.395285, angle atan 3 = 71 degrees 33.9 minutes.
        let printed = Printed { amplitude: 0.3953, degrees: 71.0 + 35.0 / 60.0 };
        for degrees in 0..=45 {
            let angle = f64::from(degrees).to_radians();
            let exact = 0.156_25_f64.sqrt() * (3_f64.atan() + angle).sin();
            assert!((DEVICE.at(angle) - exact).abs() < 1e-12);
            assert!((printed.at(angle) - exact).abs() < 1e-4);
        }
        let short = printed.falls_short_of(DEVICE);
        assert!((0.000_03..0.000_06).contains(&short), "{short}");
    }

    #[test]
    fn a_frame_on_the_bound_is_allowed_and_one_quarter_beyond_is_not() {
        // 4 (43 / 8 + 3 * 127 / 8) = 212.
        let on = Frame { major: 127, minor: 43, greatest: 212, ..Frame::default() };
        assert!(DEVICE.allows(&on) && !DEVICE.allows(&Frame { greatest: 213, ..on }));
    }
}
