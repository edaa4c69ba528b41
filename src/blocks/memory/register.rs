//! Register: a word that changes at the end of a tick when it is told to.
//!
//! ```text
//!           enable  clear
//!              |      |
//!   word ---->[   q    ]---> q
//! ```

use crate::blocks::{Block, Builder, Description, Kind, Parameter, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "register",
    kind: Kind::Memory,
    summary: "Holds a word from one load to the next.",
    doc: "q(t+1) = clear ? 0 : enable ? word : q. Clear wins over enable; 0 at power-on.",
    source: "the register of any textbook: D flip-flops with enable and synchronous clear",
    parameters: &[Parameter { name: "WIDTH", default: 16, min: 1, max: 64, doc: "bits of the word" }],
    ports: &[
        PortDescription::input("word", Width::Param("WIDTH"), "the word to load"),
        PortDescription::input("enable", Width::BIT, "loads the word"),
        PortDescription::input("clear", Width::BIT, "sets all digits to 0; wins over `enable`"),
        PortDescription::output("q", Width::Param("WIDTH"), "the word held"),
    ],
    clocked: true,
};

fn build(b: &mut Builder) {
    let (word, enable, clear) = (b.input("word"), b.input("enable"), b.input("clear"));
    let q = b.hold(b.count("WIDTH"), 0);
    let q = b.load(q, word, enable, clear);
    b.output("q", q);
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    #[test]
    fn the_word_is_loaded_held_and_cleared_and_clear_wins() {
        let mut bench = Bench::new("register", &[("WIDTH", 8)]);
        for (word, enable, clear, q) in [(0xA5, 0, 0, 0), (0xA5, 1, 0, 0xA5), (0x5A, 0, 0, 0xA5), (0x5A, 1, 1, 0)] {
            bench.set_all(&[("word", word), ("enable", enable), ("clear", clear)]);
            bench.tick();
            assert_eq!(bench.get("q"), q);
        }
    }
}
