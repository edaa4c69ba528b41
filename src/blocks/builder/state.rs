//! State of a block under construction: memories and registers.

use super::Builder;
use crate::base::word::mask;
use crate::base::{MemoryImage, MemoryWrite, Op, Ram, RamId, Register, RegisterId, Rom, RomId, ValueId};

/// A register that has been declared and still wants its inputs: its content can be read before they exist.
#[derive(Clone, Copy, Debug)]
#[must_use = "a register without inputs never changes: give it to Builder::load"]
pub struct Held {
    id: RegisterId,
    /// The content.
    pub q: ValueId,
}

impl Builder {
    /// The word of a read-only memory at `address`; 0 beyond its depth.
    pub fn rom(&mut self, image: MemoryImage, address: ValueId) -> ValueId {
        let width = image.width();
        self.body.graph.roms.push(Rom { image });
        let rom = RomId::new(self.body.graph.roms.len() - 1);
        self.push(Op::RomRead(rom, address), width)
    }

    /// The present word at `read` of a writable memory with one write port; 0 beyond its depth.
    pub fn ram(&mut self, image: MemoryImage, write: MemoryWrite, read: ValueId) -> ValueId {
        self.bit_wide(write.enable);
        let width = image.width();
        if self.width(write.data) != width {
            self.fail(format!("a memory of {width} bits is written {} bits", self.width(write.data)));
        }
        self.body.graph.rams.push(Ram { image, write });
        let ram = RamId::new(self.body.graph.rams.len() - 1);
        self.push(Op::RamRead(ram, read), width)
    }

    /// Declares a register with its power-on content, cut to `width` bits.
    pub fn hold(&mut self, width: u32, init: u64) -> Held {
        let id = RegisterId::new(self.body.graph.registers.len());
        let width = self.fitting(width.into());
        let q = self.push(Op::Register(id), width);
        self.body.graph.registers.push(Register {
            width,
            init: init & mask(width),
            next: q,
            enable: None,
            clear: None,
        });
        Held { id, q }
    }

    /// Gives a register its inputs: `q(t+1) = clear ? init : enable ? next : q`. Returns the content.
    pub fn load(
        &mut self,
        held: Held,
        next: ValueId,
        enable: impl Into<Option<ValueId>>,
        clear: impl Into<Option<ValueId>>,
    ) -> ValueId {
        self.same_width(held.q, next);
        let (enable, clear) = (enable.into(), clear.into());
        for control in [enable, clear].into_iter().flatten() {
            self.bit_wide(control);
        }
        let register = &mut self.body.graph.registers[held.id.index()];
        (register.next, register.enable, register.clear) = (next, enable, clear);
        held.q
    }

    /// 1 in the tick in which a line has gone high; a line that is high at power-on has.
    pub fn rises(&mut self, line: ValueId) -> ValueId {
        let was = self.delay(line);
        let was_low = self.not(was);
        self.and(line, was_low)
    }

    /// 1 in the tick in which a line has gone low.
    pub fn falls(&mut self, line: ValueId) -> ValueId {
        let was = self.delay(line);
        let low = self.not(line);
        self.and(was, low)
    }

    /// A word one tick later, 0 at power-on.
    pub fn delay(&mut self, a: ValueId) -> ValueId {
        let held = self.hold(self.width(a), 0);
        self.load(held, a, None, None)
    }
}
