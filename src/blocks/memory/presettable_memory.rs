//! Presettable memory: a writable table of delay words along the path, with a trapezoid at power-on.
//!
//! ```text
//!   word  ENDS |.                      .|
//!              | .                    . |
//!       MIDDLE |   ..................   |
//!              0   RAMP     BLOCKS-RAMP   BLOCKS   -> address (blocks of pulses travelled)
//! ```

use crate::base::{MemoryImage, MemoryWrite};
use crate::blocks::{Block, Builder, Description, Kind, Parameter, Parameters, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build).with_check(check);

static DESCRIPTION: Description = Description {
    name: "presettable_memory",
    kind: Kind::Memory,
    summary: "A writable memory of delay words, set to a trapezoid at power-on.",
    doc: "word = m[address], combinational; while `write` is 1, m[write_address] takes `write_word` at the end of the \
          tick. At power-on the words are the delays of a speed that is a trapezoid over time: along each ramp the square \
          of the speed 1/word grows evenly with the way, which is constant acceleration. Word i, d words from the nearer \
          end of the first BLOCKS, is (1/ENDS^2 + (1/MIDDLE^2 - 1/ENDS^2) d / RAMP)^(-1/2), rounded, for d < RAMP and \
          MIDDLE from there on. Words from BLOCKS on are ENDS, so that a longer stroke than expected goes on slowly.",
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

fn check(p: &Parameters) -> Result<(), String> {
    let largest = p.get("ENDS").max(p.get("MIDDLE"));
    let width = p.get("WIDTH");
    if largest >> width != 0 {
        return Err(format!("a word of {largest} does not fit {width} bits: lower ENDS and MIDDLE or raise WIDTH"));
    }
    Ok(())
}

fn build(b: &mut Builder) {
    let words: Vec<_> = (0..1 << b.count("ADDRESS_WIDTH")).map(|i| power_on_word(b, i)).collect();
    let image = MemoryImage::from_words(b.count("WIDTH"), words);
    let write =
        MemoryWrite { enable: b.input("write"), address: b.input("write_address"), data: b.input("write_word") };
    let word = b.ram(image, write, b.input("address"));
    b.output("word", word);
}

fn power_on_word(b: &Builder, i: i64) -> u64 {
    let ramp = b.count("RAMP").into();
    let [ends, middle] = ["ENDS", "MIDDLE"].map(|name| b.count(name).into());
    let distance = i.min(b.param("BLOCKS") - 1 - i);
    match u128::try_from(distance) {
        Err(_) | Ok(0) if ramp > 0 || distance < 0 => ends as u64,
        Ok(d) if d < ramp => on_ramp(ends, middle, d, ramp),
        _ => middle as u64,
    }
}

/// The word `d` of `ramp` words from an end, by whole numbers: the largest w with (2w - 1)^2 <= 4 word^2.
fn on_ramp(ends: u128, middle: u128, d: u128, ramp: u128) -> u64 {
    let above = 4 * (ends * middle).pow(2) * ramp;
    let below = middle.pow(2) * (ramp - d) + ends.pow(2) * d;
    let doubled = (above.checked_div(below).unwrap_or(0)).isqrt();
    doubled.div_ceil(2) as u64
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
        // 1/50^2 + (1/10^2 - 1/50^2) d/4 for d = 0 .. 3 is 0.0004, 0.0028, 0.0052, 0.0076.
        assert_eq!(read(&mut bench), [50, 19, 14, 11, 10, 10, 10, 11, 14, 19, 50, 50, 50, 50, 50, 50]);
        bench.set_all(&[("write", 1), ("write_address", 5), ("write_word", 200)]);
        bench.tick();
        assert_eq!(read(&mut bench)[4..7], [10, 200, 10]);
    }

    #[test]
    fn the_ramps_are_those_of_constant_acceleration() {
        for (ends, middle, ramp) in [(120_i64, 20_i64, 16_i64), (120, 12, 24), (200, 1, 60), (10, 90, 20), (80, 0, 5)] {
            let parameters = [("ENDS", ends), ("MIDDLE", middle), ("RAMP", ramp), ("BLOCKS", 200)];
            let mut bench = Bench::new("presettable_memory", &parameters);
            for d in 0..ramp {
                let square = |word: i64| (word as f64).powi(-2);
                let speed = square(ends) + (square(middle) - square(ends)) * (d as f64 / ramp as f64);
                let exact = if d == 0 { ends as f64 } else { speed.powf(-0.5) };
                for address in [d, 199 - d] {
                    bench.set("address", address);
                    assert!((bench.get("word") as f64 - exact).abs() <= 0.5 + 1e-9, "word {address}: {exact}");
                }
            }
        }
    }
}
