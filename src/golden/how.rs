//! How two waveforms are compared.

use std::ops::Range;

/// Which signals two waveforms must both have.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub enum Signals {
    /// All of them: a golden trace and its run. Both must tell about the same ticks.
    #[default]
    All,
    /// Those that both have are compared; the others are told. Both must tell about the same ticks, but where their
    /// units differ or edges are looked at, one of the coarser ticks more or less is no difference.
    Common,
    /// Those that both have are compared, as far as both go: ours and an outside simulator's.
    Shared,
}

/// Which signals stand for each other.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub enum Names {
    /// Those of the same dotted name.
    #[default]
    Same,
    /// Those whose names have the longest common tail, whatever scopes a tool puts around; a bus in one file may be
    /// single bits in the other. Pairs of scopes or signals given here, expected and got, come first.
    Tails(Vec<(String, String)>),
}

/// What a bit that is x or z is equal to.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub enum Unknown {
    /// To itself only: x to x, z to z.
    #[default]
    Strict,
    /// To anything.
    Wild,
    /// To what 0 is equal to, as a two-state simulator has it.
    Zero,
}

/// An edge of a net at which a waveform is looked at.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Edge {
    /// The net's dotted name in its file; it has one bit.
    pub net: String,
    /// From 0 to 1, else from 1 to 0.
    pub is_rising: bool,
}

/// All that can be chosen for a comparison; by default nothing is forgiven.
#[derive(Clone, PartialEq, Default, Debug)]
pub struct How {
    /// Which signals both must have.
    pub signals: Signals,
    /// Which signals stand for each other.
    pub names: Names,
    /// Of the expected and the got waveform the edge at which it is looked at, just before it: the first edge is
    /// tick 0. Without one it is compared at every change.
    pub at: [Option<Edge>; 2],
    /// What x and z are equal to.
    pub unknown: Unknown,
    /// Differences that last no more than so many ticks are forgiven: a change may come so much earlier or later.
    pub late: u64,
    /// Numbers that are no further apart than this are equal. Words are compared on the circle of their width: as
    /// signed or unsigned numbers that do not run over it is the same.
    pub near: f64,
    /// The ticks that are compared, in the finer unit of the two; `None`: all.
    pub window: Option<Range<u64>>,
}
