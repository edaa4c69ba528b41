//! The few x86-64 instructions that planes need, as bytes: 256-bit ones (VEX, AVX2) and 512-bit ones (EVEX, AVX-512F).
//!
//! See the Intel 64 and IA-32 Architectures Software Developer's Manual, volume 2, 2.3 and 2.7. No assembler crate at hand knows EVEX.

use super::segment::Place;

/// Planes of a region that a displacement of 31 bits reaches, with room to spare.
const MOST_PLANES: u32 = 1 << 24;

/// Which vectors.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Vectors {
    Avx2,
    Avx512,
}

impl Vectors {
    /// Bytes of a register, which is a plane.
    pub(super) fn bytes(self) -> usize {
        match self {
            Vectors::Avx2 => 32,
            Vectors::Avx512 => 64,
        }
    }

    pub(super) fn registers(self) -> usize {
        match self {
            Vectors::Avx2 => 16,
            Vectors::Avx512 => 32,
        }
    }
}

/// A register or memory operand.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Operand {
    Register(u8),
    Memory(Place),
}

/// An opcode with its map (1: `0F`, 3: `0F3A`) and prefix (1: `66`, 2: `F3`).
#[derive(Clone, Copy, Debug)]
pub(super) struct Opcode {
    map: u8,
    prefix: u8,
    code: u8,
}

impl Opcode {
    pub(super) const LOAD: Self = Self { map: 1, prefix: 2, code: 0x6F };
    pub(super) const STORE: Self = Self { map: 1, prefix: 2, code: 0x7F };
    pub(super) const AND: Self = Self { map: 1, prefix: 1, code: 0xDB };
    pub(super) const AND_NOT: Self = Self { map: 1, prefix: 1, code: 0xDF };
    pub(super) const OR: Self = Self { map: 1, prefix: 1, code: 0xEB };
    pub(super) const XOR: Self = Self { map: 1, prefix: 1, code: 0xEF };
    /// Followed by the table.
    pub(super) const TERNARY: Self = Self { map: 3, prefix: 1, code: 0x25 };
}

/// How many planes of each region the code touches: what the memory it is given must have.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub(super) struct Extent {
    pub(super) fixed: usize,
    /// Of the present state, which the next one's buffer must have too: they change places at every tick.
    pub(super) state: usize,
    /// Of one tick of history.
    pub(super) history: usize,
}

/// Machine code under construction.
#[derive(Debug)]
pub(super) struct Encoder {
    vectors: Vectors,
    bytes: Vec<u8>,
    extent: Extent,
    /// Whether a plane is beyond the reach of a displacement.
    too_far: bool,
}

impl Encoder {
    pub(super) fn new(vectors: Vectors) -> Self {
        Self { vectors, bytes: Vec::new(), extent: Extent::default(), too_far: false }
    }

    /// `register = first op second`; a move has no first operand, that is 0.
    pub(super) fn instruction(&mut self, opcode: Opcode, register: u8, first: u8, second: Operand) {
        let (low, high) = match second {
            Operand::Register(rm) => (!rm >> 3 & 1, !rm >> 4 & 1),
            Operand::Memory(_) => (1, 1),
        };
        let reg = (!register >> 3 & 1, !register >> 4 & 1);
        match self.vectors {
            Vectors::Avx2 => self.bytes.extend([
                0xC4,
                reg.0 << 7 | 1 << 6 | low << 5 | opcode.map,
                (!first & 15) << 3 | 1 << 2 | opcode.prefix,
                opcode.code,
            ]),
            Vectors::Avx512 => self.bytes.extend([
                0x62,
                reg.0 << 7 | high << 6 | low << 5 | reg.1 << 4 | opcode.map,
                1 << 7 | (!first & 15) << 3 | 1 << 2 | opcode.prefix,
                0b10 << 5 | (!first >> 4 & 1) << 3,
                opcode.code,
            ]),
        }
        let middle = (register & 7) << 3;
        match second {
            Operand::Register(rm) => self.bytes.push(0xC0 | middle | rm & 7),
            Operand::Memory(place) => self.memory(middle, place),
        }
    }

