//! Reference source: a constant word.

use crate::base::word::encode;
use crate::blocks::{Block, Builder, Description, Kind, Parameter, Parameters, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build).with_check(check);

static DESCRIPTION: Description = Description {
    name: "reference",
    kind: Kind::Arithmetic,
    summary: "Gives a constant word.",
    doc: "value = VALUE, always, in two's complement. A real number r with f fraction bits is written as the whole number \
          nearest to r * 2^f.",
    source: "US 3,809,868, FIG. 4A to 8 (references 111, 118, 126, 190, 196, 200, 204, 214, 218, 256 and 1/sqrt 2)",
    parameters: &[
        Parameter { name: "WIDTH", default: 16, min: 1, max: 63, doc: "bits of the word" },
        Parameter { name: "VALUE", default: 1, min: -(1 << 62), max: (1 << 62) - 1, doc: "the constant" },
    ],
    ports: &[PortDescription::output("value", Width::Param("WIDTH"), "the constant").signed()],
    clocked: false,
};

fn check(parameters: &Parameters) -> Result<(), String> {
    let (width, value) = (parameters.get("WIDTH"), parameters.get("VALUE"));
    match encode(value.into(), width as u32, true) {
        Some(_) => Ok(()),
        None => Err(format!("VALUE is {value}, which does not fit {width} bits with a sign: widen WIDTH")),
    }
}

fn build(b: &mut Builder) {
    let (value, width) = (b.param("VALUE"), b.count("WIDTH"));
    let value = b.constant(value as u64, width);
    b.output("value", value);
}

#[cfg(test)]
mod tests {
    use crate::blocks::Parameters;
    use crate::blocks::bench::Bench;

    #[test]
    fn it_gives_its_value_with_either_sign() {
        for (width, value) in [(16, 1), (3, -1), (2, -2), (63, (1 << 62) - 1)] {
            let bench = Bench::new("reference", &[("WIDTH", width), ("VALUE", value)]);
            assert_eq!(bench.get_signed("value"), value);
        }
    }

    #[test]
    fn a_value_that_does_not_fit_is_refused() {
        let mut parameters = Parameters::defaults(&super::DESCRIPTION);
        parameters.set("WIDTH", 3);
        for (value, fits) in [(3, true), (4, false), (-4, true), (-5, false)] {
            parameters.set("VALUE", value);
            assert_eq!(super::BLOCK.check(&parameters).is_ok(), fits, "{value}");
        }
    }
}
