//! Presettable memory: a writable table of delay words along the path, with a trapezoid at power-on.
//!
//! ```text
//!   word  ENDS |\_                    _/|
//!              |  \_                _/  |
//!       MIDDLE |    \______________/    |
//!              0   RAMP        BLOCKS-RAMP  BLOCKS   -> address (blocks of pulses travelled)
//! ```

use crate::base::{MemoryImage, MemoryWrite};
use crate::blocks::{Block, Builder, Description, Kind, Parameter, Parameters, PortDescription, Width};

/// The block.
pub struct PresettableMemory;

static DESCRIPTION: Description = Description {
    name: "presettable_memory",
    kind: Kind::Memory,
    summary: "A writable memory of delay words, set to a trapezoid at power-on.",
    doc: "word = m[address], combinational; while `write` is 1, m[write_address] takes `write_word` at the end of the \
          tick. At power-on word i is MIDDLE + (ENDS - MIDDLE) * (RAMP - d) / RAMP, rounded down, where d is the distance \
          of i from the nearer end of the first BLOCKS words, and MIDDLE from d = RAMP on; words from BLOCKS on are ENDS, \
          so that a longer stroke than expected goes on slowly. With RAMP = 0 all of the first BLOCKS words are MIDDLE.",
    source: "US 3,809,868, FIG. 10, presettable memory 347; the trapezoid is chosen",
    parameters: &[
        Parameter { name: "WIDTH", default: 8, min: 1, max: 16, doc: "bits of a word" },
        Parameter { name: "ADDRESS_WIDTH", default: 8, min: 1, max: 12, doc: "bits of an address" },
        Parameter { name: "ENDS", default: 120, min: 0, max: 65535, doc: "word at both ends, in ticks of delay" },
        Parameter { name: "MIDDLE", default: 20, min: 0, max: 65535, doc: "word in the middle, in ticks of delay" },
        Parameter { name: "RAMP", default: 16, min: 0, max: 4096, doc: "words from an end to the middle value" },
        Parameter { name: "BLOCKS", default: 82, min: 1, max: 4096, doc: "words of the whole stroke" },
    ],
    ports: &[
        PortDescription::input("address", Width::Param("ADDRESS_WIDTH"), "word to read"),
        PortDescription::input("write", Width::BIT, "writes a word at the end of the tick"),
        PortDescription::input("write_address", Width::Param("ADDRESS_WIDTH"), "word to write"),
        PortDescription::input("write_word", Width::Param("WIDTH"), "its new value"),
        PortDescription::output("word", Width::Param("WIDTH"), "the word at `address`"),
    ],
    clocked: true,
};

impl Block for PresettableMemory {
    fn description(&self) -> &'static Description {
        &DESCRIPTION
    }

    fn check(&self, p: &Parameters) -> Result<(), String> {
        let largest = p.get("ENDS").max(p.get("MIDDLE"));
        let width = p.get("WIDTH");
        if largest >> width != 0 {
            return Err(format!("a word of {largest} does not fit {width} bits: lower ENDS and MIDDLE or raise WIDTH"));
        }
        Ok(())
    }

    fn build(&self, b: &mut Builder) {
        let words = (0..1 << b.count("ADDRESS_WIDTH")).map(|i| trapezoid(b, i)).collect::<Vec<_>>();
        let image = MemoryImage::from_words(b.count("WIDTH"), words);
        let write =
            MemoryWrite { enable: b.input("write"), address: b.input("write_address"), data: b.input("write_word") };
        let word = b.ram(image, write, b.input("address"));
        b.output("word", word);
    }
}

fn trapezoid(b: &Builder, i: i64) -> u64 {
    let (ends, middle, ramp) = (b.param("ENDS"), b.param("MIDDLE"), b.param("RAMP"));
    let distance = i.min(b.param("BLOCKS") - 1 - i);
    let word = match distance {
        ..0 => ends,
        d if d >= ramp => middle,
        d => middle + ((ends - middle) * (ramp - d)).div_euclid(ramp),
    };
    word as u64
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    #[test]
    fn it_holds_a_trapezoid_at_power_on_and_what_is_written_after() {
        let parameters = [("ADDRESS_WIDTH", 4), ("ENDS", 50), ("MIDDLE", 10), ("RAMP", 4), ("BLOCKS", 11)];
        let mut bench = Bench::new("presettable_memory", &parameters);
        let read = |bench: &mut Bench| -> Vec<u64> {
            (0..16)
                .map(|address| {
                    bench.set("address", address);
                    bench.get("word")
                })
                .collect()
        };
        assert_eq!(read(&mut bench), [50, 40, 30, 20, 10, 10, 10, 20, 30, 40, 50, 50, 50, 50, 50, 50]);
        bench.set_all(&[("write", 1), ("write_address", 5), ("write_word", 200)]);
        bench.tick();
        assert_eq!(read(&mut bench)[4..7], [10, 200, 10]);
    }
}