    /// A register that is combined with itself and two others by a table.
    pub(super) fn ternary(&mut self, register: u8, second: u8, third: Operand, table: u8) {
        self.instruction(Opcode::TERNARY, register, second, third);
        self.bytes.push(table);
    }

    /// The fixed planes are at `rdi`, the present state at `rsi`, the next at `rdx`, the history at `rcx`.
    fn memory(&mut self, middle: u8, place: Place) {
        let (base, plane, extent) = match place {
            Place::Fixed(plane) => (7, plane, &mut self.extent.fixed),
            Place::Now(plane) => (6, plane, &mut self.extent.state),
            Place::Next(plane) => (2, plane, &mut self.extent.state),
            Place::History(plane) => (1, plane, &mut self.extent.history),
        };
        self.too_far |= plane >= MOST_PLANES;
        let plane = plane.min(MOST_PLANES - 1);
        *extent = (*extent).max(plane as usize + 1);
        // EVEX displacements of one byte count in registers, VEX ones in bytes, where they hardly ever fit.
        match i8::try_from(plane) {
            Ok(short) if self.vectors == Vectors::Avx512 => self.bytes.extend([0x40 | middle | base, short as u8]),
            _ => {
                self.bytes.push(0x80 | middle | base);
                let bytes = plane * self.vectors.bytes() as u32;
                self.bytes.extend(bytes.to_le_bytes());
            }
        }
    }

    /// Makes what has been encoded the body of a loop that runs `r8` times, moves on by `history` planes each time and
    /// lets the states change places, and returns. `None` when a plane or the start of the loop is too far away for the
    /// 31 bits that an instruction has for it.
    pub(super) fn finish(mut self, history: u32) -> Option<Finished> {
        if self.too_far || history >= MOST_PLANES {
            return None;
        }
        let stride = history * self.vectors.bytes() as u32;
        let history = history as usize;
        self.extent.history = self.extent.history.max(history);
        self.bytes.extend([0x48, 0x81, 0xC1]); // add rcx, stride
        self.bytes.extend(stride.to_le_bytes());
        self.bytes.extend([0x48, 0x87, 0xD6]); // xchg rsi, rdx
        self.bytes.extend([0x49, 0xFF, 0xC8]); // dec r8
        self.bytes.extend([0x0F, 0x85]); // jnz body
        let back = i32::try_from(self.bytes.len() + 4).ok()?;
        self.bytes.extend((-back).to_le_bytes());
        self.bytes.extend([0xC5, 0xF8, 0x77, 0xC3]); // vzeroupper; ret
        Some(Finished { vectors: self.vectors, bytes: self.bytes, extent: self.extent, stride: history })
    }
}

/// Machine code, and what it touches. Only an [`Encoder`] makes one, so that the two agree.
#[derive(Debug)]
pub(super) struct Finished {
    vectors: Vectors,
    bytes: Vec<u8>,
    extent: Extent,
    stride: usize,
}

impl Finished {
    pub(super) fn vectors(&self) -> Vectors {
        self.vectors
    }

    pub(super) fn bytes(&self) -> &[u8] {
        &self.bytes
    }

    pub(super) fn extent(&self) -> Extent {
        self.extent
    }

    /// Planes of history from one tick to the next.
    pub(super) fn stride(&self) -> usize {
        self.stride
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_plane_beyond_the_reach_of_an_instruction_makes_no_code() {
        let code = |plane, history| {
            let mut encoder = Encoder::new(Vectors::Avx2);
            encoder.instruction(Opcode::LOAD, 0, 0, Operand::Memory(Place::Fixed(plane)));
            encoder.finish(history)
        };
        assert!(code(MOST_PLANES - 1, MOST_PLANES - 1).is_some());
        assert!(code(MOST_PLANES, 0).is_none());
        assert!(code(0, MOST_PLANES).is_none());
    }
}
