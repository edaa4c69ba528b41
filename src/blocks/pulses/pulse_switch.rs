//! Pulse switch: directs a pulse to the count-up or to the count-down line.
//!
//! ```text
//!                +---> up_line     when up
//!   pulse --[switch]
//!                +---> down_line   otherwise
//! ```

use crate::blocks::{Block, Builder, Description, Kind, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "pulse_switch",
    kind: Kind::Pulses,
    summary: "Directs pulses to a count-up line or to a count-down line.",
    doc: "up_line = pulse and up; down_line = pulse and not up. Combinational.",
    source: "US 3,809,868, FIG. 9, pulse switches 294, 296 with lines 304, 306, 314, 316",
    parameters: &[],
    ports: &[
        PortDescription::input("pulse", Width::BIT, "pulses to direct"),
        PortDescription::input("up", Width::BIT, "1: to the count-up line"),
        PortDescription::output("up_line", Width::BIT, "pulses that count up"),
        PortDescription::output("down_line", Width::BIT, "pulses that count down"),
    ],
    clocked: false,
};

fn build(b: &mut Builder) {
    let (pulse, up) = (b.input("pulse"), b.input("up"));
    let up_line = b.and(pulse, up);
    b.output("up_line", up_line);
    let down = b.not(up);
    let down_line = b.and(pulse, down);
    b.output("down_line", down_line);
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    #[test]
    fn a_pulse_takes_just_the_line_that_is_selected() {
        let mut bench = Bench::new("pulse_switch", &[]);
        for (pulse, up, lines) in [(0, 0, (0, 0)), (0, 1, (0, 0)), (1, 0, (0, 1)), (1, 1, (1, 0))] {
            bench.set_all(&[("pulse", pulse), ("up", up)]);
            assert_eq!((bench.get("up_line"), bench.get("down_line")), lines);
        }
    }
}
