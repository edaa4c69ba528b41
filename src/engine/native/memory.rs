//! The memory that generated code works on: where each register, wire and memory word stands.

use std::collections::HashMap;
use std::sync::Arc;

use super::word::machine_type;
use crate::base::{Diagnostic, MemoryImage, Op, Rom, ValueId};
use crate::compile::Program;
use crate::engine::Interpreter;

/// An area of the memory, as a place in what generated code is given.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(super) enum Area {
    /// State of the present tick.
    Now,
    /// State of the next tick.
    Next,
    /// Inputs, observed values, values that pass from one function to another.
    Wires,
    /// Words of the writable memories.
    Rams,
    /// Words of the read-only memories.
    Roms,
}

impl Area {
    /// All, in order.
    pub const ALL: [Area; Self::COUNT] = [Area::Now, Area::Next, Area::Wires, Area::Rams, Area::Roms];
    /// How many there are.
    pub const COUNT: usize = 5;

    /// Where its address stands in what generated code is given.
    pub fn offset(self) -> i32 {
        self as i32 * size_of::<*mut u8>() as i32
    }
}

/// Bytes that generated code reads and writes in the machine's own order, aligned for 64-bit words.
#[derive(Debug)]
pub(super) struct Bytes(Vec<u64>);

impl Bytes {
    fn new(size: u32) -> Self {
        Self(vec![0; size as usize / 8 + 1])
    }

    pub fn pointer(&mut self) -> *mut u8 {
        self.0.as_mut_ptr().cast()
    }

    pub fn as_bytes(&self) -> &[u8] {
        bytemuck::cast_slice(&self.0)
    }

    fn read(&self, spot: Spot) -> u64 {
        let bytes = &self.as_bytes()[spot.offset as usize..];
        match spot.bytes {
            1 => bytes[0].into(),
            4 => u32::from_ne_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]).into(),
            _ => self.0[spot.offset as usize / 8],
        }
    }

    /// Puts a word of `width` bits at `offset`.
    pub fn write(&mut self, offset: u32, width: u32, word: u64) {
        let whole = &mut self.0[offset as usize / 8];
        let mut bytes = whole.to_ne_bytes();
        let at = offset as usize % 8;
        match machine_type(width).bytes() {
            1 => bytes[at] = word as u8,
            4 => bytes[at..at + 4].copy_from_slice(&(word as u32).to_ne_bytes()),
            _ => bytes = word.to_ne_bytes(),
        }
        *whole = u64::from_ne_bytes(bytes);
    }

    /// Puts the words of an image at `offset`; what follows is left as it is.
    fn fill(&mut self, offset: u32, image: &MemoryImage) {
        for (&word, place) in image.words().iter().zip((offset..).step_by(element_size(image))) {
            self.write(place, image.width(), word);
        }
    }
}

/// Where a word stands in [`Bytes`].
#[derive(Clone, Copy, Debug)]
pub(super) struct Spot {
    pub offset: u32,
    pub bytes: u32,
}

impl Spot {
    /// The word of `width` bits at `offset`.
    fn new(offset: u32, width: u32) -> Self {
        Self { offset, bytes: machine_type(width).bytes() }
    }
}

fn element_size(image: &MemoryImage) -> usize {
    machine_type(image.width()).bytes() as usize
}

/// Bytes of an area at most: generated code adds offsets of 31 bits to its start.
const MOST_BYTES: u32 = i32::MAX as u32 - 7;

/// Hands out places one after another.
#[derive(Default)]
struct Allocator {
    size: u32,
}

impl Allocator {
    /// A place for the words of an image and so many more.
    fn image(&mut self, image: &MemoryImage, more: usize) -> Result<u32, Diagnostic> {
        self.align();
        self.take(self.size, (image.depth() + more).saturating_mul(element_size(image)))
    }

    fn word(&mut self, width: u32) -> Result<u32, Diagnostic> {
        let bytes = machine_type(width).bytes();
        self.take(self.size.next_multiple_of(bytes), bytes as usize)
    }

    fn take(&mut self, place: u32, bytes: usize) -> Result<u32, Diagnostic> {
        let end = u32::try_from(bytes).ok().and_then(|bytes| place.checked_add(bytes));
        self.size = end.filter(|end| *end <= MOST_BYTES).ok_or_else(too_large)?;
        Ok(place)
    }

