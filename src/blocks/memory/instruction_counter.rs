//! Instruction counter: how far a set has been worked off, in words.

use crate::blocks::{Block, Builder, Description, Kind, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "instruction_counter",
    kind: Kind::Memory,
    summary: "Counts five words for a curve and three for a positioning move.",
    doc: "count(t+1) = clear ? 0 : count + 5 curve + 3 position. Clear wins; at most one of the others is high.",
    source: "US 3,809,868, FIG. 17, counter 508",
    parameters: &[],
    ports: &[
        PortDescription::input("clear", Width::BIT, "back to the first word"),
        PortDescription::input("curve", Width::BIT, "five words on"),
        PortDescription::input("position", Width::BIT, "three words on"),
        PortDescription::output("count", Width::Fixed(16), "words behind"),
    ],
    clocked: true,
};

fn build(b: &mut Builder) {
    let [five, three] = [("curve", 5), ("position", 3)].map(|(line, words)| {
        let words = b.constant(words, 16);
        b.gate(b.input(line), words)
    });
    let step = b.or(five, three);
    let count = b.hold(16, 0);
    let next = b.add(count.q, step);
    let count = b.load(count, next, None, b.input("clear"));
    b.output("count", count);
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    #[test]
    fn a_curve_is_five_words_a_move_three_and_clear_wins() {
        let mut bench = Bench::new("instruction_counter", &[]);
        for (curve, position, clear, count) in
            [(1, 0, 0, 5), (0, 1, 0, 8), (0, 0, 0, 8), (1, 0, 0, 13), (1, 0, 1, 0), (0, 1, 0, 3), (0, 1, 1, 0)]
        {
            bench.set_all(&[("curve", curve), ("position", position), ("clear", clear)]);
            bench.tick();
            assert_eq!(bench.get("count"), count);
        }
    }
}
