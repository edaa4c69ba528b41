//! The memory that generated code works on: where each register, wire and memory word stands.

use std::collections::HashMap;

use super::word::machine_type;
use crate::base::{MemoryImage, Op, Rom, ValueId};
use crate::compile::Program;

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
        for (word, place) in image.words().zip((offset..).step_by(element_size(image))) {
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

/// Hands out places one after another.
#[derive(Default)]
struct Allocator {
    size: u32,
}

impl Allocator {
    fn take(&mut self, bytes: u32) -> u32 {
        self.align();
        let place = self.size;
        self.size += bytes;
        place
    }

    fn word(&mut self, width: u32) -> u32 {
        let bytes = machine_type(width).bytes();
        let place = self.size.next_multiple_of(bytes);
        self.size = place + bytes;
        place
    }

    fn align(&mut self) {
        self.size = self.size.next_multiple_of(8);
    }
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
    /// By ROM. Its words are followed by a zero. ROMs of equal content share a place.
    pub roms: Vec<u32>,
    /// By value: where to read it.
    places: Vec<Option<Place>>,
    sizes: [u32; 4],
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
    pub fn new(program: &Program, group: &[u32], stored: impl Fn(ValueId) -> bool) -> Self {
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
                    Op::Register(register) => layout.registers[register.index()] = state.word(node.width),
                    Op::RamRead(ram, _) if ram_places[ram.index()].is_none() => {
                        let image = &graph.rams[ram.index()].image;
                        let size = (image.depth() + 2) * element_size(image);
                        ram_places[ram.index()] = Some(rams.take(size as u32));
                        layout.ram_homes[ram.index()] = home;
                    }
                    _ => {}
                }
                if stored(id) || matches!(node.op, Op::Input(_)) {
                    layout.wires.insert(id, wires.word(node.width));
                }
            }
        }
        layout.rams = ram_places.into_iter().map(Option::unwrap_or_default).collect();
        let roms = layout.place_roms(&graph.roms);
        layout.sizes = [state.size, wires.size, rams.size, roms];
        layout.places = (0..graph.nodes.len()).map(|index| layout.find(program, ValueId::new(index))).collect();
        layout
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

    fn place_roms(&mut self, roms: &[Rom]) -> u32 {
        let mut known = HashMap::new();
        let mut allocator = Allocator::default();
        for rom in roms {
            let size = (rom.image.depth() + 1) * element_size(&rom.image);
            self.roms.push(*known.entry(rom).or_insert_with(|| allocator.take(size as u32)));
        }
        allocator.size
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
        let [state, wires, rams, roms] = layout.sizes.map(Bytes::new);
        let mut memory = Memory { now: state, next: Bytes::new(layout.sizes[0]), wires, rams, roms };
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
                let place = place + address as u32 * element_size(&ram.image) as u32;
                self.rams.write(place, ram.image.width(), data);
            }
        }
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
