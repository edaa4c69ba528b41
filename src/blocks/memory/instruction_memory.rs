//! Instruction memory: strokes, positions and exits of characters, five words at a time.
//!
//! ```text
//!   address --->[ words of 16 bits ]---> control, word_1 .. word_4, count
//! ```

use super::glyphs::{INSTRUCTIONS, WORD};
use crate::base::ValueId;
use crate::blocks::{Block, Builder, Description, Kind, Parameter, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build).with_image(&INSTRUCTIONS);

/// The parameter that names the image.
pub(super) const IMAGE: Parameter = Parameter {
    name: "IMAGE",
    default: 0,
    min: 0,
    max: i64::MAX,
    doc: "name of a `.glyphs` file beside the circuit, without the ending, at most 8 letters: \"letters\"; 0 for none",
};

static DESCRIPTION: Description = Description {
    name: "instruction_memory",
    kind: Kind::Memory,
    summary: "Holds the instruction sets of characters and shows five words of them.",
    doc: "control, word_1 .. word_4 = the words at address, address + 1 .. address + 4, combinational; 0 beyond the last \
          word. `count` is how many of the five are inside the memory. An instruction is a control word and what \
          follows it: 1 a curve: J, K, L, M; 2 a positioning move: X, Y; 3 the exit. The words come from a text file, \
          see `docs/characters.md`.",
    source: "US 3,809,868, FIG. 17, memory 502; the numbers of the control words are chosen",
    parameters: &[IMAGE],
    ports: &[
        PortDescription::input("address", Width::Fixed(WORD), "address of the first word"),
        PortDescription::output("control", Width::Fixed(WORD), "control word C"),
        PortDescription::output("word_1", Width::Fixed(WORD), "J, or X").signed(),
        PortDescription::output("word_2", Width::Fixed(WORD), "K, or Y").signed(),
        PortDescription::output("word_3", Width::Fixed(WORD), "L of a curve").signed(),
        PortDescription::output("word_4", Width::Fixed(WORD), "M of a curve").signed(),
        PortDescription::output("count", Width::Fixed(3), "words inside the memory, 0 to 5"),
    ],
    clocked: false,
};

fn build(b: &mut Builder) {
    let mut count = b.constant(0, 3);
    let image = b.image();
    for (offset, name) in (0..).zip(["control", "word_1", "word_2", "word_3", "word_4"]) {
        let Some(image) = &image else {
            let nothing = b.constant(0, WORD);
            b.output(name, nothing);
            continue;
        };
        let depth = image.depth() as u64;
        let address = after(b, offset);
        let word = b.rom(image.clone(), address);
        b.output(name, word);
        let end = b.constant(depth, WORD + 1);
        let inside = b.less(address, end);
        let inside = b.zero_extend(inside, 3);
        count = b.add(count, inside);
    }
    b.output("count", count);
}

/// So many words after the address, in one bit more.
fn after(b: &mut Builder, words: u64) -> ValueId {
    let address = b.zero_extend(b.input("address"), WORD + 1);
    let words = b.constant(words, WORD + 1);
    b.add(address, words)
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    const WORDS: [&str; 5] = ["control", "word_1", "word_2", "word_3", "word_4"];

    fn show(bench: &mut Bench, address: i64) -> ([i64; 5], u64) {
        bench.set("address", address);
        (WORDS.map(|word| i64::from(bench.get(word) as i16)), bench.get("count"))
    }

    #[test]
    fn it_shows_five_words_from_any_address_and_says_how_many_there_are() {
        let text = "glyph 41 A\n move 10 20\n line 13 16\n arc 20 20 5 -7\n advance 30";
        let mut bench = Bench::with_image("instruction_memory", &[], text);
        // J = 20 - 5, K = 20 - 13, L = 20 + 7, M = 20 - 16.
        let words = [2, 10, 20, 1, 0, 3, 0, -4, 1, 15, 7, 27, 4, 2, 30, 0, 3];
        for address in 0..20 {
            let word = |at: usize| words.get(at).copied().unwrap_or(0);
            let expected = [0, 1, 2, 3, 4].map(|offset| word(address + offset));
            let count = (words.len().saturating_sub(address)).min(5) as u64;
            assert_eq!(show(&mut bench, address as i64), (expected, count), "address {address}");
        }
        assert_eq!(show(&mut bench, 65535), ([0; 5], 0), "addresses do not wrap");
    }

    #[test]
    fn without_an_image_it_holds_no_word() {
        assert_eq!(show(&mut Bench::new("instruction_memory", &[]), 0), ([0; 5], 0));
    }
}
