//! Random circuits of several modules inside one another: instances in loops, chained, with memories among their blocks.

use proptest::prelude::*;
use stepwright::blocks::{Kind, REGISTRY};

use super::circuits::{Choice, Draft, Writer, drafts, module};

/// A module, and what it does with the one before.
#[derive(Clone, Debug)]
pub struct Part {
    /// Its own cells.
    draft: Draft,
    /// One more cell: which memory.
    memory: Choice,
    /// How many instances of the module before it has.
    turns: usize,
    /// What the inputs of these are, and its own output.
    wires: [u64; 4],
}

/// Modules, each of which has instances of the one before; the last one is `random`.
pub fn composites() -> impl Strategy<Value = Vec<Part>> {
    let memory = (any::<u16>(), any::<[u32; 6]>(), any::<[u64; 8]>());
    let part = (drafts(8), memory, 1..4_usize, any::<[u64; 4]>()).prop_map(|(draft, memory, turns, wires)| {
        let (kind, parameters, inputs) = memory;
        Part { draft, memory: Choice { kind: a_memory(kind), parameters, inputs }, turns, wires }
    });
    prop::collection::vec(part, 2..5)
}

/// The number of a cell that is a memory.
fn a_memory(choice: u16) -> u16 {
    let memories = (0..REGISTRY.len()).filter(|&i| REGISTRY[i].description().kind == Kind::Memory);
    let memories: Vec<_> = memories.collect();
    (REGISTRY.len() + memories[usize::from(choice) % memories.len()]) as u16
}

/// The text of all modules.
pub fn write(parts: &[Part]) -> String {
    let name = |at: usize| if at + 1 == parts.len() { "random".to_owned() } else { format!("part_{at}") };
    let text = parts.iter().enumerate().map(|(at, part)| {
        module(&name(at), ",\n    output wire [15:0] out", &part.draft, |writer| {
            writer.cell(part.draft.cells.len(), &part.memory);
            if let Some(before) = at.checked_sub(1) {
                loop_of(writer, &name(before), &parts[before].draft, part);
            }
            writer.line(format!("assign out = {};", writer.expression(part.wires[3], 16)));
        })
    });
    text.collect()
}

/// Instances of a module in a loop: the first of its inputs that is one bit wide is driven by the instance before.
fn loop_of(writer: &mut Writer, inner: &str, draft: &Draft, part: &Part) {
    let turns = part.turns;
    let first = writer.expression(part.wires[0], 1);
    let chained = draft.inputs.iter().position(|&width| width == 1);
    let inputs = draft.inputs.iter().enumerate().map(|(i, &width)| {
        let word = match chained {
            Some(bit) if bit == i => "chain[i]".to_owned(),
            _ => writer.expression(part.wires[1].rotate_left(9 * i as u32), width),
        };
        format!(", .in_{i}({word})")
    });
    let inputs: String = inputs.collect();
    writer.line("genvar i;".to_owned());
    writer.declare("chain".to_owned(), turns as u32 + 1);
    writer.line(format!("assign chain[0] = {first};"));
    writer.line(format!("generate for (i = 0; i < {turns}; i = i + 1) begin : turn"));
    writer.line("    wire [15:0] word;".to_owned());
    writer.line(format!("    {inner} inner (.clk(clk){inputs}, .out(word));"));
    writer.line("    xor fold (chain[i+1], chain[i], word[5 * i % 16]);".to_owned());
    writer.line("end endgenerate".to_owned());
}