    fn align(&mut self) {
        self.size = self.size.next_multiple_of(8);
    }
}

fn too_large() -> Diagnostic {
    let message =
        format!("the circuit's words or memories take more than {} MiB as machine code has them", MOST_BYTES >> 20);
    Diagnostic::new("E004", message).help("run with `--engine interpreter`, or make the circuit's memories smaller")
}

/// Where one group of ops (a module instance that shares its code, or all the rest) keeps what is its own.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub(super) struct Home {
    pub state: u32,
    pub wires: u32,
    pub rams: u32,
}

/// Offsets in bytes of everything that has a place. Registers have one in each of two copies of the state: the
/// present tick's and the next one's.
#[derive(Default, Debug)]
pub(super) struct Layout {
    pub homes: Vec<Home>,
    /// By register.
    pub registers: Vec<u32>,
    /// By value: inputs, and ops that are observed or read by other code.
    pub wires: HashMap<ValueId, u32>,
    /// By RAM. Its words are followed by a zero for reads beyond the depth, and by one that takes lost writes.
    pub rams: Vec<u32>,
    /// By RAM: the group in whose part it stands.
    pub ram_homes: Vec<u32>,
    /// By ROM. Its words are followed by a zero. ROMs that share their words share a place.
    pub roms: Vec<u32>,
    /// By value: where to read it.
    places: Vec<Option<Place>>,
    /// Bytes of each area.
    sizes: [u32; Area::COUNT],
}

/// Where a value is read.
#[derive(Clone, Copy, Debug)]
pub(super) enum Place {
    Constant(u64),
    State(Spot),
    Wire(Spot),
}

impl Layout {
    /// Lays out the values `stored` and all state; `group` tells whose each node is.
    ///
    /// # Errors
    /// `E004` when an area is larger than an offset reaches.
    pub fn new(program: &Program, group: &[u32], stored: impl Fn(ValueId) -> bool) -> Result<Self, Diagnostic> {
        let graph = &program.graph;
        let groups = group.iter().max().map_or(1, |&last| last as usize + 1);
        let mut members = vec![Vec::new(); groups];
        for (index, &group) in group.iter().enumerate() {
            members[group as usize].push(ValueId::new(index));
        }
        let (registers, ram_homes) = (vec![0; graph.registers.len()], vec![0; graph.rams.len()]);
        let mut layout = Layout { registers, ram_homes, ..Layout::default() };
        let mut ram_places = vec![None; graph.rams.len()];
        let (mut state, mut wires, mut rams) = (Allocator::default(), Allocator::default(), Allocator::default());
        for (home, members) in (0..).zip(&members) {
            [&mut state, &mut wires, &mut rams].into_iter().for_each(Allocator::align);
            layout.homes.push(Home { state: state.size, wires: wires.size, rams: rams.size });
            for &id in members {
                let node = graph.node(id);
                match node.op {
                    Op::Register(register) => layout.registers[register.index()] = state.word(node.width)?,
                    Op::RamRead(ram, _) if ram_places[ram.index()].is_none() => {
                        ram_places[ram.index()] = Some(rams.image(&graph.rams[ram.index()].image, 2)?);
                        layout.ram_homes[ram.index()] = home;
                    }
                    _ => {}
                }
                if stored(id) || matches!(node.op, Op::Input(_)) {
                    layout.wires.insert(id, wires.word(node.width)?);
                }
            }
        }
        layout.rams = ram_places.into_iter().map(Option::unwrap_or_default).collect();
        let roms = layout.place_roms(&graph.roms)?;
        layout.sizes = [state.size, state.size, wires.size, rams.size, roms];
        layout.places = (0..graph.nodes.len()).map(|index| layout.find(program, ValueId::new(index))).collect();
        Ok(layout)
    }

    /// Bytes of an area.
    pub fn size(&self, area: Area) -> usize {
        self.sizes[area as usize] as usize
    }

    /// Where an observed value is read.
    pub fn place(&self, id: ValueId) -> Place {
        self.places[id.index()].expect("only observed values can be read")
    }

    fn find(&self, program: &Program, id: ValueId) -> Option<Place> {
        let node = program.graph.node(id);
        match node.op {
            Op::Const(value) => Some(Place::Constant(value)),
            Op::Register(register) => Some(Place::State(Spot::new(self.registers[register.index()], node.width))),
            _ => self.wires.get(&id).map(|&offset| Place::Wire(Spot::new(offset, node.width))),
        }
    }

