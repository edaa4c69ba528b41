//! A simulation to be stepped by hand, for programs, tests and lessons.

use std::io::{self, Write};
use std::sync::Arc;

use bitvec::{order::Lsb0, vec::BitVec, view::BitView};

use super::shipped::{self, Shelf};
use crate::base::{Diagnostic, Report, Signal, ValueId, word};
use crate::compile::{Observe, Program, compile};
use crate::engine::{Engine, Interpreter};
use crate::netlist::{self, Netlist};
use crate::scenario::Number;
use crate::trace::{Plan, Sampler, Select, VcdWriter, Window};

/// A circuit that stands at a tick, with every net settled and readable. The [crate's page](crate) has an example.
pub struct Simulation {
    program: Arc<Program>,
    engine: Box<dyn Engine>,
    tick: u64,
    trace: Option<Trace>,
}

/// A waveform being written.
struct Trace {
    sampler: Sampler,
    vcd: VcdWriter<Box<dyn Write>>,
    /// The first error of writing, kept until the trace ends.
    written: io::Result<()>,
}

impl Trace {
    fn sample(&mut self, tick: u64, engine: &dyn Engine) {
        if let (Ok(()), Some(changes)) = (&self.written, self.sampler.sample_all(tick, |words| engine.read(words))) {
            self.written = self.vcd.tick(tick, changes);
        }
    }
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
        Self { engine: Box::new(Interpreter::new(Arc::clone(&program))), program, tick: 0, trace: None }
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

    /// Writes the signals that match one of `globs` as VCD into `out`, from this tick on.
    ///
    /// # Errors
    /// `W001` not a glob, `W002` a glob that matches nothing, `C003` `out` refuses.
    pub fn trace(&mut self, globs: &[&str], out: impl Write + 'static) -> Result<(), Report> {
        let select = Select::new(globs)?;
        let signals = &self.program.signals;
        let chosen: Vec<_> = signals.iter().filter(|signal| select.matches(&signal.name())).cloned().collect();
        select.check(&chosen, || signals.iter().map(Signal::name).collect())?;
        let plan = Plan::new(&chosen);
        let vcd = VcdWriter::new(Box::new(out) as Box<dyn Write>, &plan)
            .map_err(|error| Diagnostic::new("C003", format!("cannot write the trace: {error}")))?;
        let sampler = Sampler::new(&plan, Window::ALL);
        self.engine.watch(sampler.values());
        self.trace = Some(Trace { sampler, vcd, written: Ok(()) });
        Ok(())
    }

    /// Ends the trace with the present tick. Without a trace nothing happens.
    ///
    /// # Errors
    /// The first error of writing since the trace began.
    pub fn end_trace(&mut self) -> io::Result<()> {
        self.sample();
        self.trace.take().map_or(Ok(()), |trace| trace.written.and_then(|()| trace.vcd.finish().map(drop)))
    }

    fn sample(&mut self) {
        if let Some(trace) = &mut self.trace {
            trace.sample(self.tick, self.engine.as_ref());
        }
    }

    /// Ends this tick and settles the next one.
    pub fn step(&mut self) {
        self.sample();
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
            let names: Vec<_> = signals.iter().map(Signal::name).collect();
            let diagnostic = Diagnostic::new("S012", format!("there is no net `{net}`"));
            diagnostic.nearest(net, names.iter().map(String::as_str)).into()
        })
    }
}
