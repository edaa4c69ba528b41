//! What a run came to.

use crate::base::word::decode;
use crate::base::{Port, StoppedBy};
use crate::engine::Pulses;

/// What a run came to.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Outcome {
    /// Ticks run: those from tick 0 to the last one.
    pub ticks: u64,
    /// Why it ended.
    pub stopped_by: StoppedBy,
    /// The outputs, in the order of the circuit's header.
    pub outputs: Vec<Output>,
}

/// An output after a run.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Output {
    /// Name, width, sign, fraction.
    pub port: Port,
    /// Its word in the last tick.
    pub word: u64,
    /// Its pulses, if it has one bit.
    pub pulses: Option<Pulses>,
}

impl Outcome {
    /// The output of a name.
    #[must_use]
    pub fn output(&self, name: &str) -> Option<&Output> {
        self.outputs.iter().find(|output| output.port.name == name)
    }

    /// How many pulses a one-bit output gave.
    #[must_use]
    pub fn pulses(&self, name: &str) -> Option<u64> {
        Some(self.output(name)?.pulses?.rising)
    }
}

impl Output {
    /// The number that its word stands for, signed where the port is.
    #[must_use]
    pub fn number(&self) -> i128 {
        decode(self.word, self.port.width, self.port.signed)
    }

    /// The real number that the word of a fixed-point port stands for.
    #[must_use]
    pub fn real(&self) -> Option<f64> {
        self.port.fraction.map(|fraction| self.number() as f64 / 2f64.powi(fraction as i32))
    }
}
