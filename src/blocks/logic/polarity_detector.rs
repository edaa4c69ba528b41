//! Polarity detector: holds a coefficient as sign and magnitude during a stroke.
//!
//! ```text
//!   word --+--[abs]--<< GUARD--[ held at load ]--> magnitude
//!          +--[sign]-----------[ held at load ]--> negative
//!          +--[|word| too large]-----------------> out_of_range
//! ```

use crate::base::ValueId;
use crate::blocks::{Block, Builder, Description, Kind, Parameter, Parameters, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build).with_check(check);

static DESCRIPTION: Description = Description {
    name: "polarity_detector",
    kind: Kind::Logic,
    summary: "Splits a coefficient into sign and magnitude and holds both during a stroke.",
    doc: "At the end of a tick with `load` = 1 it takes the sign of `word` and its magnitude times 2^GUARD, so that rates \
          stay constant during a stroke whatever the input does (chosen). A magnitude of more than 2^(MAGNITUDE_WIDTH - \
          GUARD) - 1 cannot be a rate: `out_of_range`, combinational, is 1. So -4096 is refused by a 12-bit multiplier. \
          Zero counts as positive; it gives no pulses.",
    source: "US 3,809,868, FIG. 9, polarity detectors 300, 302, 310, 312; the register is chosen",
    parameters: &[
        Parameter { name: "WIDTH", default: 16, min: 2, max: 32, doc: "bits of the coefficient" },
        Parameter { name: "MAGNITUDE_WIDTH", default: 12, min: 1, max: 32, doc: "bits of the rate" },
        Parameter { name: "GUARD", default: 0, min: 0, max: 3, doc: "left shift of the magnitude" },
    ],
    ports: &[
        PortDescription::input("load", Width::BIT, "takes the coefficient"),
        PortDescription::input("word", Width::Param("WIDTH"), "coefficient").signed(),
        PortDescription::output("negative", Width::BIT, "sign of the coefficient held"),
        PortDescription::output("magnitude", Width::Param("MAGNITUDE_WIDTH"), "its magnitude times 2^GUARD"),
        PortDescription::output("out_of_range", Width::BIT, "1 when `word` cannot be taken"),
    ],
    clocked: true,
};

fn check(p: &Parameters) -> Result<(), String> {
    let (width, magnitude, guard) = (p.get("WIDTH"), p.get("MAGNITUDE_WIDTH"), p.get("GUARD"));
    if magnitude > width {
        return Err(format!("a rate of {magnitude} bits never fills from words of {width}: raise WIDTH"));
    }
    if guard >= magnitude {
        return Err(format!("GUARD {guard} leaves no bit of a magnitude of {magnitude}: lower GUARD"));
    }
    Ok(())
}

fn build(b: &mut Builder) {
    let (word, load, guard) = (b.input("word"), b.input("load"), b.count("GUARD"));
    let width = b.count("MAGNITUDE_WIDTH");
    let negative = b.sign(word);
    let opposite = b.negate(word);
    let absolute = b.mux(negative, opposite, word);
    let low = b.slice(absolute, 0, width - guard);
    let rate = if guard > 0 {
        let zeros = b.constant(0, guard);
        b.concat(low, zeros)
    } else {
        low
    };
    let magnitude = keep(b, rate, load);
    b.output("magnitude", magnitude);
    let sign = keep(b, negative, load);
    b.output("negative", sign);
    let above = b.count("WIDTH") - (width - guard);
    let out_of_range = match above {
        0 => b.bit(false),
        above => {
            let rest = b.slice(absolute, width - guard, above);
            b.reduce_or(rest)
        }
    };
    b.output("out_of_range", out_of_range);
}

fn keep(b: &mut Builder, value: ValueId, load: ValueId) -> ValueId {
    let held = b.hold(b.width(value), 0);
    b.load(held, value, load, None)
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    #[test]
    fn sign_and_magnitude_are_taken_at_load_and_kept() {
        for guard in 0..=3 {
            let mut bench = Bench::new("polarity_detector", &[("GUARD", guard)]);
            for word in [0, 1, -1, 300, -300, 511, -511] {
                bench.set_all(&[("word", word), ("load", 1)]);
                assert_eq!(bench.get("out_of_range"), 0);
                bench.tick();
                bench.set_all(&[("word", 77), ("load", 0)]);
                bench.tick();
                assert_eq!(bench.get("magnitude"), word.unsigned_abs() << guard);
                assert_eq!(bench.get("negative"), u64::from(word < 0));
            }
        }
    }

    #[test]
    fn just_the_words_beyond_the_largest_rate_are_out_of_range() {
        for guard in 0..=3 {
            let mut bench = Bench::new("polarity_detector", &[("GUARD", guard)]);
            let most = (1 << (12 - guard)) - 1;
            for (word, refused) in [(most, 0), (-most, 0), (most + 1, 1), (-most - 1, 1), (32767, 1), (-32768, 1)] {
                bench.set("word", word);
                assert_eq!(bench.get("out_of_range"), refused, "{word} with GUARD {guard}");
            }
        }
    }
}
