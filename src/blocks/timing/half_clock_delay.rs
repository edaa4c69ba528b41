//! Half-clock delay: a pulse of the first half of a clock comes out in the second half.

use crate::blocks::{Block, Builder, Description, Kind, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "half_clock_delay",
    kind: Kind::Timing,
    summary: "Delays a pulse by half a clock, so that two generators never pulse at once.",
    doc: "held(t+1) = trailing ? pulse : held; out = held and second_half. A pulse of the first half is put out while \
          the clock's pulse of the second half is on, however long that is held.",
    source: "US 3,809,868, FIG. 10, output of multiplier 327 \"delayed 1/2 clock cycle\"",
    parameters: &[],
    ports: &[
        PortDescription::input("pulse", Width::BIT, "pulse in the first half"),
        PortDescription::input("trailing", Width::BIT, "1 in the last tick of a pulse"),
        PortDescription::input("second_half", Width::BIT, "the clock's pulse of the second half"),
        PortDescription::output("out", Width::BIT, "the pulse in the second half"),
    ],
    clocked: true,
};

fn build(b: &mut Builder) {
    let held = b.hold(1, 0);
    b.name("held", held.q);
    b.load(held, b.input("pulse"), b.input("trailing"), None);
    let out = b.and(held.q, b.input("second_half"));
    b.output("out", out);
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    #[test]
    fn a_pulse_of_the_first_half_comes_out_in_the_second_and_only_there() {
        let mut bench = Bench::new("half_clock_delay", &[]);
        // Columns: pulse, trailing, second half, expected output; pulses of two ticks, gaps of one.
        let with_pulse = [(1, 0, 0, 0), (1, 1, 0, 0), (0, 0, 0, 0), (0, 0, 1, 1), (0, 1, 1, 1), (0, 0, 0, 0)];
        let without = [(0, 0, 0, 0), (0, 1, 0, 0), (0, 0, 0, 0), (0, 0, 1, 0), (0, 1, 1, 0), (0, 0, 0, 0)];
        for (pulse, trailing, second_half, out) in with_pulse.into_iter().chain(without) {
            bench.set_all(&[("pulse", pulse), ("trailing", trailing), ("second_half", second_half)]);
            assert_eq!(bench.get("out"), out);
            bench.tick();
        }
    }
}
