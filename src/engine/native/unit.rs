//! The function of a shape: computes one unit after another, each with a record of its own.

use cranelift_codegen::ir::types::I64;
use cranelift_codegen::ir::{BlockArg, InstBuilder, MemFlagsData, Value};
use cranelift_frontend::FunctionBuilder;

use super::host::{Assembler, Records};
use super::memory::Area;
use super::ops::{Emitter, Outside};
use super::shape::{Shape, Site};
use super::word::{constant, machine_type};
use crate::base::{Diagnostic, Op, RamId, RomId, ValueId};

const FLAGS: MemFlagsData = MemFlagsData::trusted();

/// Compiles the function of a shape. Its records are those of the units, its count is how many there are.
pub(super) fn compile(assembler: &mut Assembler, shape: &Shape, record: usize) -> Result<usize, Diagnostic> {
    assembler.function(Records::Each(record), |b, arguments| emit(b, arguments, shape, record))
}

fn emit(b: &mut FunctionBuilder<'_>, [context, records, count]: [Value; 3], shape: &Shape, length: usize) -> Value {
    let areas = Area::ALL.map(|area| b.ins().load(I64, FLAGS, context, area.offset()));
    let (head, exit) = (b.create_block(), b.create_block());
    let (record, left) = (b.append_block_param(head, I64), b.append_block_param(head, I64));
    b.ins().jump(head, &[BlockArg::Value(records), BlockArg::Value(count)]);

    b.switch_to_block(head);
    let around = Around::new(b, shape, areas, record);
    emit_unit(b, shape, around);
    let following = b.ins().iadd_imm_u(record, (length * size_of::<u32>()) as i64);
    let fewer = b.ins().iadd_imm_s(left, -1);
    b.ins().brif(fewer, head, &[BlockArg::Value(following), BlockArg::Value(fewer)], exit, &[]);

    b.switch_to_block(exit);
    constant(b, I64, 0)
}

fn emit_unit(b: &mut FunctionBuilder<'_>, shape: &Shape, around: Around<'_>) {
    let graph = shape.graph();
    let mut emitter = Emitter::new(b, &graph, around);
    let mut stores = shape.stores.iter().peekable();
    for id in (0..shape.nodes.len()).map(ValueId::new) {
        if !graph.node(id).op.is_leaf() {
            emitter.emit(id);
        }
        while let Some((_, site)) = stores.next_if(|(value, _)| *value == id) {
            let value = emitter.clean(id);
            emitter.outside.store(emitter.b, Area::Wires, *site, value);
        }
    }
    for (register, q, site) in &shape.commits {
        let q = emitter.clean(*q);
        let next = emitter.committed(register, q);
        emitter.outside.store(emitter.b, Area::Next, *site, next);
    }
}

/// What stands around a unit: its group's own memory, and what it imports.
struct Around<'a> {
    shape: &'a Shape,
    areas: [Value; Area::COUNT],
    /// Where in each area the group's own part starts.
    own: [Value; Area::COUNT],
    record: Value,
}

impl<'a> Around<'a> {
    fn new(b: &mut FunctionBuilder<'_>, shape: &'a Shape, areas: [Value; Area::COUNT], record: Value) -> Self {
        let own = Area::ALL.map(|area| {
            let base = areas[area as usize];
            let Some(place) = record_place(area) else { return base };
            let offset = b.ins().uload32(FLAGS, record, place);
            b.ins().iadd(base, offset)
        });
        Self { shape, areas, own, record }
    }

    /// An address and an offset to add to it.
    fn place(&self, b: &mut FunctionBuilder<'_>, area: Area, site: Site) -> (Value, i32) {
        match site {
            Site::Own(offset) => (self.own[area as usize], offset as i32),
            Site::Imported(index) => {
                let offset = b.ins().uload32(FLAGS, self.record, 4 * index as i32);
                (b.ins().iadd(self.areas[area as usize], offset), 0)
            }
        }
    }

    fn store(&self, b: &mut FunctionBuilder<'_>, area: Area, site: Site, value: Value) {
        let (base, offset) = self.place(b, area, site);
        b.ins().store(FLAGS, value, base, offset);
    }
}

/// Where the head of a record tells the start of a group's own part of an area.
fn record_place(area: Area) -> Option<i32> {
    match area {
        Area::Now | Area::Next => Some(0),
        Area::Wires => Some(4),
        Area::Rams => Some(8),
        Area::Roms => None,
    }
}

impl Outside for Around<'_> {
    fn fetch(&mut self, b: &mut FunctionBuilder<'_>, id: ValueId, width: u32) -> Value {
        let Op::Input(input) = self.shape.nodes[id.index()].op else { unreachable!("only leaves are fetched") };
        let (area, site) = self.shape.outside[input as usize];
        let (base, offset) = self.place(b, area, site);
        b.ins().load(machine_type(width), FLAGS, base, offset)
    }

    fn rom(&mut self, b: &mut FunctionBuilder<'_>, id: RomId) -> (Value, usize) {
        let (place, depth) = self.shape.roms[id.index()];
        (b.ins().iadd_imm_u(self.areas[Area::Roms as usize], i64::from(place)), depth)
    }

    fn ram(&mut self, b: &mut FunctionBuilder<'_>, id: RamId) -> (Value, usize) {
        let (site, depth) = self.shape.rams[id.index()];
        let (base, offset) = self.place(b, Area::Rams, site);
        (b.ins().iadd_imm_u(base, i64::from(offset)), depth)
    }
}
