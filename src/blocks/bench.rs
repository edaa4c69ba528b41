//! A test bench for one block: set its inputs, read its outputs, tick.

use std::sync::Arc;

use super::{Body, Builder, Description, Direction, Parameters, find};
use crate::base::{Op, Port, Signal, SourceId};
use crate::compile::{Owner, OwnerId, Program, compile_graph};
use crate::engine::{Engine, Interpreter};

/// One block under test, driven by the interpreter.
pub(crate) struct Bench {
    description: &'static Description,
    program: Arc<Program>,
    engine: Interpreter,
}

impl Bench {
    /// Builds the block with its defaults but for `parameters`.
    pub(crate) fn new(name: &str, parameters: &[(&str, i64)]) -> Self {
        Self::of(name, parameters, None)
    }

    /// The same with the memory image that `text` says.
    pub(crate) fn with_image(name: &str, parameters: &[(&str, i64)], text: &str) -> Self {
        Self::of(name, parameters, Some(text))
    }

    fn of(name: &str, parameters: &[(&str, i64)], text: Option<&str>) -> Self {
        let block = find(name).unwrap_or_else(|| panic!("no block {name}"));
        let mut values = Parameters::defaults(block.description());
        for (name, value) in parameters {
            assert!(values.set(name, *value), "no parameter {name}");
        }
        for p in block.description().parameters {
            assert!((p.min..=p.max).contains(&values.get(p.name)), "{} is out of range", p.name);
        }
        if let Some(text) = text {
            let format = block.image().expect("a block with an image");
            values.set_image(Arc::new((format.read)(SourceId::new(0), text).expect("a good image")));
        }
        block.check(&values).expect("accepted parameters");
        let body = Builder::build(block, &values).expect("a body");
        let program = Arc::new(program_of(block.description(), body));
        Self { description: block.description(), engine: Interpreter::new(Arc::clone(&program)), program }
    }

    /// Sets an input and settles. A negative number is encoded in two's complement.
    pub(crate) fn set(&mut self, input: &str, value: i64) {
        let place = self.program.inputs.iter().position(|port| port.name == input);
        let place = place.unwrap_or_else(|| panic!("{} has no input {input}", self.description.name));
        let width = self.program.inputs[place].width;
        let word = value as u64 & crate::base::word::mask(width);
        let same = crate::base::word::signed(word, width) == value || word as i64 == value;
        assert!(same, "{value} does not fit the {width} bits of {input}");
        self.engine.set_input(place, word);
        self.engine.settle();
    }

    /// Sets several inputs.
    pub(crate) fn set_all(&mut self, inputs: &[(&str, i64)]) {
        inputs.iter().for_each(|(input, value)| self.set(input, *value));
    }

    /// The word at an output, or of a signal named inside the block.
    pub(crate) fn get(&self, name: &str) -> u64 {
        let ports = self.program.outputs.iter().map(|port| (port.name.clone(), port.value));
        let signals = self.program.signals.iter().map(|signal| (signal.name(), signal.value));
        let mut all = ports.chain(signals);
        let found = all.find(|(known, _)| known == name);
        self.engine.value(found.unwrap_or_else(|| panic!("{} has no {name}", self.description.name)).1)
    }

    /// The same word in two's complement.
    pub(crate) fn get_signed(&self, name: &str) -> i64 {
        let port = self.program.outputs.iter().find(|port| port.name == name).expect("an output");
        crate::base::word::signed(self.get(name), port.width)
    }

    /// Ends the tick.
    pub(crate) fn tick(&mut self) {
        self.engine.advance(1, false);
    }
}

fn program_of(description: &Description, body: Body) -> Program {
    let ports = |direction| description.ports_of(direction);
    let inputs: Vec<_> = (0..body.inputs.len())
        .map(|i| {
            body.graph.nodes.iter().position(|node| node.op == Op::Input(i as u32)).expect("every input is a node")
        })
        .map(crate::base::ValueId::new)
        .collect();
    let port = |port: &super::PortDescription, value| Port {
        name: port.name.to_owned(),
        width: body.graph.width(value),
        signed: port.signed,
        fraction: None,
        value,
    };
    let signal = |signal: &super::InnerSignal| Signal {
        path: [description.name.to_owned()].into_iter().chain(signal.path.iter().cloned()).collect(),
        width: body.graph.width(signal.value),
        signed: signal.signed,
        fraction: None,
        value: signal.value,
    };
    compile_graph(Program {
        owner: vec![OwnerId::new(0); body.graph.nodes.len()],
        owners: vec![Owner { parent: None, module: description.name.into() }],
        inputs: ports(Direction::Input).zip(&inputs).map(|(p, &value)| port(p, value)).collect(),
        outputs: ports(Direction::Output).zip(&body.outputs).map(|(p, &value)| port(p, value)).collect(),
        pulses: Vec::new(),
        signals: body.signals.iter().map(signal).collect(),
        stop: None,
        graph: body.graph,
    })
}
