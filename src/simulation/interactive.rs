//! A simulation to be stepped by hand, for programs, tests and lessons.

use std::sync::Arc;

use bitvec::{order::Lsb0, vec::BitVec, view::BitView};

use super::shipped::{self, Shelf};
use crate::base::{Diagnostic, Report, ValueId, word};
use crate::compile::{Observe, Program, compile};
use crate::engine::{Engine, Interpreter};
use crate::netlist::{self, Netlist};
use crate::scenario::Number;

/// A circuit that stands at a tick, with every net settled and readable.
///
/// ```
/// use stepwright::simulation::Simulation;
///
/// # fn main() -> Result<(), stepwright::base::Report> {
/// // The linear interpolator draws the segment to (8, 3).
/// let mut frame = Simulation::load("su1522157/interpolator", &[])?;
/// frame.set("major_32", 8)?;
/// frame.set("minor_34", 3)?;
/// frame.set("x_is_major_35", 1)?;
/// frame.set("start_33", 1)?;
/// frame.step();
/// frame.set("start_33", 0)?;
///
/// let (mut x, mut y) = (0, 0); // in quarter steps
/// while frame.read("busy")? == 1 {
///     x += 4 * frame.read("step_x_36")? + 3 * frame.read("step_xy_38")?;
///     y += 3 * frame.read("step_xy_38")?;
///     frame.step();
/// }
/// assert_eq!((x, y), (4 * 8, 4 * 3));
/// # Ok(())
/// # }
/// ```
pub struct Simulation {
    program: Arc<Program>,
    engine: Box<dyn Engine>,
    tick: u64,
}

impl Simulation {
    /// Loads a shipped circuit, for example `su1522157/interpolator`, with parameters of its top module.
    ///
    /// # Errors
    /// `C001` when there is no such circuit, or what is wrong with a parameter.
    pub fn load(circuit: &str, parameters: &[(&str, i64)]) -> Result<Self, Report> {
        let text = shipped::text(&format!("{circuit}.v")).ok_or_else(|| {
            let diagnostic = Diagnostic::new("C001", format!("there is no shipped circuit `{circuit}`"));
            diagnostic.nearest(circuit, shipped::names("v"))
        })?;
        let parameters: Vec<_> = parameters.iter().map(|&(name, value)| (name.to_owned(), value)).collect();
        let path = format!("circuits/{circuit}.v");
        let netlist = netlist::load(&path, text, None, &Shelf { near: circuit }, &parameters)?;
        Ok(Self::new(&netlist))
    }

    /// Puts a checked netlist at tick 0, all inputs 0.
    #[must_use]
    pub fn new(netlist: &Netlist) -> Self {
        let program = Arc::new(compile(netlist, &Observe::EVERYTHING));
        Self { engine: Box::new(Interpreter::new(Arc::clone(&program))), program, tick: 0 }
    }

    /// The present tick.
    #[must_use]
    pub fn tick(&self) -> u64 {
        self.tick
    }

    /// Sets an input from this tick on; a real number on a fixed-point port through [`Number::Real`].
    ///
    /// # Errors
    /// `S010` unknown input, `S011` the number does not fit.
    pub fn set(&mut self, input: &str, value: impl Into<Number>) -> Result<(), Report> {
        let ports = &self.program.inputs;
        let place = ports.iter().position(|port| port.name == input).ok_or_else(|| {
            let diagnostic = Diagnostic::new("S010", format!("the circuit has no input `{input}`"));
            diagnostic.nearest(input, ports.iter().map(|port| port.name.as_str()))
        })?;
        let port = &ports[place];
        let word = value.into().encode(port.width, port.signed, port.fraction);
        let word = word.map_err(|error| Diagnostic::new("S011", format!("input `{input}`: {error}")))?;
        self.engine.set_input(place, word);
        self.engine.settle();
        Ok(())
    }

    /// Ends this tick and settles the next one.
    pub fn step(&mut self) {
        self.tick += self.engine.advance(1, false);
    }

    /// Steps until `net` (dotted name) is not 0, at least once and at most `limit` times; whether it came.
    ///
    /// # Errors
    /// `S012` unknown net.
    pub fn run_until(&mut self, net: &str, limit: u64) -> Result<bool, Report> {
        let (value, ..) = self.find(net)?;
        for _ in 0..limit {
            self.step();
            if self.engine.value(value) != 0 {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// The number on a net, port or named value inside a block, by dotted name below the top module.
    ///
    /// # Errors
    /// `S012` unknown net.
    pub fn read(&self, net: &str) -> Result<i128, Report> {
        let (value, width, signed) = self.find(net)?;
        Ok(word::decode(self.engine.value(value), width, signed))
    }

    /// The same as bits, least significant first: contents of registers and delay chains.
    ///
    /// # Errors
    /// `S012` unknown net.
    pub fn bits(&self, net: &str) -> Result<BitVec<u64, Lsb0>, Report> {
        let (value, width, _) = self.find(net)?;
        Ok(self.engine.value(value).view_bits::<Lsb0>()[..width as usize].to_bitvec())
    }

    fn find(&self, net: &str) -> Result<(ValueId, u32, bool), Report> {
        let signals = &self.program.signals;
        let found = signals.iter().find(|signal| signal.path[1..].iter().map(String::as_str).eq(net.split('.')));
        found.map(|signal| (signal.value, signal.width, signal.signed)).ok_or_else(|| {
            let names: Vec<_> = signals.iter().map(crate::base::Signal::name).collect();
            let diagnostic = Diagnostic::new("S012", format!("there is no net `{net}`"));
            diagnostic.nearest(net, names.iter().map(String::as_str)).into()
        })
    }
}
