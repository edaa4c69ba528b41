//! A stroke in the words of FIG. 18, and the writes that load it.

/// The largest magnitude of J, K, L, M that the generator of `us3809868/fig18_processor` draws: 12 bits.
pub const LARGEST: i16 = 4095;

/// Addresses on the bus of `us3809868/fig18_processor`: registers 556 (J) to 562 (M), 564 (X0) and 566 (Y0) are 0 to 5.
pub(super) const COMMAND: u8 = 6;

/// A stroke as the registers of processor 554 hold it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Stroke {
    /// X0, Y0, in counts.
    pub from: [i16; 2],
    /// J, K, L, M, in counts, at most [`LARGEST`] in magnitude.
    pub jklm: [i16; 4],
    /// 1 to 4.
    pub quarters: u8,
    /// Whether the stroke is drawn, or the pen only moved.
    pub pen: bool,
}

/// A word that the computer puts on the bus.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Write {
    /// 0 to 7.
    pub address: u8,
    /// 16 bits.
    pub data: u16,
}

impl Stroke {
    /// Where the machine ends it, in counts; beyond 16 bits the generator tells an error.
    #[must_use]
    pub fn end(&self) -> [i32; 2] {
        let [j, k, l, m] = self.jklm.map(i32::from);
        let end = |from: i16, cosine: i32, sine: i32| {
            i32::from(from)
                + match self.quarters {
                    1 => sine - cosine,
                    2 => -2 * cosine,
                    3 => -cosine - sine,
                    _ => 0,
                }
        };
        [end(self.from[0], j, k), end(self.from[1], l, m)]
    }

    /// The command word that starts it: bit 0 start, bits 2 and 3 quarters less one, bit 4 without its mark.
    #[must_use]
    pub fn command(&self) -> u16 {
        let quarters = u16::from(self.quarters.clamp(1, 4)) - 1;
        1 | quarters << 2 | u16::from(!self.pen) << 4
    }

    /// What the computer writes: the six registers, then the command.
    #[must_use]
    pub fn writes(&self) -> [Write; 7] {
        let ([j, k, l, m], [x0, y0]) = (self.jklm, self.from);
        let words = [j, k, l, m, x0, y0].map(|word| word as u16);
        std::array::from_fn(|at| match words.get(at) {
            Some(&data) => Write { address: at as u8, data },
            None => Write { address: COMMAND, data: self.command() },
        })
    }
}
