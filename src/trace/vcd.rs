//! VCD files: the header through the `vcd` crate, the value-change lines by a fast path of our own.
//!
//! The crate writes one bit at a time through `core::fmt`, which costs several times what the simulation itself
//! costs. The tests hold our lines against the crate's, byte for byte.
//!
//! Facts about GTKWave 3.3.118 that shape the file: a vector without a range is shown wrongly, so every word wider
//! than one bit has `[msb:lsb]`; `b-5` is read as junk and a short vector is widened without its sign, so words are
//! written in full; the last change is invisible unless a time follows it.

use std::io::{self, Write};

use ::vcd::{IdCode, ReferenceIndex, TimescaleUnit, VarType, Writer};

use super::ascii::{put_bits, put_decimal};
use super::writer::WaveWriter;
use super::{Change, Format, Item, Plan, Slot, SlotId};
use crate::files::Out;

/// VCD.
pub(super) static FORMAT: Format =
    Format { ending: "vcd", begin: |out, plan| Ok(Box::new(VcdWriter::new(out, plan)?)) };

/// Bytes gathered before they are written.
const BUFFER: usize = 1 << 18;

/// Room for the longest line: `b`, 64 bits, and the tail.
const LINE: usize = 80;

/// Writes a trace as VCD: one tick is 1 ns, and the same trace gives the same bytes.
///
/// The header is written when the writer is made, so that a change before its declaration cannot be said.
#[derive(Debug)]
pub struct VcdWriter<W: Write> {
    out: W,
    lines: Vec<Line>,
    buffer: Box<[u8]>,
    filled: usize,
    /// The last tick seen.
    last: Option<u64>,
}

/// What the value-change line of a slot is made of.
#[derive(Clone, Copy, Debug)]
struct Line {
    width: u8,
    /// 1 for a vector, whose line starts with `b`.
    prefix: u8,
    tail_length: u8,
    /// The blank (of a vector), the identifier code, the newline.
    tail: [u8; 8],
}

impl Line {
    fn new(slot: Slot, id: IdCode) -> Self {
        let is_vector = slot.width > 1;
        let text = if is_vector { format!(" {id}\n") } else { format!("{id}\n") };
        let mut tail = [0; 8];
        // An identifier of a u32 has at most 5 of the 94 printable characters.
        tail[..text.len()].copy_from_slice(text.as_bytes());
        Self { width: slot.width as u8, prefix: u8::from(is_vector), tail_length: text.len() as u8, tail }
    }

    /// Writes the line and returns its length.
    #[inline]
    fn put(&self, out: &mut [u8; LINE], word: u64) -> usize {
        let start = usize::from(self.prefix);
        let end = start + usize::from(self.width);
        out[0] = b'b';
        put_bits(&mut out[start..start + 64], word, self.width.into());
        out[end..end + 8].copy_from_slice(&self.tail);
        end + usize::from(self.tail_length)
    }
}

fn id_code(slot: SlotId) -> IdCode {
    IdCode::from(slot.index() as u64)
}

impl<W: Write> VcdWriter<W> {
    /// Writes the header: scopes and signals of `plan` in its order, aliases under one identifier code, no date.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn new(mut out: W, plan: &Plan) -> io::Result<Self> {
        let mut header = Writer::new(&mut out);
        header.version("Stepwright")?;
        header.timescale(1, TimescaleUnit::NS)?;
        for item in plan.walk() {
            match item {
                Item::Open(name) => header.add_module(name)?,
                Item::Close => header.upscope()?,
                Item::Signal(signal, slot) => {
                    let range = (signal.width > 1).then(|| ReferenceIndex::Range(signal.width as i32 - 1, 0));
                    let name = signal.path.last().map_or("", String::as_str);
                    header.var_def(VarType::Wire, signal.width, id_code(slot), name, range)?;
                }
            }
        }
        header.enddefinitions()?;
        let slots = plan.slots().iter().enumerate();
        let lines = slots.map(|(i, slot)| Line::new(*slot, id_code(SlotId::new(i)))).collect();
        Ok(Self { out, lines, buffer: vec![0; BUFFER].into(), filled: 0, last: None })
    }

    /// Writes what changed at `tick`; the first call is the initial values. Ticks must increase.
    ///
    /// # Errors
    /// Those of the output.
    pub fn tick(&mut self, tick: u64, changes: &[Change]) -> io::Result<()> {
        let is_first = self.last.replace(tick).is_none();
        if is_first {
            self.time(tick)?;
            self.text(b"$dumpvars\n")?;
        } else if !changes.is_empty() {
            self.time(tick)?;
        }
        for change in changes {
            self.change(*change)?;
        }
        if is_first { self.text(b"$end\n") } else { Ok(()) }
    }

    /// Writes the time that closes the last tick, flushes, and gives the output back.
    ///
    /// # Errors
    /// Those of the output.
    pub fn finish(mut self) -> io::Result<W> {
        self.time(self.last.map_or(0, |tick| tick.saturating_add(1)))?;
        self.drain()?;
        self.out.flush()?;
        Ok(self.out)
    }

    #[inline]
    fn change(&mut self, change: Change) -> io::Result<()> {
        let line = self.lines[change.slot.index()];
        self.filled += line.put(self.room()?, change.word);
        Ok(())
    }

    fn time(&mut self, tick: u64) -> io::Result<()> {
        let mut digits = [0; 20];
        let start = put_decimal(&mut digits, tick);
        self.text(b"#")?;
        self.text(&digits[start..])?;
        self.text(b"\n")
    }

    /// Writes a text no longer than a line.
    fn text(&mut self, text: &[u8]) -> io::Result<()> {
        self.room()?[..text.len()].copy_from_slice(text);
        self.filled += text.len();
        Ok(())
    }

    /// Room for one line.
    #[inline]
    fn room(&mut self) -> io::Result<&mut [u8; LINE]> {
        if self.filled > BUFFER - LINE {
            self.drain()?;
        }
        Ok(self.buffer[self.filled..].first_chunk_mut().expect("a line's room was made above"))
    }

    #[cold]
    fn drain(&mut self) -> io::Result<()> {
        self.out.write_all(&self.buffer[..self.filled])?;
        self.filled = 0;
        Ok(())
    }
}

impl<'o> WaveWriter<'o> for VcdWriter<Box<dyn Out + 'o>> {
    fn tick(&mut self, tick: u64, changes: &[Change]) -> io::Result<()> {
        self.tick(tick, changes)
    }

    fn finish(self: Box<Self>) -> io::Result<Box<dyn Out + 'o>> {
        (*self).finish()
    }
}

#[cfg(test)]
#[path = "vcd_tests.rs"]
mod tests;
