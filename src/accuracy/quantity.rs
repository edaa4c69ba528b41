//! What of a frame can be a column of a sweep.

use super::Frame;

/// A number that is measured of a frame.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Quantity {
    /// [`Frame::deviation`].
    Deviation,
    /// [`Frame::end_error`].
    End,
    /// Steps, of whatever kind.
    Steps,
    /// Most equal steps in a row.
    Run,
    /// [`Frame::feed`].
    Feed,
}

impl Quantity {
    /// All there are.
    pub const ALL: [Self; 5] = [Self::Deviation, Self::End, Self::Steps, Self::Run, Self::Feed];

    /// Its name as a column.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Deviation => "deviation",
            Self::End => "end",
            Self::Steps => "steps",
            Self::Run => "run",
            Self::Feed => "feed",
        }
    }

    /// Its number for a frame.
    #[must_use]
    pub fn of(self, frame: &Frame) -> f64 {
        match self {
            Self::Deviation => frame.deviation(),
            Self::End => frame.end_error(),
            Self::Steps => frame.steps as f64,
            Self::Run => frame.longest_run as f64,
            Self::Feed => frame.feed(),
        }
    }
}
