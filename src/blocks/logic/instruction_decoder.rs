//! Instruction decoder: which motion a control word asks for.

use crate::base::ValueId;
use crate::blocks::{Block, Builder, Description, Kind, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "instruction_decoder",
    kind: Kind::Logic,
    summary: "Tells a curve, a positioning move and an exit by their control word.",
    doc: "curve: control = 1 and all five words are there (count = 5); position: control = 2 and three are there; exit: \
          control = 3 and it is there. Any other control word is undefined, and so is an instruction that the end of \
          the memory cuts off: no line is high. Combinational.",
    source: "US 3,809,868, FIG. 17, decoder 505; the numbers of the control words are chosen",
    parameters: &[],
    ports: &[
        PortDescription::input("control", Width::Fixed(16), "control word C"),
        PortDescription::input("count", Width::Fixed(3), "words of the instruction inside the memory, 0 to 5"),
        PortDescription::output("curve", Width::BIT, "J, K, L, M follow"),
        PortDescription::output("position", Width::BIT, "X, Y follow"),
        PortDescription::output("exit", Width::BIT, "the end of the set"),
    ],
    clocked: false,
};

fn build(b: &mut Builder) {
    for (line, control, words) in [("curve", 1, 5), ("position", 2, 3), ("exit", 3, 1)] {
        let named = b.is(b.input("control"), control);
        let whole = at_least(b, b.input("count"), words);
        let high = b.and(named, whole);
        b.output(line, high);
    }
}

fn at_least(b: &mut Builder, count: ValueId, least: u64) -> ValueId {
    let least = b.constant(least, b.width(count));
    let fewer = b.less(count, least);
    b.not(fewer)
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    #[test]
    fn three_control_words_are_defined_and_only_where_their_instruction_is_whole() {
        let mut bench = Bench::new("instruction_decoder", &[]);
        for control in (0..300).chain([0x0101, 0x8001, 0xFFFD, 0xFFFF]) {
            for count in 0..=5 {
                bench.set_all(&[("control", control), ("count", count)]);
                let lines = ["curve", "position", "exit"].map(|line| bench.get(line));
                let expected = match (control, count) {
                    (1, 5) => [1, 0, 0],
                    (2, 3..) => [0, 1, 0],
                    (3, 1..) => [0, 0, 1],
                    _ => [0, 0, 0],
                };
                assert_eq!(lines, expected, "control {control}, {count} words");
            }
        }
    }
}
