//! Pointer table: from a character's code to the address of its instruction set.
//!
//! ```text
//!   code --->[ 256 pointers ]---> pointer, known
//! ```

use super::glyphs::{POINTERS, WORD};
use crate::blocks::{Block, Builder, Description, Kind, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build).with_image(&POINTERS);

static DESCRIPTION: Description = Description {
    name: "pointer_table",
    kind: Kind::Memory,
    summary: "Gives the address of the instruction set of each character.",
    doc: "pointer = the address of the set of the character `code` in an `instruction_memory` of the same image; `known` \
          is 1 when the image has such a character, and the pointer is 0 otherwise. Combinational.",
    source: "US 3,809,868, FIG. 17, pointer table 500",
    parameters: &[super::instruction_memory::IMAGE],
    ports: &[
        PortDescription::input("code", Width::Fixed(8), "code of a character"),
        PortDescription::output("pointer", Width::Fixed(WORD), "address of its instruction set"),
        PortDescription::output("known", Width::BIT, "there is such a character"),
    ],
    clocked: false,
};

fn build(b: &mut Builder) {
    let entry = match b.image() {
        Some(image) => b.rom(image, b.input("code")),
        None => b.constant(0, WORD + 1),
    };
    let (pointer, known) = (b.slice(entry, 0, WORD), b.sign(entry));
    b.output("pointer", pointer);
    b.output("known", known);
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    #[test]
    fn each_code_points_to_its_set_and_two_may_share_one() {
        let text = "glyph 41 A C0 \u{410}\n move 1 2\n advance 9\nglyph FF x\n advance 3\nglyph 00 y\n advance -1";
        let mut bench = Bench::with_image("pointer_table", &[], text);
        let known: Vec<_> = (0..256)
            .filter_map(|code| {
                bench.set("code", code);
                (bench.get("known") == 1).then(|| (code, bench.get("pointer")))
            })
            .collect();
        assert_eq!(known, [(0x00, 11), (0x41, 0), (0xC0, 0), (0xFF, 7)]);
    }

    #[test]
    fn without_an_image_no_character_is_known() {
        let mut bench = Bench::new("pointer_table", &[]);
        for code in [0, 0x41, 255] {
            bench.set("code", code);
            assert_eq!((bench.get("known"), bench.get("pointer")), (0, 0));
        }
    }
}
