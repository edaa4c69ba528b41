//! Random circuit files: blocks of the registry, gates, slices, concatenations, feedback through registers.

use std::fmt::Write;

use proptest::prelude::*;
use stepwright::blocks::{Block, Builder, Direction, Parameters, REGISTRY};

/// What to write; every choice is taken modulo what there is.
#[derive(Clone, Debug)]
pub struct Draft {
    /// Widths of the inputs.
    pub inputs: Vec<u32>,
    /// Registers that close loops: their widths, and what they load.
    pub feedback: Vec<(u32, u64)>,
    /// Blocks and gates.
    pub cells: Vec<Choice>,
}

/// A block or gate.
#[derive(Clone, Debug)]
pub struct Choice {
    /// Which one.
    pub kind: u16,
    /// Its parameters.
    pub parameters: [u32; 6],
    /// What its inputs are.
    pub inputs: [u64; 8],
}

const GATES: [&str; 8] = ["and", "or", "xor", "nand", "nor", "xnor", "buf", "not"];

/// Drafts of up to so many cells.
pub fn drafts(cells: usize) -> impl Strategy<Value = Draft> {
    let width = || prop_oneof![Just(1), 1..=16_u32, 1..=64_u32];
    let choice = (any::<u16>(), any::<[u32; 6]>(), any::<[u64; 8]>()).prop_map(|(kind, parameters, inputs)| Choice {
        kind,
        parameters,
        inputs,
    });
    let inputs = prop::collection::vec(width(), 0..4);
    let feedback = prop::collection::vec((width(), any::<u64>()), 0..4);
    (inputs, feedback, prop::collection::vec(choice, 1..cells)).prop_map(|(inputs, feedback, cells)| Draft {
        inputs,
        feedback,
        cells,
    })
}

/// The text of a draft: a module `random`.
pub fn write(draft: &Draft) -> String {
    module("random", "", draft, |_| ())
}

/// The text of a module; `more` adds to its cells.
pub(super) fn module(name: &str, outputs: &str, draft: &Draft, more: impl FnOnce(&mut Writer)) -> String {
    let mut writer = Writer::default();
    let mut header = String::new();
    for (i, &width) in draft.inputs.iter().enumerate() {
        write!(header, ",\n    input wire {}in_{i}", range(width)).expect("a string");
        writer.nets.push((format!("in_{i}"), width));
    }
    for (i, &(width, _)) in draft.feedback.iter().enumerate() {
        writer.declare(format!("held_{i}"), width);
    }
    for (i, choice) in draft.cells.iter().enumerate() {
        writer.cell(i, choice);
    }
    more(&mut writer);
    for (i, &(width, choice)) in draft.feedback.iter().enumerate() {
        let (word, enable) = (writer.expression(choice, width), writer.expression(choice.rotate_left(20), 1));
        writer.line(format!(
            "register #(.WIDTH({width})) feedback_{i} (.clk(clk), .word({word}), .enable({enable}), .clear(1'b0), .q(held_{i}));"
        ));
    }
    format!("module {name} (\n    input wire clk{header}{outputs}\n);\n{}endmodule\n", writer.text)
}

/// The cells of a module, and the nets that there are to connect.
#[derive(Default)]
pub(super) struct Writer {
    text: String,
    nets: Vec<(String, u32)>,
}

impl Writer {
    pub(super) fn line(&mut self, line: String) {
        writeln!(self.text, "    {line}").expect("a string");
    }

    pub(super) fn declare(&mut self, name: String, width: u32) {
        self.line(format!("wire {}{name};", range(width)));
        self.nets.push((name, width));
    }

    pub(super) fn cell(&mut self, i: usize, choice: &Choice) {
        let kind = usize::from(choice.kind) % (GATES.len() + 2 * REGISTRY.len());
        match GATES.get(kind) {
            Some(gate) => self.gate(i, gate, choice),
            None => self.block(i, REGISTRY[kind % REGISTRY.len()], choice),
        }
    }

