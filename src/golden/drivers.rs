//! Who drives whom, told by names.

use std::collections::HashMap;

/// What drives each signal, by its name in a netlist. Made from the netlist by the caller.
pub type Drivers = HashMap<String, Driven>;

/// A signal's drivers and where it comes from.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Driven {
    /// The signals that it is computed from.
    pub by: Vec<Driver>,
    /// The block and the figure, for a person: `accumulator_1, a summer of FIG. 1`.
    pub place: String,
    /// Whether it is a net, not the port of a block, which is called otherwise than the net at it.
    pub is_net: bool,
}

/// A signal that another one is computed from.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Driver {
    /// Its name.
    pub net: String,
    /// Whether it works through state, so that its values of the ticks before count.
    pub delayed: bool,
}
