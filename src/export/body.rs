//! A body: the ops of a block for one set of parameters, as Verilog statements.

use super::expression::{Expressions, input_name, literal, ram_name, range, register_name, rom_name};
use super::page::Page;
use crate::base::{MemoryImage, Op, RamId, RegisterId, RomId, ValueId};
use crate::blocks::{Body, Description, Direction, InnerSignal};

/// Writes what computes a block's outputs from its inputs. A body's ops follow their operands, so that every name
/// is declared before it is read.
pub(super) fn body(page: &mut Page, description: &Description, body: &Body) {
    let write = Writer { body, expressions: Expressions { graph: &body.graph } };
    for (i, (port, width)) in description.ports_of(Direction::Input).zip(&body.inputs).enumerate() {
        page.line(format!("wire {}{} = {};", range(*width), input_name(i), port.name));
    }
    write.memories(page);
    write.registers(page);
    write.ops(page);
    write.commits(page);
    let is_port = |signal: &&InnerSignal| matches!(&signal.path[..], [name] if has_port(description, name));
    let inner: Vec<_> = body.signals.iter().filter(|signal| !is_port(signal)).collect();
    write.signals(page, &inner, 0);
    for (port, &value) in description.ports_of(Direction::Output).zip(&body.outputs) {
        page.line(format!("assign {} = {};", port.name, write.expressions.name(value)));
    }
}

fn has_port(description: &Description, name: &str) -> bool {
    description.ports.iter().any(|port| port.name == name)
}

struct Writer<'a> {
    body: &'a Body,
    expressions: Expressions<'a>,
}

impl Writer<'_> {
    fn memories(&self, page: &mut Page) {
        for (i, rom) in self.body.graph.roms.iter().enumerate() {
            memory(page, &rom_name(RomId::new(i)), &rom.image);
        }
        for (i, ram) in self.body.graph.rams.iter().enumerate() {
            memory(page, &ram_name(RamId::new(i)), &ram.image);
        }
    }

    fn registers(&self, page: &mut Page) {
        for (i, register) in self.body.graph.registers.iter().enumerate() {
            let (name, init) = (register_name(RegisterId::new(i)), literal(register.init, register.width));
            page.line(format!("reg {}{name} = {init};", range(register.width)));
        }
    }

    fn ops(&self, page: &mut Page) {
        for (i, node) in self.body.graph.nodes.iter().enumerate() {
            if !node.op.is_leaf() && !matches!(node.op, Op::Copy(_)) {
                let (name, value) = (self.expressions.name(ValueId::new(i)), self.expressions.expression(*node));
                page.line(format!("wire {}{name} = {value};", range(node.width)));
            }
        }
    }

    /// What changes at the end of a tick.
    fn commits(&self, page: &mut Page) {
        let name = |id| self.expressions.name(id);
        for (i, ram) in self.body.graph.rams.iter().enumerate() {
            let write = ram.write;
            let within = self.expressions.within(&ram.image, write.address).map(|within| format!(" && {within}"));
            let (memory, index) = (ram_name(RamId::new(i)), self.expressions.index(&ram.image, write.address));
            let when = format!("{}{}", name(write.enable), within.unwrap_or_default());
            page.line(format!("always @(posedge clk) if ({when}) {memory}[{index}] <= {};", name(write.data)));
        }
        for (i, register) in self.body.graph.registers.iter().enumerate() {
            let state = register_name(RegisterId::new(i));
            let init = literal(register.init, register.width);
            let clear = register.clear.map(|id| format!("if ({}) {state} <= {init}; else ", name(id)));
            let enable = register.enable.map(|id| format!("if ({}) ", name(id)));
            let (clear, enable) = (clear.unwrap_or_default(), enable.unwrap_or_default());
            page.line(format!("always @(posedge clk) {clear}{enable}{state} <= {};", name(register.next)));
        }
    }

    /// Named values, those of a sub-scope inside a generate block of its name.
    fn signals(&self, page: &mut Page, signals: &[&InnerSignal], depth: usize) {
        let mut scopes: Vec<&str> = Vec::new();
        for signal in signals {
            let name = &signal.path[depth];
            if signal.path.len() > depth + 1 {
                if !scopes.contains(&name.as_str()) {
                    scopes.push(name);
                }
            } else {
                let sign = if signal.signed { "signed " } else { "" };
                let range = range(self.body.graph.width(signal.value));
                page.line(format!("wire {sign}{range}{name} = {};", self.expressions.name(signal.value)));
            }
        }
        for scope in scopes {
            let inside = signals.iter().filter(|signal| signal.path.len() > depth + 1 && signal.path[depth] == scope);
            let inside: Vec<_> = inside.copied().collect();
            page.block(format!("if (1) begin : {scope}"), "end", |page| self.signals(page, &inside, depth + 1));
        }
    }
}

fn memory(page: &mut Page, name: &str, image: &MemoryImage) {
    page.line(format!("reg {}{name} [0:{}];", range(image.width()), image.depth().saturating_sub(1)));
    page.block("initial begin", "end", |page| {
        for (address, &word) in image.words().iter().enumerate() {
            page.line(format!("{name}[{address}] = {};", literal(word, image.width())));
        }
    });
}