    fn place_roms(&mut self, roms: &[Rom]) -> Result<u32, Diagnostic> {
        let mut known = HashMap::new();
        let mut allocator = Allocator::default();
        for Rom { image } in roms {
            let place = match known.get(&image.words().as_ptr()) {
                Some(&place) => place,
                None => allocator.image(image, 1)?,
            };
            known.insert(image.words().as_ptr(), place);
            self.roms.push(place);
        }
        Ok(allocator.size)
    }
}

/// The memory itself.
#[derive(Debug)]
pub(super) struct Memory {
    /// The state of the present tick.
    pub now: Bytes,
    /// The state of the next tick.
    pub next: Bytes,
    pub wires: Bytes,
    pub rams: Bytes,
    pub roms: Bytes,
}

impl Memory {
    /// The memory at power-on.
    pub fn new(program: &Program, layout: &Layout) -> Self {
        let [now, next, wires, rams, roms] = layout.sizes.map(Bytes::new);
        let mut memory = Memory { now, next, wires, rams, roms };
        let graph = &program.graph;
        for (register, &place) in graph.registers.iter().zip(&layout.registers) {
            memory.now.write(place, register.width, register.init);
        }
        for (ram, &place) in graph.rams.iter().zip(&layout.rams) {
            memory.rams.fill(place, &ram.image);
        }
        for (rom, &place) in graph.roms.iter().zip(&layout.roms) {
            memory.roms.fill(place, &rom.image);
        }
        memory
    }

    /// The areas, in the order of [`Area`].
    pub fn areas(&mut self) -> [&mut Bytes; Area::COUNT] {
        [&mut self.now, &mut self.next, &mut self.wires, &mut self.rams, &mut self.roms]
    }

    /// Ends the tick: writes memories and makes the next state the present one.
    pub fn commit(&mut self, program: &Program, layout: &Layout) {
        self.write_rams(program, layout);
        std::mem::swap(&mut self.now, &mut self.next);
    }

    fn write_rams(&mut self, program: &Program, layout: &Layout) {
        for (ram, &place) in program.graph.rams.iter().zip(&layout.rams) {
            let read = |id| self.value(layout, id);
            let (enable, address, data) = (read(ram.write.enable), read(ram.write.address), read(ram.write.data));
            let depth = ram.image.depth() as u64;
            if enable != 0 && address < depth {
                // Within the area, all of which an offset reaches.
                let place = place + address as u32 * element_size(&ram.image) as u32;
                self.rams.write(place, ram.image.width(), data);
            }
        }
    }

    /// An interpreter that stands where this memory does.
    pub fn twin(&self, program: &Arc<Program>, layout: &Layout, inputs: &[u64]) -> Interpreter {
        let registers = program.graph.registers.iter().zip(&layout.registers);
        let registers = registers.map(|(register, &place)| self.now.read(Spot::new(place, register.width)));
        let rams = program.graph.rams.iter().zip(&layout.rams).map(|(ram, &place)| {
            let places = (place..).step_by(element_size(&ram.image)).take(ram.image.depth());
            places.map(|place| self.rams.read(Spot::new(place, ram.image.width()))).collect()
        });
        Interpreter::standing(Arc::clone(program), inputs.to_vec(), registers.collect(), rams.collect())
    }

    /// A value that has a place, or a constant.
    pub fn value(&self, layout: &Layout, id: ValueId) -> u64 {
        match layout.place(id) {
            Place::Constant(value) => value,
            Place::State(spot) => self.now.read(spot),
            Place::Wire(spot) => self.wires.read(spot),
        }
    }
}

#[cfg(all(test, feature = "lanes"))]
mod tests {
    use super::*;
    use crate::engine::lanes::tests::many_rams;

    #[test]
    fn an_area_that_no_offset_reaches_is_refused_before_its_memory_is_taken() {
        let layout = |rams| {
            let program = many_rams(rams);
            Layout::new(&program, &vec![0; program.graph.nodes.len()], |_| true)
        };
        // 4098 words of four bytes each: the offsets of 131,008 end below 2^31.
        assert_eq!(layout(131_008).expect("just fits").size(Area::Rams), 131_008 * 4 * 4098);
        assert_eq!(layout(131_009).expect_err("too large").code, "E004");
    }
}
