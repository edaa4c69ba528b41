//! What of a circuit is to be seen, decided before anything is optimised.

use crate::netlist::NetId;

/// A net to wait for: the run stops when it is high (any bit of it), or low (all bits).
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Until {
    /// The net.
    pub net: NetId,
    /// `true`: until it is high; `false`: until it is low.
    pub high: bool,
}

/// What must stay readable while a program runs. The top module's outputs always do.
#[derive(Clone, Copy)]
pub struct Observe<'a> {
    /// Which signals, by their dotted name below the top module.
    pub signals: &'a dyn Fn(&str) -> bool,
    /// When to stop.
    pub until: Option<Until>,
    /// Whether engines count the pulses of one-bit outputs.
    pub pulses: bool,
}

impl Observe<'_> {
    /// Outputs only.
    pub const OUTPUTS: Observe<'static> = Observe { signals: &|_| false, until: None, pulses: false };
    /// Every signal there is.
    pub const EVERYTHING: Observe<'static> = Observe { signals: &|_| true, until: None, pulses: false };
}