    fn gate(&mut self, i: usize, gate: &str, choice: &Choice) {
        let one = ["buf", "not"].contains(&gate);
        let count = if one { 1 } else { 2 + choice.parameters[0] as usize % 4 };
        let inputs: Vec<_> = choice.inputs[..count].iter().map(|&input| self.expression(input, 1)).collect();
        self.declare(format!("gate_{i}_out"), 1);
        self.line(format!("{gate} gate_{i} (gate_{i}_out, {});", inputs.join(", ")));
    }

    fn block(&mut self, i: usize, block: &Block, choice: &Choice) {
        let description = block.description();
        let parameters = parameters(block, choice);
        let mut connections: Vec<String> = description.clocked.then(|| ".clk(clk)".to_owned()).into_iter().collect();
        for (port, input) in description.ports_of(Direction::Input).zip(choice.inputs.iter().cycle()) {
            let word = self.expression(*input, port.width.bits(&parameters) as u32);
            connections.push(format!(".{}({word})", port.name));
        }
        for port in description.ports_of(Direction::Output) {
            let name = format!("block_{i}_{}", port.name);
            connections.push(format!(".{}({name})", port.name));
            self.declare(name, port.width.bits(&parameters) as u32);
        }
        let values: Vec<_> = parameters.iter().map(|(name, value)| format!(".{name}({})", number(value))).collect();
        let values = if values.is_empty() { String::new() } else { format!(" #({})", values.join(", ")) };
        self.line(format!("{}{values} block_{i} ({});", description.name, connections.join(", ")));
    }

    /// A word of `width` bits: a net, a part of one, several side by side, a constant.
    pub(super) fn expression(&self, choice: u64, width: u32) -> String {
        let place = (choice % (self.nets.len() as u64 + 1)) as usize;
        let Some((name, net)) = self.nets.get(place) else { return constant(choice, width) };
        let rest = choice.rotate_right(7);
        match net.cmp(&width) {
            std::cmp::Ordering::Equal => name.clone(),
            std::cmp::Ordering::Less => format!("{{{}, {name}}}", self.expression(rest, width - net)),
            std::cmp::Ordering::Greater => {
                let low = (rest % u64::from(net - width + 1)) as u32;
                if width == 1 { format!("{name}[{low}]") } else { format!("{name}[{}:{low}]", low + width - 1) }
            }
        }
    }
}

fn range(width: u32) -> String {
    if width == 1 { String::new() } else { format!("[{}:0] ", width - 1) }
}

fn constant(choice: u64, width: u32) -> String {
    format!("{width}'h{:x}", choice & stepwright::base::word::mask(width))
}

/// A number, with a size if 32 bits do not hold it.
fn number(value: i64) -> String {
    match i32::try_from(value) {
        Ok(small) => small.to_string(),
        Err(_) if value < 0 => format!("-64'sd{}", value.unsigned_abs()),
        Err(_) => format!("64'sd{value}"),
    }
}

/// Parameters that the block accepts and that keep its words within 64 bits; its defaults when the choice does not.
fn parameters(block: &Block, choice: &Choice) -> Parameters {
    let description = block.description();
    let defaults = Parameters::defaults(description);
    let mut chosen = defaults.clone();
    // A memory image is a file, which random circuits have none of.
    let names_a_file = |name: &str| block.image().is_some_and(|format| format.parameter == name);
    for (parameter, &number) in description.parameters.iter().zip(choice.parameters.iter().cycle()) {
        if names_a_file(parameter.name) {
            continue;
        }
        let span = match number % 4 {
            0 => continue,
            1 => 0,
            2 => (parameter.max - parameter.min).min(20),
            _ => (parameter.max - parameter.min).min(600),
        };
        chosen.set(parameter.name, parameter.min + i64::from(number >> 2) % (span + 1));
    }
    let fits = |parameters: &Parameters| {
        description.ports.iter().all(|port| (1..=64).contains(&port.width.bits(parameters)))
            && block.check(parameters).is_ok()
            && Builder::build(block, parameters).is_ok()
    };
    if fits(&chosen) { chosen } else { defaults }
}
