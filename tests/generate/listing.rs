//! A graph as text, for failure messages.

use std::fmt::Write;

use stepwright::base::{Graph, Op};

/// Every value, register and memory on a line of its own.
pub fn listing(graph: &Graph) -> String {
    let mut text = String::new();
    for (i, node) in graph.nodes.iter().enumerate() {
        let mut operands = String::new();
        node.op.operands(|id| write!(operands, " v{}:{}", id.index(), graph.width(id)).expect("a string"));
        let name = format!("{:?}", node.op);
        let name = name.split('(').next().unwrap_or_default();
        let detail = match node.op {
            Op::Const(value) => format!(" {value:#x}"),
            Op::Input(i) => format!(" {i}"),
            Op::Slice(_, low) => format!(" from {low}"),
            Op::Register(id) => format!(" {}", id.index()),
            Op::RomRead(id, _) => format!(" rom{}", id.index()),
            Op::RamRead(id, _) => format!(" ram{}", id.index()),
            _ => String::new(),
        };
        writeln!(text, "v{i}:{} = {name}{operands}{detail}", node.width).expect("a string");
    }
    for (i, r) in graph.registers.iter().enumerate() {
        let control =
            |id: Option<_>| id.map_or("-".to_owned(), |id: stepwright::base::ValueId| format!("v{}", id.index()));
        let (enable, clear) = (control(r.enable), control(r.clear));
        let (next, init) = (r.next.index(), r.init);
        writeln!(text, "register {i}: init {init:#x} next v{next} enable {enable} clear {clear}").expect("a string");
    }
    for (i, rom) in graph.roms.iter().enumerate() {
        writeln!(text, "rom{i}: {:x?}", rom.image.words()).expect("a string");
    }
    for (i, ram) in graph.rams.iter().enumerate() {
        let [enable, address, data] = [ram.write.enable, ram.write.address, ram.write.data].map(|id| id.index());
        let words = ram.image.words();
        writeln!(text, "ram{i}: {words:x?} write v{enable} at v{address} data v{data}").expect("a string");
    }
    text
}
