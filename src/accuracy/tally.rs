//! What counts of many frames: how many break the law, the worst ones, slope by slope.

use super::{Claim, Frame};

/// How many of the worst frames are kept.
const MOST_WORST: usize = 10;
/// Slopes, in degrees from the major axis: 0 to 1, 1 to 2, .. 44 to 45, which has 45 with it.
const SLOPES: usize = 45;

/// Frames of about the same slope.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Slope {
    /// How many.
    pub frames: u64,
    /// The one that deviates most.
    pub worst: Frame,
}

/// What counts of the frames so far. A later frame takes the place of an earlier one only if it is more, so that what is
/// kept does not depend on how the frames were dealt out.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Tally {
    /// Frames, one for each segment.
    pub segments: u64,
    /// Frames that deviate more than the law allows.
    pub violations: u64,
    /// Frames that deviate more than the law as it is printed, with its rounding.
    pub beyond_printed: u64,
    /// Frames that end farther off than they may.
    pub astray: u64,
    /// Frames that have not ended before the limit.
    pub unfinished: u64,
    /// Those that deviate most, in order.
    pub worst: Vec<Frame>,
    /// The one whose end is farthest off.
    pub end: Frame,
    /// The one with most equal steps in a row.
    pub run: Frame,
    /// The one of the least mean feed.
    pub slowest: Option<Frame>,
    /// The one of the greatest mean feed.
    pub fastest: Option<Frame>,
    /// The segment of no length, if it was among them: it has no direction, so none of the others counts it.
    pub no_length: Option<Frame>,
    /// By degrees.
    pub slopes: Vec<Slope>,
}

impl Default for Tally {
    fn default() -> Self {
        Self {
            segments: 0,
            violations: 0,
            beyond_printed: 0,
            astray: 0,
            unfinished: 0,
            worst: Vec::new(),
            end: Frame::default(),
            run: Frame::default(),
            slowest: None,
            fastest: None,
            no_length: None,
            slopes: vec![Slope::default(); SLOPES],
        }
    }
}

impl Tally {
    /// Counts a frame.
    pub fn add(&mut self, frame: Frame, claim: &Claim) {
        let Claim { law, printed, end } = *claim;
        self.segments += 1;
        if frame.major == 0 {
            self.no_length = Some(frame);
            return;
        }
        let deviation = frame.deviation();
        self.astray += u64::from(frame.end_error() > end);
        self.violations += u64::from(!law.allows(&frame));
        self.beyond_printed += u64::from(printed.is_some_and(|printed| deviation > printed.at(frame.angle())));
        let slope = &mut self.slopes[slope_of(&frame)];
        slope.frames += 1;
        keep(&mut slope.worst, frame, Frame::deviation);
        self.keep_extremes(frame);
        self.keep_worst(frame);
    }

    fn keep_extremes(&mut self, frame: Frame) {
        keep(&mut self.end, frame, Frame::end_error);
        keep(&mut self.run, frame, |frame| frame.longest_run as f64);
        keep(self.slowest.get_or_insert(frame), frame, |frame| -frame.feed());
        keep(self.fastest.get_or_insert(frame), frame, Frame::feed);
    }

    fn keep_worst(&mut self, frame: Frame) {
        let deviation = frame.deviation();
        if self.worst.len() == MOST_WORST && self.worst.last().is_some_and(|last| last.deviation() >= deviation) {
            return;
        }
        let place = self.worst.partition_point(|other| other.deviation() >= deviation);
        self.worst.insert(place, frame);
        self.worst.truncate(MOST_WORST);
    }

    /// Counts the frames of `later`, which came behind these.
    pub fn merge(&mut self, later: Tally) {
        self.segments += later.segments;
        self.violations += later.violations;
        self.beyond_printed += later.beyond_printed;
        self.astray += later.astray;
        self.unfinished += later.unfinished;
        self.no_length = self.no_length.or(later.no_length);
        for frame in [later.end, later.run].into_iter().chain(later.slowest).chain(later.fastest) {
            if frame.major > 0 {
                self.keep_extremes(frame);
            }
        }
        later.worst.into_iter().for_each(|frame| self.keep_worst(frame));
        for (slope, later) in self.slopes.iter_mut().zip(later.slopes) {
            slope.frames += later.frames;
            keep(&mut slope.worst, later.worst, Frame::deviation);
        }
    }

