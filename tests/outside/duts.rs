//! Many blocks side by side in one netlist, fed with the same random words: the netlist for us, its text for others.

use std::fmt::Write as _;
use std::sync::Arc;

use stepwright::base::word::mask;
use stepwright::base::{Change, SourceId, Sources, Span, Stimulus, StopRule};
use stepwright::blocks::{Block, Body, Builder, Direction, Parameters};
use stepwright::netlist::{Cell, CellId, CellKind, Drive, Net, NetId, Netlist, Part, Scope, ScopeId, Source};

use super::random::Random;

const WORDS: usize = 16;
const NOWHERE: fn() -> Span = || Span { source: SourceId::new(0), start: 0, end: 0 };

/// A netlist `duts` that holds an instance of each block for each set of parameters.
pub struct Duts {
    /// The netlist.
    pub netlist: Netlist,
    /// The same as structural Verilog.
    pub text: String,
}

impl Duts {
    /// Places the instances; each input of each reads some bits of one of 16 random words.
    pub fn new(instances: Vec<(&'static Block, Parameters)>) -> Self {
        let mut duts = Self { netlist: empty(), text: String::new() };
        for word in 0..WORDS {
            let net =
                duts.net(format!("random_{word}"), 64, Direction::Input, Source::Input { input: word as u32, low: 0 });
            duts.netlist.inputs.push(net);
        }
        let mut random = Random(1);
        for (block, parameters) in instances {
            duts.place(block, parameters, &mut random);
        }
        let ports: Vec<_> = duts.netlist.nets[1..].iter().map(port_text).collect();
        duts.text = format!(
            "`default_nettype none\nmodule duts (\n    input wire clk,\n    {}\n);\n{}endmodule\n",
            ports.join(",\n    "),
            duts.text
        );
        duts
    }

    fn net(&mut self, name: String, width: u32, port: Direction, source: Source) -> NetId {
        let drives = vec![Drive { low: 0, width, source, span: NOWHERE() }];
        self.netlist.nets.push(Net { name, width, port: Some(port), roots: drives.clone(), drives, ..clock() });
        NetId::new(self.netlist.nets.len() - 1)
    }

    fn place(&mut self, block: &'static Block, parameters: Parameters, random: &mut Random) {
        let body: Arc<Body> = Arc::new(Builder::build(block, &parameters).expect("a body"));
        let description = block.description();
        let cell = CellId::new(self.netlist.cells.len());
        let name = format!("dut_{}", cell.index());
        let mut connections = Vec::new();
        if description.clocked {
            connections.push(".clk(clk)".to_owned());
        }
        let mut inputs = Vec::new();
        for (port, &width) in description.ports_of(Direction::Input).zip(&body.inputs) {
            let word = random.below(WORDS as u64) as usize;
            let low = random.below(u64::from(64 - width) + 1) as u32;
            inputs.push(vec![Part::Net { net: self.netlist.inputs[word], low, width }]);
            connections.push(format!(".{}(random_{word}[{}:{low}])", port.name, low + width - 1));
        }
        for (output, (port, &value)) in description.ports_of(Direction::Output).zip(&body.outputs).enumerate() {
            let source = Source::Cell { cell, output: output as u32, low: 0 };
            let net = format!("{name}_{}", port.name);
            connections.push(format!(".{}({net})", port.name));
            let net = self.net(net, body.graph.width(value), Direction::Output, source);
            self.netlist.outputs.push(net);
        }
        let values: Vec<_> = parameters.iter().map(|(name, value)| format!(".{name}({})", number(value))).collect();
        let overrides = if values.is_empty() { String::new() } else { format!("#({}) ", values.join(", ")) };
        writeln!(self.text, "    {} {overrides}{name} ({});", description.name, connections.join(", ")).expect("text");
        let kind = CellKind::Block { block, parameters };
        self.netlist.cells.push(Cell { scope: ScopeId::new(0), name, kind, inputs, body, span: NOWHERE() });
    }

    /// What stands behind an output, for messages.
    pub fn describe(&self, output: usize) -> String {
        let net = &self.netlist.nets[self.netlist.outputs[output].index()];
        let Source::Cell { cell, .. } = net.drives[0].source else { return net.name.clone() };
        format!("{}: {:?}", net.name, self.netlist.cells[cell.index()].kind)
    }
}

/// New random words at every tick: dense ones, sparse ones as pulses come, and small numbers of either sign.
pub fn random_words(ticks: u64) -> Stimulus {
    let mut random = Random(2);
    let mut word = |input: usize| {
        let dense = random.word();
        match input % 4 {
            0 => dense,
            1 => dense & random.word(),
            2 => dense & random.word() & random.word() & random.word(),
            _ => ((dense as i64) >> random.below(64)) as u64,
        }
    };
    let each = (0..ticks).flat_map(|tick| (0..WORDS).map(move |input| (tick, input)));
    let changes = each.map(|(tick, input)| Change { tick, input, word: word(input) }).collect();
    Stimulus { initial: vec![0; WORDS], changes, stop: StopRule::Ticks(ticks) }
}

fn number(value: i64) -> String {
    if i32::try_from(value).is_ok() { value.to_string() } else { format!("64'h{:x}", value as u64 & mask(64)) }
}

fn port_text(net: &Net) -> String {
    let direction = if net.port == Some(Direction::Input) { "input" } else { "output" };
    format!("{direction} wire [{}:0] {}", net.width - 1, net.name)
}

fn clock() -> Net {
    Net {
        scope: ScopeId::new(0),
        name: "clk".to_owned(),
        width: 1,
        signed: false,
        fraction: None,
        port: Some(Direction::Input),
        is_clock: true,
        drives: Vec::new(),
        roots: Vec::new(),
        span: NOWHERE(),
    }
}

fn empty() -> Netlist {
    let mut sources = Sources::default();
    sources.add("duts.v", "");
    let top = Scope { module: "duts".into(), name: "duts".to_owned(), parent: None, span: NOWHERE() };
    Netlist {
        sources: Arc::new(sources),
        scopes: vec![top],
        nets: vec![clock()],
        cells: Vec::new(),
        parameters: Vec::new(),
        given: Vec::new(),
        inputs: Vec::new(),
        outputs: Vec::new(),
    }
}
