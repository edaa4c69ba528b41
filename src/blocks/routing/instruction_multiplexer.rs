//! Instruction multiplexer: which words of a memory are the next instruction.

use crate::blocks::{Block, Builder, Description, Kind, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "instruction_multiplexer",
    kind: Kind::Routing,
    summary: "Chooses the words of a memory that stand so many words behind a pointer.",
    doc: "address = pointer + count, modulo 2^16, combinational.",
    source: "US 3,809,868, FIG. 17, multiplexer 504; that it chooses by the memory's address is chosen",
    parameters: &[],
    ports: &[
        PortDescription::input("pointer", Width::Fixed(16), "first word of the instruction set"),
        PortDescription::input("count", Width::Fixed(16), "words of it that have been worked off"),
        PortDescription::output("address", Width::Fixed(16), "first word of the instruction"),
    ],
    clocked: false,
};

fn build(b: &mut Builder) {
    let address = b.add(b.input("pointer"), b.input("count"));
    b.output("address", address);
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    #[test]
    fn the_words_are_counted_from_the_pointer_on() {
        let mut bench = Bench::new("instruction_multiplexer", &[]);
        for (pointer, count, address) in [(0, 0, 0), (100, 8, 108), (32767, 32772, 3)] {
            bench.set_all(&[("pointer", pointer), ("count", count)]);
            assert_eq!(bench.get("address"), address);
        }
    }
}