    /// The greatest deviation, in whole steps.
    #[must_use]
    pub fn max_deviation(&self) -> f64 {
        self.worst.first().map_or(0.0, Frame::deviation)
    }
}

fn slope_of(frame: &Frame) -> usize {
    (frame.angle().to_degrees() as usize).min(SLOPES - 1)
}

/// Keeps the frame that has more.
fn keep(kept: &mut Frame, frame: Frame, of: impl Fn(&Frame) -> f64) {
    if kept.major == 0 || of(&frame) > of(kept) {
        *kept = frame;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scenario::Law;

    const CLAIM: Claim = Claim { law: Law { sin: 0.0, cos: 0.5 }, printed: None, end: 0.0 };

    fn frame(major: u64, minor: u64, greatest: u64, left_minor: i64) -> Frame {
        Frame { major, minor, greatest, left_minor, steps: major, longest_run: minor, ..Frame::default() }
    }

    fn frames() -> Vec<Frame> {
        let mut all = vec![frame(0, 0, 0, -4)];
        for major in 1..=9 {
            all.extend(
                (0..=major).map(|minor| frame(major, minor, (major * 7 + minor * 5) % 23, (minor as i64 % 3) - 1)),
            );
        }
        all
    }

    fn tally(frames: &[Frame]) -> Tally {
        let mut tally = Tally::default();
        frames.iter().for_each(|&frame| tally.add(frame, &CLAIM));
        tally
    }

    #[test]
    fn it_keeps_what_a_plain_look_at_all_frames_finds() {
        let (all, tally) = (frames(), tally(&frames()));
        let long = &all[1..];
        assert_eq!((tally.segments, tally.no_length), (all.len() as u64, Some(all[0])));
        assert_eq!(tally.violations, long.iter().filter(|frame| frame.greatest > 2 * frame.major).count() as u64);
        assert_eq!(tally.astray, long.iter().filter(|frame| frame.minor % 3 != 1).count() as u64);
        let mut deviations: Vec<_> = long
            .iter()
            .map(|f| f.greatest as f64 / 4.0 / ((f.major * f.major + f.minor * f.minor) as f64).sqrt())
            .collect();
        deviations.sort_by(|a, b| b.total_cmp(a));
        let worst: Vec<_> = tally.worst.iter().map(Frame::deviation).collect();
        assert!(worst.iter().zip(&deviations).all(|(a, b)| (a - b).abs() < 1e-12) && worst.len() == 10);
        assert_eq!((tally.end.end_error(), tally.run.longest_run), (0.25, 9));
        // The end is (major, minor - left) with as many steps as major: an axis is the slowest, a diagonal the fastest but
        // for the quarters of its end.
        let feed = |f: &Frame| f64::hypot(f.major as f64, f.minor as f64 - f.left_minor as f64 / 4.0) / f.major as f64;
        let feeds = || long.iter().map(feed);
        let [least, most] = [tally.slowest, tally.fastest].map(|frame| frame.expect("one").feed());
        assert_eq!((least, most), (feeds().fold(9.0, f64::min), feeds().fold(0.0, f64::max)));
        assert_eq!(tally.slopes.iter().map(|slope| slope.frames).sum::<u64>(), long.len() as u64);
        assert_eq!((tally.slopes[0].frames, tally.slopes[44].frames), (9, 9), "the axis; the diagonal");
    }

    #[test]
    fn parts_merged_in_order_are_the_whole() {
        let all = frames();
        for cut in 0..=all.len() {
            let mut merged = tally(&all[..cut]);
            merged.merge(tally(&all[cut..]));
            assert_eq!(merged, tally(&all), "cut at {cut}");
        }
    }
}
