//! FST files, GTKWave's compressed format, through `fst-writer`: the same signals and values as the VCD.

use std::io::{self, Seek, Write};

use fst_writer::{
    FstBodyWriter, FstFileType, FstHeaderWriter, FstInfo, FstScopeType, FstSignalId, FstSignalType, FstVarDirection,
    FstVarType, FstWriteError,
};

use super::ascii::put_bits;
use super::writer::WaveWriter;
use super::{Change, Format, Item, Plan};
use crate::files::{Out, seekable};

/// FST.
pub(super) static FORMAT: Format =
    Format { ending: "fst", begin: |out, plan| Ok(Box::new(FstWriter::new(seekable(out)?, plan)?)) };

/// Bytes of changes that make a block. The writer walks each signal's changes backwards when it closes a block, which
/// is fast only while they are in the cache.
const BLOCK: usize = 1 << 20;

/// The longest name that readers of the format make room for, in bytes.
const LONGEST_NAME: usize = 511;

/// Writes a trace as FST: one tick is 1 ns, no date.
///
/// The header is written when the writer is made, so that a change before its declaration cannot be said.
pub struct FstWriter<W: Write + Seek> {
    body: FstBodyWriter<W>,
    signals: Vec<(FstSignalId, u32)>,
    /// The last tick seen.
    last: Option<u64>,
}

impl<W: Write + Seek> FstWriter<W> {
    /// Writes scopes and signals of `plan` in its order; aliases share their changes.
    ///
    /// # Errors
    /// Those of `out`; a name of more than 511 bytes, which readers of the format cannot hold.
    pub fn new(out: W, plan: &Plan) -> io::Result<Self> {
        let info = FstInfo {
            start_time: 0,
            timescale_exponent: -9,
            version: "Stepwright".to_owned(),
            date: String::new(),
            file_type: FstFileType::Verilog,
        };
        let mut header = FstHeaderWriter::new(out, &info).map_err(error)?;
        let mut ids = vec![None; plan.slots().len()];
        for item in plan.walk() {
            match item {
                Item::Open(name) => header.scope(fitting(name)?, "", FstScopeType::Module).map_err(error)?,
                Item::Close => header.up_scope().map_err(error)?,
                Item::Signal(signal, slot) => {
                    let name = signal.path.last().map_or("", String::as_str);
                    let kind = FstSignalType::bit_vec(signal.width);
                    let name = fitting(&ranged(name, signal.width))?.to_owned();
                    let (wire, implicit) = (FstVarType::Wire, FstVarDirection::Implicit);
                    let id = &mut ids[slot.index()];
                    *id = Some(header.var(name, kind, wire, implicit, *id).map_err(error)?);
                }
            }
        }
        let signals = ids.into_iter().zip(plan.slots()).filter_map(|(id, slot)| Some((id?, slot.width))).collect();
        let mut body = header.finish().map_err(error)?;
        // The sampler yields only changes.
        body.set_deduplicate(false);
        Ok(Self { body, signals, last: None })
    }

    /// Writes what changed at `tick`; the first call is the initial values. Ticks must increase.
    ///
    /// # Errors
    /// Those of the output.
    pub fn tick(&mut self, tick: u64, changes: &[Change]) -> io::Result<()> {
        let is_first = self.last.replace(tick).is_none();
        if changes.is_empty() {
            return Ok(());
        }
        if self.body.size() > BLOCK && !is_first {
            // The format allows a block to end only where a new time begins.
            self.body.flush().map_err(error)?;
        }
        self.body.time_change(tick).map_err(error)?;
        let mut bits = [0; 64];
        for change in changes {
            let (id, width) = self.signals[change.slot.index()];
            put_bits(&mut bits, change.word, width);
            self.body.signal_change(id, &bits[..width as usize]).map_err(error)?;
        }
        Ok(())
    }

    /// Writes the time that closes the last tick and gives the output back.
    ///
    /// # Errors
    /// Those of the output.
    pub fn finish(mut self) -> io::Result<W> {
        self.body.time_change(self.last.map_or(0, |tick| tick.saturating_add(1))).map_err(error)?;
        let mut out = self.body.finish().map_err(error)?;
        out.flush()?;
        Ok(out)
    }
}

impl<'o> WaveWriter<'o> for FstWriter<Box<dyn Out + 'o>> {
    fn tick(&mut self, tick: u64, changes: &[Change]) -> io::Result<()> {
        self.tick(tick, changes)
    }

    fn finish(self: Box<Self>) -> io::Result<Box<dyn Out + 'o>> {
        (*self).finish()
    }
}

/// The name as GTKWave shows it: a word with its range.
fn ranged(name: &str, width: u32) -> String {
    if width > 1 { format!("{name} [{}:0]", width - 1) } else { name.to_owned() }
}

fn fitting(name: &str) -> io::Result<&str> {
    if name.len() <= LONGEST_NAME {
        return Ok(name);
    }
    let start: String = name.chars().take(40).collect();
    Err(io::Error::new(
        io::ErrorKind::InvalidInput,
        format!("FST holds names of up to {LONGEST_NAME} bytes: `{start}...`"),
    ))
}

fn error(error: FstWriteError) -> io::Error {
    match error {
        FstWriteError::Io(error) => error,
        other => io::Error::other(other),
    }
}
