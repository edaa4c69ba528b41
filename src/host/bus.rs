//! The bus between computer 552 and the machine of FIG. 18.

use super::Stroke;
use crate::base::{Diagnostic, Report};
use crate::simulation::{Circuit, Input, Net, Run, Session};

/// The machine on the bus.
const CIRCUIT: &str = "us3809868/fig18_processor";

/// Bits of the status word.
const ERROR: u16 = 1 << 15;
const DONE: u16 = 1 << 7;

/// Ticks that no stroke takes: four quarters with the defaults take 131,072.
const LIMIT: u64 = 1 << 28;

/// A run of `us3809868/fig18_processor` as the computer sees it: words go out, the status comes in, nothing else.
///
/// ```
/// use stepwright::host::{Bus, Case};
///
/// let stroke = Case::V { p2: [71.0, 71.0] }.curve([100.0, 0.0], [0.0, 100.0]).and_then(|curve| curve.words());
/// let mut machine = Bus::session()?.parameter("WIDTH", 9).parameter("ENTRIES", 32).parameter("ENTRY_WIDTH", 5).start()?;
/// Bus::of(&mut machine)?.draw(&stroke.expect("it has a solution"))?;
/// let [x, y] = [machine.net("x")?, machine.net("y")?];
/// assert_eq!([machine.read(x), machine.read(y)], [0, 100]);
/// # Ok::<(), stepwright::base::Report>(())
/// ```
pub struct Bus<'r, 'o> {
    run: &'r mut Run<'o>,
    write: Input,
    address: Input,
    data: Input,
    status: Net,
}

impl<'r, 'o> Bus<'r, 'o> {
    /// A session with the machine, to which parameters and the controls of processor 366 may be given.
    ///
    /// # Errors
    /// None: the circuit is shipped.
    pub fn session() -> Result<Session, Report> {
        Ok(Circuit::shipped(CIRCUIT)?.session())
    }

    /// The bus of a run of that machine, whoever looks on.
    ///
    /// # Errors
    /// `S010` or `S012`: the run is one of another circuit, which has no such bus.
    pub fn of(run: &'r mut Run<'o>) -> Result<Self, Report> {
        let [write, address, data] = [run.input("write")?, run.input("address")?, run.input("data")?];
        let status = run.net("status")?;
        Ok(Self { run, write, address, data, status })
    }

    /// Writes a word, which takes a tick.
    ///
    /// # Errors
    /// `S011`: an address above 7.
    pub fn write(&mut self, word: super::Write) -> Result<(), Report> {
        self.run.set(self.address, i64::from(word.address))?;
        self.run.set(self.data, i64::from(word.data))?;
        self.run.set(self.write, 1)?;
        self.run.step(1);
        self.run.set(self.write, 0)
    }

    /// The status word.
    #[must_use]
    pub fn status(&self) -> u16 {
        self.run.word(self.status) as u16
    }

    /// Loads a stroke, starts it, and waits until it is done; how many ticks that took.
    ///
    /// # Errors
    /// `H001` the machine refuses the stroke, or carries X or Y beyond 16 bits; `H002` the run was broken off, or the
    /// stroke does not end.
    pub fn draw(&mut self, stroke: &Stroke) -> Result<u64, Report> {
        let begun = self.run.tick();
        for word in stroke.writes() {
            self.write(word)?;
        }
        if !self.wait() {
            let message = format!("the machine of FIG. 18 is not done with {stroke:?} in tick {}", self.run.tick());
            let help = "the run was broken off, or something else has stopped the machine";
            return Err(Diagnostic::new("H002", message).help(help).into());
        }
        if self.status() & ERROR != 0 {
            let message = format!("the machine of FIG. 18 refuses, or does not end within 16 bits, {stroke:?}");
            let help = "a coefficient is beyond the generator's WIDTH, or X or Y leaves -32768 to 32767 on the way";
            return Err(Diagnostic::new("H001", message).help(help).into());
        }
        Ok(self.run.tick() - begun)
    }

    /// Reads the status, tick by tick, until the stroke is done; whether it came to that.
    fn wait(&mut self) -> bool {
        for _ in 0..LIMIT {
            let tick = self.run.tick();
            if self.status() & DONE != 0 {
                return true;
            }
            self.run.step(1);
            if self.run.tick() == tick {
                break;
            }
        }
        false
    }
}
